//! The axes of a design that limits are drawn along.

use campaign::plan::Sweep;
use campaign::quantities::Axis;

/// The place of an axis among those of the design.
pub(crate) fn position(sweep: &Sweep, is_wanted: impl Fn(Axis) -> bool) -> Option<usize> {
    sweep.design.axes().iter().position(|&axis| is_wanted(axis))
}

/// The least and the greatest value of an axis.
pub(crate) fn range_of_axis(sweep: &Sweep, position: usize) -> [f64; 2] {
    let values = (0..sweep.design.cases()).map(|case| sweep.design.values(case)[position]);
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], value| {
        [from.min(value), to.max(value)]
    })
}
