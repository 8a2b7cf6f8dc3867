//! What every kind of design asks of its axes.

use crate::quantities::Axis;
use crate::sweep_file::{AxisRange, Source, Spacing, SweepFileError};

/// More cases than fit in memory with their rows.
pub const MOST_CASES: usize = 10_000_000;

/// How many of a design's axes, the first ones, change the string.
pub fn count_string_axes(axes: &[Axis]) -> usize {
    axes.iter().take_while(|axis| axis.is_of_string()).count()
}

/// Refuses ends of a range in the wrong order, or at zero on a logarithmic axis.
///
/// # Errors
/// Names the end.
pub fn check_ends(
    source: &Source,
    key: &str,
    range: &AxisRange,
    (from, to): (f64, f64),
) -> Result<(), SweepFileError> {
    if range.spacing == Spacing::Log && from <= 0.0 {
        let message = "logarithmic spacing starts above zero";
        return Err(source.error(&format!("{key}.from"), message));
    }
    if from < to || (from == to && range.count == Some(1)) {
        return Ok(());
    }
    let message = format!("{to} is not above `from`, {from}: the range is empty");
    Err(source.error(&format!("{key}.to"), message))
}
