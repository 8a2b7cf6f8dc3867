//! Whether steady rotation lasts under a torque on the bit that falls with its speed.
//!
//! A bit that turns at ω under a torque T(ω) whose slope is −κ answers a small change of its
//! speed with a change of torque that drives it on: δω = κ Y(s) δω, with Y the response of the
//! bit's speed to a torque on it. A passive Y starts at s = iω from no slope, and the first slope at which
//! a small vibration neither grows nor dies away is 1/κ = Y(iω), where Y is real: the least κ
//! belongs to the largest real Y (Nyquist). Each mode has one, near its frequency.

use num_complex::Complex64;

use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::modes::torsional_modes;
use crate::sites::Sites;
use crate::waves::network::TorsionNetwork;

/// Modes that are looked at. Uniform damping leaves higher ones much alike; a drive damps the
/// lowest only.
const MODES: usize = 24;

/// Frequencies about that of a mode at which the response is looked at, to either side,
const NEAR: i32 = 40;

/// and how far apart they are, in half-widths of the mode's resonance.
const APART: f64 = 0.25;

/// Halvings of the bracket of a frequency.
const HALVINGS: usize = 60;

/// The steepest fall κ of the torque on the bit with its speed, N m s/rad, under which steady
/// rotation of a string still lasts: below it every small vibration of the lowest 24 modes dies
/// away. `None` where no mode swings.
///
/// # Errors
/// Where the modes cannot be found.
pub fn steepest_fall(string: &Drillstring) -> Result<Option<f64>, BuildError> {
    let network = TorsionNetwork::new(string, &Sites::bit())?;
    let response = |frequency: f64| {
        let s = Complex64::new(0.0, frequency);
        network.admittance(s).from_torque[(0, 0)]
    };
    let modes = torsional_modes(string, MODES)?;
    let largest = (modes.iter())
        .filter_map(|mode| largest_real_near(&response, mode.pole))
        .fold(0.0, f64::max);
    Ok((largest > 0.0).then(|| 1.0 / largest))
}

/// The largest response near a pole that is real.
fn largest_real_near(response: &impl Fn(f64) -> Complex64, pole: Complex64) -> Option<f64> {
    let half_width = -pole.re;
    let frequencies = (-NEAR..=NEAR)
        .map(|place| pole.im + APART * half_width * f64::from(place))
        .filter(|frequency| *frequency > 0.0);
    let values: Vec<(f64, Complex64)> = frequencies.map(|it| (it, response(it))).collect();
    let real = values.windows(2).filter_map(|ends| {
        let [(from, one), (to, other)] = [ends[0], ends[1]];
        // A resonance passes from ahead to behind; at other zeros the response is small.
        (one.im > 0.0 && other.im <= 0.0).then(|| real_between(response, from, to))
    });
    real.reduce(f64::max)
}

/// The response where its imaginary part passes from above to below zero.
fn real_between(response: &impl Fn(f64) -> Complex64, mut from: f64, mut to: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (from + to);
        if response(middle).im > 0.0 {
            from = middle;
        } else {
            to = middle;
        }
    }
    response(0.5 * (from + to)).re
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Material, Section, Tube};

    fn uniform(damping: f64) -> Drillstring {
        let steel = Material {
            shear_modulus: 80e9,
            density: 7840.0,
        };
        let tube = Tube {
            length: 1000.0,
            inner_radius: 0.05,
            outer_radius: 0.08,
        };
        let section = Section {
            repeat: 1,
            parts: vec![tube],
        };
        Drillstring::new(steel, vec![section], damping).unwrap()
    }

    /// Without a drive Y = tanh(γL)/Z, at resonance 1/(Z tanh(αL)) with the impedance Z and
    /// αL = c_t L/(2Z), as long as damping is light.
    #[test]
    fn a_uniform_tube_bears_the_fall_that_its_damping_makes_up_for() {
        for damping in [0.05, 0.2] {
            let string = uniform(damping);
            let tube = string.sections()[0].parts[0];
            let impedance = crate::estimates::torsional_impedance(&string, &tube);
            let loss = 0.5 * damping * 1000.0 / impedance;
            let expected = impedance * loss.tanh();
            let found = steepest_fall(&string).unwrap().unwrap();
            assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
        }
    }

    /// A dense scan of the response finds no larger real value up to the modes looked at.
    #[test]
    fn no_frequency_of_a_dense_scan_bears_less() {
        let pipe = Section {
            repeat: 100,
            parts: vec![
                Tube {
                    length: 9.0,
                    inner_radius: 0.05,
                    outer_radius: 0.065,
                },
                Tube {
                    length: 0.5,
                    inner_radius: 0.045,
                    outer_radius: 0.085,
                },
            ],
        };
        let collar = Section {
            repeat: 1,
            parts: vec![Tube {
                length: 120.0,
                inner_radius: 0.04,
                outer_radius: 0.1,
            }],
        };
        let material = uniform(0.0).material();
        let string = Drillstring::new(material, vec![pipe, collar], 0.2).unwrap();
        let found = steepest_fall(&string).unwrap().unwrap();
        let network = TorsionNetwork::new(&string, &Sites::bit()).unwrap();
        let highest = torsional_modes(&string, MODES)
            .unwrap()
            .last()
            .unwrap()
            .pole
            .im;
        let count = 200_000;
        let values = (1..count).map(|place| {
            let s = Complex64::new(0.0, highest * f64::from(place) / f64::from(count));
            network.admittance(s).from_torque[(0, 0)]
        });
        let values: Vec<Complex64> = values.collect();
        let real = values
            .windows(2)
            .filter(|ends| ends[0].im > 0.0 && ends[1].im <= 0.0);
        let largest = real
            .map(|ends| ends[0].re.max(ends[1].re))
            .fold(0.0, f64::max);
        assert!((found * largest - 1.0).abs() < 1e-3, "{found} {largest}");
    }
}
