//! What a string does sideways at zero frequency, where it moves as a rigid rod.

use crate::bending::Bending;
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::in_mud;

/// What holds back a string that moves across its hole slowly, as a rigid rod.
pub(super) struct DragAtRest {
    /// Force per speed, N s/m.
    pub(super) whole: f64,
    /// Where that acts, below the middle, in parts of the length.
    centre: f64,
    /// Its spread about that: one over its mean square distance, in parts of the length.
    narrowness: f64,
}

impl DragAtRest {
    pub(super) fn of(string: &Drillstring, bending: &Bending) -> Self {
        let length = string.bending_length();
        if string.loss().viscous_mud().is_none() {
            return Self {
                whole: bending.damping * length,
                centre: 0.0,
                narrowness: 12.0,
            };
        }
        let (mut top, mut whole, mut first, mut second) = (-0.5, 0.0, 0.0, 0.0);
        let mut held = string.length() - length;
        for piece in in_mud::one_by_one(string) {
            let bends = (piece.length - held).max(0.0);
            held = (held - piece.length).max(0.0);
            let mud = piece.mud;
            let mud = mud.map_or(0.0, |mud| mud.steady_drag(Channel::Bending));
            let (part, of_part) = (bends / length, bends * (bending.damping + mud));
            let middle = top + 0.5 * part;
            whole += of_part;
            first += of_part * middle;
            second += of_part * (middle * middle + part * part / 12.0);
            top += part;
        }
        let centre = first / whole;
        Self {
            whole,
            centre,
            narrowness: whole / (second - first * centre),
        }
    }

    /// Speed at the first of two depths, in parts of the length, per force at the other, of a rod that
    /// shifts and turns.
    pub(super) fn of_rod(&self, depths: [f64; 2]) -> f64 {
        let [one, other] = depths.map(|depth| depth - 0.5 - self.centre);
        (1.0 + self.narrowness * one * other) / self.whole
    }

    /// The same of one that turns about a depth.
    pub(super) fn of_turning_about(&self, pivot: f64, depths: [f64; 2]) -> f64 {
        let [one, other] = depths.map(|depth| depth - pivot);
        let off = pivot - 0.5 - self.centre;
        one * other / (self.whole * (self.narrowness.recip() + off * off))
    }
}
