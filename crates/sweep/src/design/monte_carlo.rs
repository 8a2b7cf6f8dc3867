//! Random values. A case draws from (seed, case index) alone.

use super::axes::{count_string_axes, in_order};
use super::correlation::Correlation;
use super::distribution::Distribution;
use crate::quantities::Axis;
use crate::random::Stream;
use crate::sweep_file::{DesignTable, Source, SweepFileError};

/// Random cases.
#[derive(Debug, Clone, PartialEq)]
pub struct MonteCarlo {
    pub(super) axes: Vec<Axis>,
    /// How many of them, the first ones, change the string.
    pub(super) of_string: usize,
    distributions: Vec<Distribution>,
    correlation: Correlation,
    pub(super) cases: usize,
    pub(super) seed: u64,
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
        let distributions = (given.into_iter())
            .map(|(axis, range)| Distribution::resolve(source, axis, range))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            of_string: count_string_axes(&axes, weight_pushes),
            correlation: Correlation::resolve(source, table, &axes)?,
            axes,
            distributions,
            cases,
            seed: table.seed.unwrap_or(0),
        })
    }

    /// Points with every axis at an end of its range: a quantity that rises or falls
    /// along each axis is largest at one of them.
    pub fn corners(&self) -> Vec<Vec<f64>> {
        let mut corners = vec![Vec::new()];
        for range in &self.distributions {
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
        let Distribution { from, to, .. } = self.distributions[place];
        [from.min(to), from.max(to)]
    }

    pub(super) fn values(&self, index: usize) -> Vec<f64> {
        let mut stream = Stream::new(self.seed, index as u64);
        let mut parts: Vec<f64> = self.axes.iter().map(|_| stream.part()).collect();
        self.correlation.correlate(&mut parts);
        std::iter::zip(&self.distributions, parts)
            .map(|(distribution, part)| distribution.at(part))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep_file::Spacing;

    #[test]
    fn a_case_draws_from_its_seed_and_index_alone() {
        let range = |from: f64| Distribution::uniform(from, from + 1.0, Spacing::Linear);
        let design = |seed| MonteCarlo {
            axes: vec![Axis::SurfaceSpeedRpm, Axis::TorqueDynamicNm],
            of_string: 0,
            distributions: vec![range(1.0), range(5.0)],
            correlation: Correlation::default(),
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
