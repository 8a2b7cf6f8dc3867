//! What a delay in its controller costs a top drive.
//!
//! A drive that answers to its speed of a time τ ago has the impedance
//! s J + (K_p + K_i/s) e^(−s τ), whose real part is K_p cos ωτ − (K_i/ω) sin ωτ: beyond a quarter of
//! the frequency 1/τ it gives where it should take. Where it makes up for an inertia J_l by an acceleration that is as
//! old, it opposes s J_l (1 − e^(−s τ)) more. Whether the string takes more than that is
//! counted: with Z that of the string at its surface, below a bit that is free, and Z₀ that of the
//! drive without delay, the roots that grow are those of
//!
//! Q(s) = (Z + Z_drive)/(Z + Z₀) = 0,
//!
//! for without delay none grows. Where the inertia outweighs all else Q tends to 1 + (1 − e^(−s τ)) J_l/J, whose real part
//! is positive, so their number is −1/π times the change of arg Q(iω) from ω = 0 to ∞ (Nyquist).
//!
//! A rotor alone under K_p gains from a quarter of a period on, τ = π J/(2 K_p):
//!
//! ```
//! use linear::drive_delay::{growing_roots, longest_delay};
//! use linear::{Drillstring, Material, Section, TopDrive, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let tube = Tube { length: 1.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let stub = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![tube] }], 0.1)?;
//! let drive = |delay: f64| TopDrive {
//!     inertia: 2000.0,
//!     proportional_gain: 4e4,
//!     integral_gain: 0.0,
//!     delay,
//!     late_inertia: 0.0,
//! };
//! let below = |delay: f64| stub.clone().with_top_drive(drive(delay));
//! let longest = longest_delay(&below(0.01)?)?.ok_or("it is found")?;
//! assert!((longest / (std::f64::consts::FRAC_PI_2 * 2000.0 / 4e4) - 1.0).abs() < 2e-3);
//! assert_eq!(growing_roots(&below(0.9 * longest)?)?, Some(0));
//! assert_eq!(growing_roots(&below(1.1 * longest)?)?, Some(2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use num_complex::Complex64;

use crate::assembly::torsion::torque_at_surface;
use crate::drillstring::Drillstring;
use crate::error::DrillstringError;
use crate::estimates::torsional_travel_time;
use crate::sites::Sites;
use crate::top_drive::TopDrive;
use crate::waves::network::TorsionNetwork;

/// Samples from one natural frequency of the string to the next.
const SAMPLES: f64 = 40.0;

/// More than this many are not made: some seconds of work.
const MOST_SAMPLES: f64 = 4e5;

/// Changes of an argument are followed in steps no larger than this, rad.
const LARGEST_TURN: f64 = 0.3;

/// Halvings of a step.
const MOST_HALVINGS: u32 = 40;

/// The longest delay is found to this part of itself.
const SAME_DELAY: f64 = 1e-3;

/// No longer one is looked for, s.
const LONGEST: f64 = 100.0;

/// The string as its surface feels it.
struct AtSurface<'a> {
    network: TorsionNetwork<'a>,
    drive: TopDrive,
    /// Of ω between samples, rad/s.
    step: f64,
}

/// How many roots of a string grow below its drive, two for each mode that swings; none where it has no drive with a delay. `None`
/// where they cannot be counted: of a drive without inertia, which sends back what it should take
/// at any frequency, or of a string that takes so little that all frequencies matter.
///
/// # Errors
/// Where the string cannot be cut up.
pub fn growing_roots(string: &Drillstring) -> Result<Option<usize>, DrillstringError> {
    let Some(drive) = string.top_drive().filter(|drive| drive.delay > 0.0) else {
        return Ok(Some(0));
    };
    let bare = string.clone().without_top_drive();
    Ok(AtSurface::new(&bare, drive)?.growing(drive.delay))
}

/// The longest delay, s, with which no mode of a string grows below its drive, at any shorter one
/// either as far as is known: the first at which one does, looked for in steps of a tenth. `None`
/// where they cannot be counted, or none grows up to a hundred seconds.
///
/// # Errors
/// As [`growing_roots`], and where the string has no drive.
pub fn longest_delay(string: &Drillstring) -> Result<Option<f64>, DrillstringError> {
    let Some(drive) = string.top_drive() else {
        return Ok(None);
    };
    let bare = string.clone().without_top_drive();
    let surface = AtSurface::new(&bare, drive)?;
    let grows = |delay: f64| surface.growing(delay).map(|count| count > 0);
    let (mut low, mut high) = (0.0, 1e-4);
    loop {
        match grows(high) {
            None => return Ok(None),
            Some(true) => break,
            Some(false) if high > LONGEST => return Ok(None),
            Some(false) => (low, high) = (high, 1.1 * high),
        }
    }
    while high - low > SAME_DELAY * high {
        let middle = 0.5 * (low + high);
        match grows(middle) {
            None => return Ok(None),
            Some(true) => high = middle,
            Some(false) => low = middle,
        }
    }
    Ok(Some(low))
}

