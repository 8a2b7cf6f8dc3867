//! Whether steady rotation lasts under a torque on the bit that falls with its speed.
//!
//! A bit that turns at ω under a torque T(ω) whose slope is −κ answers a small change of its
//! speed with a change of torque that drives it on: δω = κ Y(s) δω, with Y the response of the
//! bit's speed to a torque on it. A passive Y starts at s = iω from no slope, and the first slope
//! at which a small vibration neither grows nor dies away is 1/κ = Y(iω), where Y is real: the
//! least κ belongs to the largest real Y (Nyquist). Each mode has one near its frequency, and it
//! need not be the lowest that is largest: vibration at which pipe and tool joints let no wave through
//! stays in the collars, and the little damping there is what it loses.
//!
//! A uniform string without a drive bears a fall of Z tanh(c_t L/2Z), with Z its impedance:
//!
//! ```
//! use linear::estimates::torsional_impedance;
//! use linear::falling_torque::steepest_fall;
//! use linear::{Drillstring, Material, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.05, outer_radius: 0.08 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.2)?;
//! let impedance = torsional_impedance(&string, &pipe);
//! let expected = impedance * (0.5 * 0.2 * 1000.0 / impedance).tanh();
//! let found = steepest_fall(&string, 20.0)?.ok_or("the string swings")?;
//! assert!((found / expected - 1.0).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use num_complex::Complex64;

use crate::drillstring::Drillstring;
use crate::error::DrillstringError;
use crate::estimates::torsional_travel_time;
use crate::sites::Sites;
use crate::waves::network::TorsionNetwork;

/// Frequencies at which the response is sampled, per mode of a uniform string. Its phase turns
/// evenly along frequency, also at sharp resonances.
const PER_MODE: f64 = 12.0;

/// Halvings of the bracket of a frequency.
const HALVINGS: usize = 60;

/// Modes of a uniform string of the same travel time that count, where loss does not depend on
/// frequency. What collars do by themselves, at tens of hertz, mud and steel damp more than
/// `torsional_damping` says.
const SLOW_MODES: f64 = 24.0;

/// Of a string whose loss does, all modes up to this, Hz.
pub const HIGHEST_FREQUENCY: f64 = 1000.0;

/// Up to which frequency (Hz) vibration of a string counts: as far as its loss is known.
pub fn highest_frequency(string: &Drillstring) -> f64 {
    if string.loss().has_memory() {
        return HIGHEST_FREQUENCY;
    }
    0.5 * SLOW_MODES / torsional_travel_time(string)
}

/// A vibration that a torque which falls with the bit's speed can feed: at its frequency the bit's
/// speed is in phase with a torque on it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Resonance {
    /// Hz.
    pub frequency: f64,
    /// Speed of the bit per torque on it there, rad/s per N m.
    pub mobility: f64,
}

impl Resonance {
    /// The steepest fall κ of the torque with speed under which it dies away, N m s/rad.
    pub fn steepest_fall(&self) -> f64 {
        self.mobility.recip()
    }
}

/// The steepest fall κ of the torque on the bit with its speed, N m s/rad, under which steady
/// rotation of a string still lasts: below it every small vibration up to a frequency, Hz, dies
/// away. `None` where nothing swings.
///
/// # Errors
/// Where the string cannot be cut up.
pub fn steepest_fall(
    string: &Drillstring,
    highest_frequency: f64,
) -> Result<Option<f64>, DrillstringError> {
    let resonances = resonances(string, highest_frequency)?.into_iter();
    Ok(resonances.map(|it| it.steepest_fall()).reduce(f64::min))
}

/// All resonances of a string at its bit up to a frequency, Hz, from the slowest on.
///
/// # Errors
/// Where the string cannot be cut up.
pub fn resonances(
    string: &Drillstring,
    highest_frequency: f64,
) -> Result<Vec<Resonance>, DrillstringError> {
    let network = TorsionNetwork::new(string, &Sites::bit())?;
    let response = |frequency: f64| network.at_frequency(frequency).from_torque[(0, 0)];
    // Modes of a uniform string are half a reciprocal of the travel time apart.
    let apart = 0.5 / torsional_travel_time(string) / PER_MODE;
    let count = (highest_frequency / apart).ceil() as usize;
    let mut found = Vec::new();
    let mut before = (apart, response(apart));
    for place in 2..=count {
        let frequency = apart * place as f64;
        let here = (frequency, response(frequency));
        // A resonance passes from ahead to behind; elsewhere the response is small where real.
        if before.1.im > 0.0 && here.1.im <= 0.0 {
            found.push(real_between(&response, before.0, here.0));
        }
        before = here;
    }
    Ok(found)
}

/// The response where its imaginary part passes from above to below zero.
fn real_between(response: &impl Fn(f64) -> Complex64, mut from: f64, mut to: f64) -> Resonance {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (from + to);
        if response(middle).im > 0.0 {
            from = middle;
        } else {
            to = middle;
        }
    }
    let frequency = 0.5 * (from + to);
    Resonance {
        frequency,
        mobility: response(frequency).re,
    }
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
            let found = steepest_fall(&string, 40.0).unwrap().unwrap();
            assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
        }
    }
}
