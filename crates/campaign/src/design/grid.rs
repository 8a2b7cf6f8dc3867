//! Every combination of the axes' values; the first axis changes slowest.

use super::axes::{MOST_CASES, check_ends, count_string_axes, in_order};
use crate::quantities::Axis;
use crate::sweep_file::{AxisRange, DesignTable, Source, SweepFileError};

/// More grid values on an axis are a slip of the pen.
const MOST_VALUES: usize = 1_000_000;

/// A full grid.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Grid {
    pub(super) axes: Vec<Axis>,
    /// How many of them, the first ones, change the string.
    pub(super) of_string: usize,
    pub(super) values: Vec<Vec<f64>>,
}

impl Grid {
    pub(super) fn resolve(
        source: &Source,
        table: &DesignTable,
        weight_pushes: bool,
    ) -> Result<Self, SweepFileError> {
        let ranges = in_order(table, weight_pushes);
        let axes: Vec<Axis> = ranges.iter().map(|(axis, _)| *axis).collect();
        let mut grid = Self {
            of_string: count_string_axes(&axes, weight_pushes),
            axes,
            values: Vec::new(),
        };
        for (axis, range) in ranges {
            grid.values.push(axis_values(source, axis, range)?);
            // It will be refused: further axes would only fill the memory.
            if grid.cases() > MOST_CASES {
                break;
            }
        }
        Ok(grid)
    }

    /// Of more cases than can be counted, as many as can be.
    pub(super) fn cases(&self) -> usize {
        let counts = self.values.iter().map(Vec::len);
        counts.fold(1, usize::saturating_mul)
    }

    /// Cases of one string: the combinations of all other axes, neighbours as
    /// the axes of the string come first.
    pub(super) fn cases_per_string(&self) -> usize {
        self.values[self.of_string..].iter().map(Vec::len).product()
    }

    /// The values along the axis at a place.
    pub(super) fn along(&self, place: usize) -> &[f64] {
        &self.values[place]
    }

    pub(super) fn values(&self, index: usize) -> Vec<f64> {
        let mut left = index;
        let mut case: Vec<f64> = (self.values.iter().rev())
            .map(|values| {
                let value = values[left % values.len()];
                left /= values.len();
                value
            })
            .collect();
        case.reverse();
        case
    }
}

/// A whole number that rounding has missed.
fn snapped(value: f64) -> f64 {
    let whole = value.round();
    if (value - whole).abs() < 1e-9 * whole.abs() {
        whole
    } else {
        value
    }
}

fn axis_values(source: &Source, axis: Axis, range: &AxisRange) -> Result<Vec<f64>, SweepFileError> {
    let key = format!("design.axes.{}", axis.name());
    refuse_distribution(source, &key, range)?;
    let values = match (&range.values, range.from, range.to, range.count) {
        (Some(values), None, None, None) => values.clone(),
        (None, Some(from), Some(to), Some(count)) => {
            let message = format!("{count} values are more than {MOST_VALUES}");
            source.refuse_if(count > MOST_VALUES, &format!("{key}.count"), message)?;
            check_ends(source, axis, range, (from, to))?;
            let last = count.saturating_sub(1).max(1) as f64;
            let value = |step| range.spacing.between(from, to, step as f64 / last);
            let values = (0..count).map(value);
            if axis.is_counted() {
                values.map(snapped).collect()
            } else {
                values.collect()
            }
        }
        _ => {
            let message = "a grid axis has `from`, `to` and `count`, or `values`";
            return Err(source.error(&key, message));
        }
    };
    source.refuse_if(values.is_empty(), &key, "has no values: the grid is empty")?;
    for (index, &value) in values.iter().enumerate() {
        let place = match range.values {
            Some(_) => format!("{key}.values[{index}]"),
            None => format!("{key}.to"),
        };
        source.check_axis(&place, axis, value)?;
    }
    Ok(values)
}

/// What says how random values are spread would be ignored.
pub(super) fn refuse_distribution(
    source: &Source,
    key: &str,
    range: &AxisRange,
) -> Result<(), SweepFileError> {
    let numbers = range.of_distributions();
    let given = numbers.map(|(name, value, _)| (name, value.is_some()));
    let distribution = [("distribution", range.distribution.is_some())];
    for (name, is_given) in distribution.into_iter().chain(given) {
        let message = "is of random values: `kind = \"monte-carlo\"`";
        source.refuse_if(is_given, &format!("{key}.{name}"), message)?;
    }
    Ok(())
}
