//! How a method treats the front that a torque which jumps sends up the string.

use linear::sampling::SMALL;

use crate::quantities::{TORQUE, Unit, Units};

/// A front that overshoots by more than this part is warned of: a limit of stick-slip is
/// off by about as much.
const LARGEST_OVERSHOOT: f64 = 0.05;

/// One that is smeared by more than this. On the paper's string, by its methods at its sampling
/// frequency, the undershoot is 4 to 7 % too small.
const MOST_SMEARED: f64 = 0.1;

/// The largest undershoot Δ after a step of torque at the bit (Eq. 75), rad/s per N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Front {
    /// By the method.
    pub undershoot: f64,
    /// As it is.
    pub exact: f64,
    /// The largest speed of the bit after the same step by the method, rad/s per N m.
    pub largest: f64,
}

/// A method that makes too much or too little of fronts on a string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WrongFront {
    /// Name of the method.
    pub method: &'static str,
    /// Its front.
    pub front: Front,
}

impl WrongFront {
    /// What is to be said of it.
    pub fn words(&self, units: Units) -> String {
        let unit = Unit::unchanged("rad/s").per(&units.of(&TORQUE));
        let part = self.front.relative();
        let (what, side, remedy) = if part > 0.0 {
            ("overshoot by", "above", "`held` keeps fronts as they are")
        } else {
            (
                "are smeared by",
                "below",
                "less so at a higher `sampling_frequency_hz`",
            )
        };
        format!(
            "fronts {what} {}: on this string the undershoot Δ of Eq. 75 is {:.3e} {}, {:.0} % \
             {side} the exact one; a limit of stick-slip may be off by as much ({remedy})",
            self.method,
            unit.number(self.front.undershoot),
            unit.name,
            100.0 * part.abs()
        )
    }
}

impl Front {
    /// By which part of the exact undershoot it is more than that.
    pub fn relative(&self) -> f64 {
        self.undershoot / self.exact - 1.0
    }

    /// By which part of the exact undershoot, or of a small one of the largest speed, it is
    /// more than that.
    pub fn overshoot(&self) -> f64 {
        (self.undershoot - self.exact) / self.exact.max(SMALL * self.largest)
    }

    /// Whether that is worth a warning.
    pub fn is_off(&self) -> bool {
        !(-MOST_SMEARED..=LARGEST_OVERSHOOT).contains(&self.overshoot())
    }
}
