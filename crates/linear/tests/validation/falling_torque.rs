//! The steepest fall of the torque on the bit that smooth rotation bears, on random strings.

use std::f64::consts::TAU;

use linear::estimates::torsional_decay_rate;
use linear::falling_torque::steepest_fall;
use linear::waves::network::TorsionNetwork;
use linear::{Drillstring, Sites};
use problems::wells::{Draw, Well};

/// The highest frequency examined, Hz.
const HIGHEST: f64 = 400.0;

/// The largest real response by a scan that resolves every resonance by itself.
fn largest_real(string: &Drillstring) -> f64 {
    let network = TorsionNetwork::new(string, &Sites::bit()).unwrap();
    let half_width = torsional_decay_rate(string) / TAU;
    let count = (HIGHEST / (0.03 * half_width)) as usize;
    let values = (1..count).map(|place| {
        let frequency = HIGHEST * place as f64 / count as f64;
        network.at_frequency(frequency).from_torque[(0, 0)]
    });
    let values: Vec<_> = values.collect();
    let resonances = (values.windows(2)).filter(|ends| ends[0].im > 0.0 && ends[1].im <= 0.0);
    let real = resonances.map(|ends| ends[0].re.max(ends[1].re));
    real.fold(0.0, f64::max)
}

#[test]
fn val_no_frequency_of_a_dense_scan_bears_less() {
    for number in 0..12 {
        let string = Well::draw(number, &mut Draw::new(number)).string;
        let found = steepest_fall(&string, HIGHEST).unwrap().unwrap();
        let ratio = found * largest_real(&string);
        assert!((ratio - 1.0).abs() < 0.01, "{number}: {ratio}");
    }
}
