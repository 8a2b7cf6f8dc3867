//! What pictures of motion have in common: axes, levels, and whether the wall is shown.

use crate::plot::{Axis, Reference};

/// The clearance is drawn where motion reaches this part of it.
const CLEARANCE_SHOWN: f64 = 0.2;

/// Motion far from the wall would not be seen beside it.
pub fn shows_wall(furthest: f64, clearance: f64) -> bool {
    furthest > CLEARANCE_SHOWN * clearance
}

/// A linear axis.
pub fn axis(label: &str) -> Axis {
    Axis {
        label: label.to_owned(),
        logarithmic: false,
    }
}

/// A level line.
pub fn level(y: f64, name: &str) -> Reference {
    Reference::Horizontal {
        y,
        name: name.to_owned(),
    }
}
