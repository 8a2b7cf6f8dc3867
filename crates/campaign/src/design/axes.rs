//! What every kind of design asks of its axes.

use crate::quantities::Axis;
use crate::sweep_file::{AxisRange, DesignTable, Source, Spacing, SweepFileError};

/// More cases than fit in memory with their rows.
pub const MOST_CASES: usize = 10_000_000;

/// How many of a design's axes, the first ones, change the string.
pub fn count_string_axes(axes: &[Axis], weight_pushes: bool) -> usize {
    let changes = |axis: &&Axis| axis.changes_string(weight_pushes);
    axes.iter().take_while(changes).count()
}

/// The place of an axis in the order of a design's: those that change the string come first.
pub fn place(axis: Axis, weight_pushes: bool) -> (bool, Axis) {
    (!axis.changes_string(weight_pushes), axis)
}

/// The axes of a table with their ranges, in the order of a design's.
pub fn in_order(table: &DesignTable, weight_pushes: bool) -> Vec<(Axis, &AxisRange)> {
    let mut axes: Vec<_> = table
        .axes
        .iter()
        .map(|(&axis, range)| (axis, range))
        .collect();
    axes.sort_by_key(|(axis, _)| place(*axis, weight_pushes));
    axes
}

/// Refuses ends of a range that the axis does not have, in the wrong order, or at zero
/// with logarithmic spacing.
///
/// # Errors
/// Names the end.
pub fn check_ends(
    source: &Source,
    axis: Axis,
    range: &AxisRange,
    (from, to): (f64, f64),
) -> Result<(), SweepFileError> {
    let key_of = |end: &str| format!("design.axes.{}.{end}", axis.name());
    source.check_axis(&key_of("from"), axis, from)?;
    source.check_axis(&key_of("to"), axis, to)?;
    let message = "logarithmic spacing starts above zero";
    let has_none = range.spacing == Spacing::Log && from <= 0.0;
    source.refuse_if(has_none, &key_of("from"), message)?;
    let has_values = from < to || (from == to && range.count == Some(1));
    let message = format!("{to} is not above `from`, {from}: the range is empty");
    source.refuse_if(!has_values, &key_of("to"), message)
}
