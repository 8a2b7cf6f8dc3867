//! What pictures of motion have in common: levels, and whether the wall is shown.

use crate::plot::{Across, Reference};

/// The clearance is drawn where motion reaches this part of it.
const CLEARANCE_SHOWN: f64 = 0.2;

/// Motion far from the wall would not be seen beside it.
pub fn shows_wall(furthest: f64, clearance: f64) -> bool {
    furthest > CLEARANCE_SHOWN * clearance
}

/// A level line.
pub fn level(at: f64, name: &str) -> Reference {
    Reference {
        across: Across::Y,
        at,
        name: name.to_owned(),
    }
}
