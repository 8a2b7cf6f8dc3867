//! How finely the torsion of a string has to be sampled: in steps per travel time of a wave
//! from the surface to the bit, so that fronts arrive on whole steps however long the string
//! is, and as many of them as its fronts need.
//!
//! Fronts decide the limit of stick-slip. What is held over steps rounds them off, and with
//! them the undershoot Δ of Eq. 75 and every echo after it: tool joints and collars scatter a
//! front in fractions of the time of one pipe, and their echoes add up. So a step is one piece
//! of the [lattice](crate::waves::lattice), in which nothing is rounded off. Only where these are
//! too many the number of steps is doubled until Δ by [`crate::Method::Held`] is the exact one; and
//! where loss grows with frequency, which takes the echoes that need more. Fronts arrive at any
//! time then, and Δ alone does not decide: the steps are so short that the echoes of all round trips
//! that are remembered come in time.
//!
//! Neither depends on how the lengths of a string are divided between its parts: see
//! [`merged`].
//!
//! ```
//! use linear::estimates::torsional_travel_time;
//! use linear::sampling::{FEWEST_STEPS, frequency_for_fronts};
//! use linear::{Drillstring, Material, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.02)?;
//! let steps = frequency_for_fronts(&string)? * torsional_travel_time(&string);
//! assert!(steps >= FEWEST_STEPS && (steps - steps.round()).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod merged;

use crate::budget::Need;
use crate::deviation::{train_at_bit, train_need};
use crate::drillstring::Drillstring;
use crate::error::{BuildError, DrillstringError};
use crate::estimates::{
    largest_response, largest_undershoot, torsional_travel_time, torsional_wave_left,
    torsional_wave_survives_to,
};
use crate::falling_torque::{highest_frequency, resonances};
use crate::filters::held;

pub use merged::merged;

/// A string of no more pieces than this has one step a piece. Of 245 random strings 97 % have their
/// limit within 5 % of exact waves then, and as many in steps of one piece however many there are;
/// with 5000 it is 96 %, with 2000 it is 94 %, and 71 % of those with tool joints and collars.
const FEW_PIECES: f64 = 8000.0;

/// The fewest steps per travel time of a string of more pieces. Strings that damp a wave little
/// remember an echo for many round trips, and its time matters to a part of a step.
pub const FEWEST_STEPS: f64 = 512.0;

/// Largest error of Δ on a string of more pieces, a part of one: limits change by more than Δ does.
/// Where loss depends on frequency, times what a wave loses in a round trip.
pub const TOLERANCE: f64 = 0.005;

/// A front that arrives within a step is shared between two, as if up to half a step early or late.
/// All round trips that are remembered together may add up to this part of the travel time: of
/// 190 random strings 184 have their limit within 5 % then, 171 with steps for Δ alone; of 78 of
/// them all do, and 72 at twice as much.
const TIME_TOLERANCE: f64 = 0.005;

/// What comes within this part of the travel time is a front: a loss factor of 0.005 makes no more of
/// one in a round trip.
const FRONT: f64 = 1.0 / 64.0;

/// What of a wave still reaches the bit at the highest frequency that needs to be followed: an echo
/// of it is a thousandth of what it was.
const LEAST_LEFT: f64 = 0.03;

/// Steps in a period of that.
const STEPS_PER_PERIOD: f64 = 8.0;

/// Steps in a period of vibration that a falling torque feeds. What is held over steps, as means over
/// them, is answered sinc²(π/20) times as strongly: vibration grows from a fall that is 0.8 % too
/// steep. On 8 random strings it is simulated to grow 0.4 to 1.1 % above the exact fall, on one
/// of them 2.1 %; 1.3 % at most at the default frequency.
const STEPS_PER_GROWING_PERIOD: f64 = 20.0;

/// An undershoot that is less than this part of the largest speed after the same step of torque is
/// small, as below a drive that lets waves out: it need not be known better than as a part of that.
pub const SMALL: f64 = 0.5;

/// A number of steps and what it makes of fronts.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Steps {
    /// Steps in the travel time of a wave from the surface to the bit: a whole number, or one a
    /// piece of the lattice.
    pub per_travel: f64,
    /// Δ of Eq. 75 as [`crate::Method::Held`] has it then, rad/s per N m.
    pub undershoot: f64,
    /// Δ as it is.
    pub exact: f64,
}

