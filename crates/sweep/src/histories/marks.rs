//! What pictures of motion have in common: levels, and whether the wall is shown.

use crate::plot::{Across, Reference};
use crate::quantities::Unit;

/// The clearance is drawn where motion reaches this part of it.
const CLEARANCE_SHOWN: f64 = 0.2;

/// A clearance (m) in a unit of widths, where motion comes so near, by its radii in that unit,
/// that it is seen beside it.
pub fn shown_clearance(
    clearance: f64,
    width: &Unit,
    radii: impl Iterator<Item = f64>,
) -> Option<f64> {
    let clearance = width.number(1e3 * clearance);
    let furthest = radii.fold(0.0, f64::max);
    (furthest > CLEARANCE_SHOWN * clearance).then_some(clearance)
}

/// A level line.
pub fn level(at: f64, name: &str) -> Reference {
    Reference {
        across: Across::Y,
        at,
        name: name.to_owned(),
    }
}
