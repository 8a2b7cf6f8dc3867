//! What a string does sideways at zero frequency, where it moves as a rigid rod.

use crate::bending::Bending;
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::in_mud::{self, Alike};

/// What holds back a string that moves across its hole slowly, as a rigid rod: its drag per speed,
/// N s/m, and the first two moments of that about its middle, by depth in parts of its length.
pub(super) struct DragAtRest {
    pub(super) whole: f64,
    first: f64,
    second: f64,
}

impl DragAtRest {
    pub(super) fn of(string: &Drillstring, bending: &Bending) -> Self {
        let mut drag = Self {
            whole: 0.0,
            first: 0.0,
            second: 0.0,
        };
        let mut top = -0.5;
        for Alike { length, mud, .. } in in_mud::one_by_one(string) {
            let mud = mud.map_or(0.0, |mud| mud.steady_drag(Channel::Bending));
            let (part, of_part) = (length / string.length(), length * (bending.damping + mud));
            let middle = top + 0.5 * part;
            drag.whole += of_part;
            drag.first += of_part * middle;
            drag.second += of_part * (middle * middle + part * part / 12.0);
            top += part;
        }
        drag
    }

    /// Speed at the first of two depths per force at the other, of a rod that shifts and turns.
    pub(super) fn of_rod(&self, depths: [f64; 2]) -> f64 {
        let centre = self.first / self.whole;
        let [one, other] = depths.map(|depth| depth - 0.5 - centre);
        let turning = self.second - self.first * centre;
        1.0 / self.whole + one * other / turning
    }

    /// The same of one that turns about a place.
    pub(super) fn of_turning_about(&self, pivot: f64, depths: [f64; 2]) -> f64 {
        let [one, other] = depths.map(|depth| depth - pivot);
        let pivot = pivot - 0.5;
        one * other / (self.second - 2.0 * pivot * self.first + pivot * pivot * self.whole)
    }
}
