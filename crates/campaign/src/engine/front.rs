//! How a method treats the front that a torque which jumps sends up the string.

use crate::quantities::{TORQUE, Unit, Units};

/// A front that overshoots by more than this part is warned of: a limit of stick-slip is
/// off by about as much.
const LARGEST_OVERSHOOT: f64 = 0.05;

/// The largest undershoot Δ after a step of torque at the bit (Eq. 75), rad/s per N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Front {
    /// By the method.
    pub undershoot: f64,
    /// As it is.
    pub exact: f64,
}

/// A method whose fronts overshoot on a string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overshoot {
    /// Name of the method.
    pub method: &'static str,
    /// Its front.
    pub front: Front,
}

impl Overshoot {
    /// What is to be said of it.
    pub fn words(&self, units: Units) -> String {
        let unit = Unit::unchanged("rad/s").per(&units.of(&TORQUE));
        format!(
            "fronts overshoot by {}: on this string the undershoot Δ of Eq. 75 is {:.3e} {}, \
             {:.0} % above the exact one; a limit of stick-slip may be off by as much (`held` \
             keeps fronts as they are)",
            self.method,
            unit.number(self.front.undershoot),
            unit.name,
            100.0 * self.front.overshoot()
        )
    }
}

impl Front {
    /// By which part of the exact undershoot it is more than that.
    pub fn overshoot(&self) -> f64 {
        self.undershoot / self.exact - 1.0
    }

    /// Whether that is worth a warning.
    pub fn is_off(&self) -> bool {
        self.overshoot() > LARGEST_OVERSHOOT
    }
}