impl<'a> AtSurface<'a> {
    fn new(bare: &'a Drillstring, drive: TopDrive) -> Result<Self, DrillstringError> {
        Ok(Self {
            network: TorsionNetwork::new(bare, &Sites::bit())?,
            drive,
            step: std::f64::consts::PI / torsional_travel_time(bare) / SAMPLES,
        })
    }

    /// Torques per rotation at iω: of string and inertia, and of the motor without delay.
    fn torques(&self, omega: f64) -> [Complex64; 2] {
        let s = Complex64::new(0.0, omega);
        let string = torque_at_surface(self.network.pieces(s), None);
        [
            string + s * s * self.drive.inertia,
            s * self.drive.proportional_gain + self.drive.integral_gain,
        ]
    }

    /// Numerator and denominator of Q at iω.
    fn parts(&self, delay: f64, omega: f64) -> [Complex64; 2] {
        let [rest, motor] = self.torques(omega);
        let late = Complex64::from_polar(1.0, -omega * delay);
        let not_yet = (late - 1.0) * omega * omega * self.drive.late_inertia;
        [rest + not_yet + motor * late, rest + motor]
    }

    fn growing(&self, delay: f64) -> Option<usize> {
        if self.drive.inertia == 0.0 {
            return None;
        }
        let first = 1e-3 * self.step;
        let (mut omega, mut at) = (first, self.parts(delay, first));
        let (mut turned, mut strongest) = (0.0, 0.0_f64);
        let mut octave = 2.0 * self.step;
        loop {
            let next = omega + self.step;
            let there = self.parts(delay, next);
            turned += self.turn(delay, (omega, at), (next, there), 0)?;
            let [rest, motor] = self.torques(next);
            strongest = strongest.max((rest + next * next * self.drive.inertia).norm() / next);
            (omega, at) = (next, there);
            if omega / self.step > MOST_SAMPLES {
                return None;
            }
            if omega < octave {
                continue;
            }
            // The inertia outweighs string and motor, and Q turns no further.
            if omega * self.drive.inertia > 2.0 * strongest + 4.0 * motor.norm() / omega {
                break;
            }
            (octave, strongest) = (2.0 * omega, 0.0);
        }
        let [above, below] = at;
        let left = (above / below).arg();
        let count = -(turned - left) / std::f64::consts::PI;
        Some(count.round().max(0.0) as usize)
    }

    /// By how much arg Q changes between two places.
    fn turn(
        &self,
        delay: f64,
        from: (f64, [Complex64; 2]),
        to: (f64, [Complex64; 2]),
        halvings: u32,
    ) -> Option<f64> {
        let turns = [0, 1].map(|part| (to.1[part] / from.1[part]).arg());
        if turns.iter().all(|turn| turn.abs() <= LARGEST_TURN) {
            return Some(turns[0] - turns[1]);
        }
        if halvings == MOST_HALVINGS {
            return None;
        }
        let middle = 0.5 * (from.0 + to.0);
        let between = (middle, self.parts(delay, middle));
        let first = self.turn(delay, from, between, halvings + 1)?;
        Some(first + self.turn(delay, between, to, halvings + 1)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::controllers;
    use crate::validation::academic;

    /// At the longest delay a root is on the axis, and there alone Q comes near zero.
    #[test]
    fn at_the_longest_delay_a_root_crosses_the_axis() {
        let bare = academic::string();
        let drive = controllers::soft_torque(&bare, 2000.0);
        let string = bare.clone().with_top_drive(drive).unwrap();
        let longest = longest_delay(&string).unwrap().unwrap();
        let surface = AtSurface::new(&bare, drive).unwrap();
        let least = |delay: f64| {
            let omegas = (1..40_000).map(|step| 5e-4 * f64::from(step));
            let sizes = omegas.map(|omega| {
                let [late, at_once] = surface.parts(delay, omega);
                (late / at_once).norm()
            });
            sizes.fold(f64::INFINITY, f64::min)
        };
        assert!(least(longest) < 2e-3);
        for (part, roots) in [(0.97, 0), (1.03, 2)] {
            assert!(least(part * longest) > 1e-2);
            assert_eq!(surface.growing(part * longest), Some(roots));
        }
    }
}
