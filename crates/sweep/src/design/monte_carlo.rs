//! Independent random values. A case draws from (seed, case index) alone.

use super::axes::{check_ends, count_string_axes, in_order};
use crate::quantities::Axis;
use crate::random::Stream;
use crate::sweep_file::{AxisRange, DesignTable, Source, Spacing, SweepFileError};

/// Random cases.
#[derive(Debug, Clone, PartialEq)]
pub struct MonteCarlo {
    pub(super) axes: Vec<Axis>,
    /// How many of them, the first ones, change the string.
    pub(super) of_string: usize,
    ranges: Vec<Range>,
    pub(super) cases: usize,
    pub(super) seed: u64,
}

#[derive(Debug, Clone, PartialEq)]
struct Range {
    from: f64,
    to: f64,
    spacing: Spacing,
}

impl MonteCarlo {
    pub(super) fn resolve(
        source: &Source,
        table: &DesignTable,
        weight_pushes: bool,
    ) -> Result<Self, SweepFileError> {
        let cases = match table.cases {
            Some(cases) if cases > 0 => cases,
            Some(_) => return Err(source.error("design.cases", "there must be at least one")),
            None => return Err(source.error("design", "needs `cases`, how many to draw")),
        };
        let given = in_order(table, weight_pushes);
        let axes: Vec<Axis> = given.iter().map(|(axis, _)| *axis).collect();
        let ranges = (given.into_iter())
            .map(|(axis, range)| Range::resolve(source, axis, range))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            of_string: count_string_axes(&axes, weight_pushes),
            axes,
            ranges,
            cases,
            seed: table.seed.unwrap_or(0),
        })
    }

    /// Points with every axis at an end of its range: a quantity that rises or falls
    /// along each axis is largest at one of them.
    pub fn corners(&self) -> Vec<Vec<f64>> {
        let mut corners = vec![Vec::new()];
        for range in &self.ranges {
            let ends = [range.from, range.to].into_iter();
            let with = |end: f64| {
                corners
                    .iter()
                    .map(move |corner| [&corner[..], &[end]].concat())
            };
            corners = ends.flat_map(with).collect();
        }
        corners
    }

    /// The ends of the range of the axis at a place.
    pub(super) fn ends(&self, place: usize) -> [f64; 2] {
        let Range { from, to, .. } = self.ranges[place];
        [from.min(to), from.max(to)]
    }

    pub(super) fn values(&self, index: usize) -> Vec<f64> {
        let mut stream = Stream::new(self.seed, index as u64);
        let ranges = self.ranges.iter();
        ranges
            .map(|range| stream.between(range.from, range.to, range.spacing))
            .collect()
    }
}

impl Range {
    fn resolve(source: &Source, axis: Axis, range: &AxisRange) -> Result<Self, SweepFileError> {
        let key = format!("design.axes.{}", axis.name());
        let (Some(from), Some(to), None, None) = (range.from, range.to, range.count, &range.values)
        else {
            return Err(source.error(&key, "a Monte Carlo axis has `from` and `to`"));
        };
        let message = "is counted in whole numbers: make it an axis of a grid or a list";
        source.refuse_if(axis.is_counted(), &key, message)?;
        check_ends(source, axis, range, (from, to))?;
        Ok(Self {
            from,
            to,
            spacing: range.spacing,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_draws_from_its_seed_and_index_alone() {
        let range = |from: f64| Range {
            from,
            to: from + 1.0,
            spacing: Spacing::Linear,
        };
        let design = |seed| MonteCarlo {
            axes: vec![Axis::SurfaceSpeedRpm, Axis::TorqueDynamicNm],
            of_string: 0,
            ranges: vec![range(1.0), range(5.0)],
            cases: 1000,
            seed,
        };
        let backwards: Vec<_> = (0..1000).rev().map(|case| design(7).values(case)).collect();
        let forwards: Vec<_> = (0..1000).map(|case| design(7).values(case)).collect();
        assert!(forwards.iter().eq(backwards.iter().rev()));
        assert_ne!(design(7).values(3), design(8).values(3));
        assert_ne!(design(7).values(3), design(7).values(4));
        let mean = forwards.iter().map(|case| case[0]).sum::<f64>() / 1000.0;
        // Four standard errors of a uniform mean.
        assert!(
            (mean - 1.5).abs() < 4.0 * (1.0f64 / 12.0 / 1000.0).sqrt(),
            "{mean}"
        );
        assert!(forwards.iter().all(|case| (5.0..6.0).contains(&case[1])));
    }
}
