//! A trace: the cases of a fine grid over two axes that tell where its limits are.

use super::axes::{MOST_CASES, check_ends, count_string_axes, in_order};
use super::grid::{Grid, refuse_distribution};
use crate::quantities::Axis;
use crate::sweep_file::{
    AxisRange, DesignKind, DesignTable, Source, SweepFileError, TRACE_TOLERANCE,
};
use crate::trace::{Lattice, MOST_COARSE};

/// Values of the coarse scan along an axis, where the file does not say.
const COARSE: usize = 9;

/// A trace over two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct TraceDesign {
    /// The grid whose cases it chooses from.
    pub(super) grid: Grid,
    /// Where these are between the points of the coarse scan.
    pub lattice: Lattice,
    /// Draws cases where a limit is ragged.
    pub seed: u64,
}

impl TraceDesign {
    pub(super) fn resolve(
        source: &Source,
        table: &DesignTable,
        weight_pushes: bool,
    ) -> Result<Self, SweepFileError> {
        let ranges = in_order(table, weight_pushes);
        let [first, second] = ranges[..] else {
            let count = ranges.len();
            let message = format!("a trace has two axes, and these are {count}");
            return Err(source.error("design.axes", message));
        };
        if let Some(tolerance) = table.tolerance {
            source.within("design.tolerance", tolerance, 1e-6, 0.5, "of an axis")?;
        }
        check(source, first)?;
        check(source, second)?;
        let points = lattice(table, [first.1, second.1]).points();
        let message = format!("a grid as fine has {points} cases, more than {MOST_CASES}");
        source.refuse_if(points > MOST_CASES, "design.tolerance", message)?;
        let axes = [first.0, second.0];
        let trace = Self::of(table, axes, count_string_axes(&axes, weight_pushes));
        trace.ok_or_else(|| source.error("design.axes", "has no ends"))
    }

    /// By a table that was checked; none where an axis has no ends there. The first
    /// `of_string` axes change the string.
    pub fn of(table: &DesignTable, axes: [Axis; 2], of_string: usize) -> Option<Self> {
        let ranges = [table.axes.get(&axes[0])?, table.axes.get(&axes[1])?];
        let lattice = lattice(table, ranges);
        let values = |(range, points): (&AxisRange, usize)| {
            let (from, to) = range.from.zip(range.to)?;
            let part = |place: usize| place as f64 / (points - 1) as f64;
            let value = |place| range.spacing.between(from, to, part(place));
            Some((0..points).map(value).collect())
        };
        let both = ranges.into_iter().zip(lattice.size());
        Some(Self {
            grid: Grid {
                axes: axes.to_vec(),
                of_string,
                values: both.map(values).collect::<Option<_>>()?,
            },
            lattice,
            seed: table.seed.unwrap_or(0),
        })
    }

    /// The trace over the two ranges of a grid; `None` for another design.
    pub fn equivalent_to_grid(table: &DesignTable) -> Option<Self> {
        let mut traced = table.clone();
        let ranges = traced.axes.values_mut();
        ranges.for_each(|range| range.count = None);
        let axes: Vec<Axis> = table.axes.keys().copied().collect();
        let is_grid = table.kind == DesignKind::Grid && !axes.iter().any(|axis| axis.is_counted());
        Self::of(&traced, axes.try_into().ok().filter(|_| is_grid)?, 0)
    }

    /// About how many cases it takes where one smooth limit crosses the map: 20 to 23 for each
    /// value of a finer axis in Figs. 9, 14 and 17 of the paper, by three methods.
    pub fn likely_cases(&self) -> usize {
        let [x, y] = self.lattice.size();
        let scanned = self.lattice.places(0).count();
        (scanned + 20 * x.max(y)).min(self.lattice.points())
    }

    /// The values of both axes, in the order of its columns.
    pub fn values(&self) -> [&[f64]; 2] {
        [0, 1].map(|place| self.grid.along(place))
    }
}

/// From the coarse scan down to the tolerance.
fn lattice(table: &DesignTable, ranges: [&AxisRange; 2]) -> Lattice {
    let cells = ranges.map(|range| range.count.unwrap_or(COARSE) - 1);
    Lattice::new(cells, table.tolerance.unwrap_or(TRACE_TOLERANCE))
}

/// Refuses an axis without ends, one of whole numbers, and a scan of too few or too many
/// values.
fn check(source: &Source, (axis, range): (Axis, &AxisRange)) -> Result<(), SweepFileError> {
    let key = format!("design.axes.{}", axis.name());
    refuse_distribution(source, &key, range)?;
    let message = "takes whole numbers alone, and a trace goes between any two";
    source.refuse_if(axis.is_counted(), &key, message)?;
    let (Some(from), Some(to), None) = (range.from, range.to, &range.values) else {
        let message = "an axis of a trace is continuous: it has `from` and `to`";
        return Err(source.error(&key, message));
    };
    let count = range.count.unwrap_or(COARSE);
    let message = format!("{count} is not from 2 to {MOST_COARSE}, the values of the coarse scan");
    let is_out = !(2..=MOST_COARSE).contains(&count);
    source.refuse_if(is_out, &format!("{key}.count"), message)?;
    check_ends(source, axis, range, (from, to))
}
