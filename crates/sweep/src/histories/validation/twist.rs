//! The twist of a string whose bit swings.

use crate::histories::phases::twist;

/// The bit turns with speed 1 − cos t below a surface that turns with 1: the string is twisted
/// by sin t.
#[test]
fn val_the_twist_is_the_integral_of_the_difference_of_speeds() {
    let times: Vec<f64> = (0..=1000).map(|step| 1e-2 * f64::from(step)).collect();
    let bit: Vec<f64> = times.iter().map(|time| 1.0 - time.cos()).collect();
    let found = twist(&times, &vec![1.0; times.len()], &bit);
    for (twist, time) in found.iter().zip(&times) {
        assert!((twist - time.sin()).abs() < 1e-5, "{twist} at {time}");
    }
}
