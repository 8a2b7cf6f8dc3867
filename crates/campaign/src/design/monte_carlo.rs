//! Random values. A case draws from (seed, case index) alone.

use super::correlation::Correlation;
use super::points::Points;
use super::random_axes::RandomAxes;
use crate::sweep_file::{DesignTable, Source, SweepFileError};

/// Random cases.
#[derive(Debug, Clone, PartialEq)]
pub struct MonteCarlo {
    pub(super) random: RandomAxes,
    correlation: Correlation,
    pub(super) points: Points,
    pub(super) cases: usize,
}

/// How many points the table of a design asks for.
///
/// # Errors
/// Where it does not, or asks for none.
pub(super) fn count_of_points(
    source: &Source,
    table: &DesignTable,
) -> Result<usize, SweepFileError> {
    match table.cases {
        Some(cases) if cases > 0 => Ok(cases),
        Some(_) => Err(source.error("design.cases", "there must be at least one")),
        None => Err(source.error("design", "needs `cases`, how many to draw")),
    }
}

impl MonteCarlo {
    pub(super) fn resolve(
        source: &Source,
        table: &DesignTable,
        weight_pushes: bool,
    ) -> Result<Self, SweepFileError> {
        let cases = count_of_points(source, table)?;
        let random = RandomAxes::resolve(source, table, weight_pushes)?;
        Ok(Self {
            correlation: Correlation::resolve(source, table, &random.axes)?,
            points: Points::resolve(source, table, random.count())?,
            random,
            cases,
        })
    }

    pub(super) fn values(&self, index: usize) -> Vec<f64> {
        let mut parts = self.points.point(index);
        self.correlation.correlate(&mut parts);
        self.random.at(&parts)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantities::Axis;
    use crate::sweep_file::PointsName;

    #[test]
    fn a_case_draws_from_its_seed_and_index_alone() {
        let axes = || {
            let axes = vec![Axis::SurfaceSpeedRpm, Axis::TorqueDynamicNm];
            RandomAxes::uniform(axes, &[[1.0, 2.0], [5.0, 6.0]])
        };
        for name in [PointsName::Random, PointsName::Sobol] {
            let design = |seed| MonteCarlo {
                random: axes(),
                correlation: Correlation::default(),
                points: Points::new(name, seed, 2).unwrap(),
                cases: 1000,
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

    /// As version 0.1.0 drew them: a change would make other sweeps of the same files.
    #[test]
    fn random_points_stay_what_they_were() {
        let points = Points::new(PointsName::Random, 12, 3).unwrap();
        assert_eq!(
            points.point(3)[1..],
            [0.486843270671626, 0.3269813402229632]
        );
    }
}
