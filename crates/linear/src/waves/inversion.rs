//! From a Laplace transform back to time, without any time step of a scheme.

use faer::c64;
use rayon::prelude::*;

use crate::filters::inverse_transform;

/// What a function does after the last time asked for folds back onto the first,
/// this many times weaker in natural logarithm: e⁻²³ = 1e-10.
const FOLDED: f64 = 23.0;

/// The time function whose Laplace transform is `transform`, at `k · step` (s) for
/// `k < count`, by the trapezoidal rule along Re s = const: exact but for what the
/// function is after `count` steps, damped e²³ times, and for the frequencies above
/// `oversampling / 2` a step. `count` times `oversampling` is even.
pub fn time_response(
    transform: impl Fn(c64) -> c64 + Sync,
    step: f64,
    count: usize,
    oversampling: usize,
) -> Vec<f64> {
    let period = count as f64 * step;
    let shift = FOLDED / period;
    let samples = count * oversampling;
    let mut spectrum: Vec<c64> = (0..=samples / 2)
        .into_par_iter()
        .map(|index| {
            let rate = std::f64::consts::TAU * index as f64 / period;
            transform(c64::new(shift, rate))
        })
        .collect();
    let values = inverse_transform(&mut spectrum, samples);
    let scale = samples as f64 / period;
    (0..count)
        .map(|index| {
            let growth = (shift * index as f64 * step).exp();
            values[index * oversampling] * scale * growth
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_function_comes_back_from_its_transform() {
        // t³ e^(−t), whose transform is 6 / (s + 1)⁴.
        let found = time_response(|s| 6.0 / (s + 1.0).powi(4), 0.25, 64, 32);
        for (index, found) in found.iter().enumerate().take(48) {
            let time = 0.25 * index as f64;
            let exact = time.powi(3) * (-time).exp();
            assert!((found - exact).abs() < 1e-5, "{time}: {found} {exact}");
        }
    }
}