impl Steps {
    /// One step a piece where these are few and no loss depends on frequency; else the first
    /// number, doubled from [`FEWEST_STEPS`], for which Δ is within [`TOLERANCE`], at most one a
    /// piece, and no more than waves need of which loss leaves something.
    ///
    /// # Errors
    /// Where the lattice of so strongly damped a string would not fit in memory.
    pub fn for_fronts(string: &Drillstring) -> Result<Self, BuildError> {
        let string = merged(string)?;
        let (piece, train) = train_at_bit(&string)?;
        let exact = largest_undershoot(&train);
        let scale = exact.max(SMALL * largest_response(&train));
        let pieces = torsional_travel_time(&string) / piece;
        let by_held = |per_travel: f64| {
            let spacing = per_travel / pieces;
            let count = (train.len() as f64 * spacing) as usize;
            let undershoot = largest_undershoot(&held::shared(&train, spacing, count));
            Self {
                per_travel,
                undershoot,
                exact,
            }
        };
        let has_memory = string.loss().has_memory();
        if pieces <= FEW_PIECES && !has_memory {
            return Ok(by_held(pieces));
        }
        let (mut most, mut tolerance) = (pieces.floor(), TOLERANCE * scale);
        if has_memory {
            // What a round trip leaves adds its error to the next one's.
            tolerance *= 1.0 - torsional_wave_left(&string).powi(2);
            let fastest = torsional_wave_survives_to(&string, LEAST_LEFT);
            let needed = steps_at(&string, STEPS_PER_PERIOD * fastest);
            most = most.min(needed.max(FEWEST_STEPS));
        }
        let mut first = FEWEST_STEPS;
        if has_memory {
            first = first
                .max(steps_for_echoes(&string, &train, pieces))
                .min(most);
        }
        let mut steps = by_held(first);
        while (steps.undershoot - exact).abs() > tolerance && steps.per_travel < most {
            steps = by_held((2.0 * steps.per_travel).min(most));
        }
        Ok(steps)
    }
}

/// Steps per travel time of a string that remembers echoes for 1/(1 − q) round trips, q being what
/// is left after one. A swing without fronts does not care where in a step it begins: what counts
/// is the part of the bit's swing after a step of torque that is a front.
fn steps_for_echoes(string: &Drillstring, train: &[f64], pieces: f64) -> f64 {
    let window = (pieces * FRONT).ceil() as usize;
    // The torque itself acts at the start of a step.
    let speeds: Vec<f64> = (train.iter().scan(0.0, |speed, impulse| {
        *speed += impulse;
        Some(*speed)
    }))
    .collect();
    let jumps = speeds.iter().zip(speeds.iter().skip(window));
    let largest = jumps.fold(0.0f64, |most, (before, after)| {
        most.max((after - before).abs())
    });
    let swing = largest_undershoot(train) + largest_response(train);
    let remembered = (1.0 - torsional_wave_left(string).powi(2)).recip();
    0.5 * remembered * (largest / swing).min(1.0) / TIME_TOLERANCE
}

/// The sampling frequency, Hz, of a number of steps per travel time.
pub fn frequency(string: &Drillstring, steps_per_travel: f64) -> f64 {
    steps_per_travel / torsional_travel_time(string)
}

/// The least whole number of steps per travel time for which a string is sampled at a
/// frequency (Hz) or above.
pub fn steps_at(string: &Drillstring, frequency: f64) -> f64 {
    let steps = frequency * torsional_travel_time(string);
    // Rounding does not turn a whole number into the next.
    (steps - 1e-9).ceil().max(1.0)
}

/// Memory that [`frequency_for_fronts`] takes.
pub fn need_for_fronts(string: &Drillstring) -> Need {
    merged(string).map_or(Need::default(), |string| train_need(&string))
}

/// The sampling frequency (Hz) that the torsion of a string with a torque at the bit needs.
///
/// # Errors
/// As [`Steps::for_fronts`].
pub fn frequency_for_fronts(string: &Drillstring) -> Result<f64, BuildError> {
    Ok(frequency(string, Steps::for_fronts(string)?.per_travel))
}

/// The sampling frequency (Hz) that follows the vibration which a torque feeds that falls with the
/// bit's speed by `fall`, N m s/rad: of the one of all [`resonances`] that bears least, for where that
/// dies away, all do. 0 where none grows.
///
/// # Errors
/// Where the string cannot be cut up.
pub fn frequency_for_growth(string: &Drillstring, fall: f64) -> Result<f64, DrillstringError> {
    if fall == 0.0 {
        return Ok(0.0);
    }
    let found = resonances(string, highest_frequency(string))?.into_iter();
    let first = found.min_by(|one, other| one.steepest_fall().total_cmp(&other.steepest_fall()));
    let growing = first.filter(|resonance| resonance.steepest_fall() < fall);
    Ok(growing.map_or(0.0, |resonance| {
        STEPS_PER_GROWING_PERIOD * resonance.frequency
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drillstring::{Material, Section, Tube};

    fn uniform(length: f64, damping: f64) -> Drillstring {
        let steel = Material {
            shear_modulus: 80e9,
            density: 7840.0,
        };
        let tube = Tube {
            length,
            inner_radius: 0.05,
            outer_radius: 0.15,
        };
        let section = Section {
            repeat: 1,
            parts: vec![tube],
        };
        Drillstring::new(steel, vec![section], damping).unwrap()
    }

    #[test]
    fn a_uniform_tube_has_a_step_a_piece() {
        let string = uniform(1000.0, 10.0);
        let steps = Steps::for_fronts(&string).unwrap();
        assert!((FEWEST_STEPS..=FEW_PIECES).contains(&steps.per_travel));
        assert!((steps.undershoot / steps.exact - 1.0).abs() < 1e-9);
        let frequency = frequency(&string, 600.0);
        assert_eq!(steps_at(&string, frequency), 600.0);
        assert_eq!(steps_at(&string, 1.001 * frequency), 601.0);
    }

    /// It has no undershoot to be known to a part of.
    #[test]
    fn a_string_that_damps_its_fronts_away_has_no_undershoot_either_way() {
        let steps = Steps::for_fronts(&uniform(3000.0, 100.0)).unwrap();
        assert_eq!((steps.undershoot, steps.exact), (0.0, 0.0));
    }
}
