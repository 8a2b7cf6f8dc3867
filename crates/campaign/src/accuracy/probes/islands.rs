//! Islands of the other regime beyond a limit: limits too, and none that would hold still.

use anyhow::{Result, bail};
use linear::parallel;

use super::super::answer::Answer;
use super::super::strings::Systems;
use super::{Probe, Probes};
use crate::plan::Islands;

/// Islands refuse a reference within this factor of a limit, beyond what was asked for.
const FURTHEST: f64 = 1.3;

/// Islands are reported up to this part of a limit from it, beyond what was asked for.
const FURTHEST_REPORTED: f64 = 0.3;

/// Places on either side of a limit where they refuse a reference.
const PLACES: usize = 16;

/// Cases simulated for the islands of one limit.
pub const ISLAND_CASES: f64 = 2.0 * (PLACES + 1) as f64;

/// Places on either side of all limits together where the chosen method is examined, and of one at
/// least.
const MOST_PLACES: usize = 64;
const LEAST_PLACES: usize = 8;

impl Probes<'_> {
    /// Distances from a limit, beyond what was asked for up to the furthest: a number of places, the
    /// closer the nearer, each this part of a step outwards.
    fn distances(&self, furthest: f64, places: usize, outwards: f64) -> Vec<f64> {
        let ratio = furthest / self.asked;
        let parts = (0..places).map(|place| (place as f64 + outwards) / places as f64);
        parts.map(|part| self.asked * ratio.powf(part)).collect()
    }

    /// First place beyond a limit on one side of it, below or above, where something is otherwise
    /// than next to the limit, as a multiple of that.
    pub(super) fn island_next_to(
        &self,
        limit: f64,
        side: f64,
        is_inside_at: impl Fn(f64) -> Option<bool>,
    ) -> Option<f64> {
        let outermost = FURTHEST.ln();
        // In logarithms.
        let distances = self.distances(outermost, PLACES, 0.0);
        let distances = distances.into_iter().chain([outermost]);
        let beyond = distances.filter(|distance| *distance <= outermost);
        let mut regimes = beyond.map(|distance| {
            let factor = (side * distance).exp();
            (factor, is_inside_at(limit * factor))
        });
        let (_, near) = regimes.next()?;
        let (factor, _) = regimes.find(|(_, regime)| *regime != near)?;
        Some(factor)
    }

    /// Probes that are nearest to their limits, one of each group that shares these, with them: others
    /// may last too long there.
    fn nearest_to_limits(&self, answers: &[Answer]) -> Vec<(&Probe, f64)> {
        let nearest = |group: Vec<usize>| {
            let limits = group.into_iter().filter_map(|index| {
                let limit = answers[index].limit?;
                Some((&self.probes[index], limit))
            });
            let distance = |limit: f64| limit.ln().abs();
            limits.min_by(|(_, one), (_, other)| distance(*one).total_cmp(&distance(*other)))
        };
        self.groups().into_iter().filter_map(nearest).collect()
    }

    /// Refuses answers whose limits have islands of the other regime near.
    ///
    /// # Errors
    /// Names the first case with one.
    pub fn check_for_islands(&self, systems: &Systems, answers: &[Answer]) -> Result<()> {
        if self.cuts() {
            // A limit of steady drilling is known where it is.
            return Ok(());
        }
        let check = |(probe, limit): (&Probe, f64)| {
            let (system, case) = (&systems[probe.string], probe.case);
            let is_inside_at = |factor: f64| self.is_inside_at(system, case, factor);
            for side in [-1.0, 1.0] {
                if let Some(factor) = self.island_next_to(limit, side, is_inside_at) {
                    bail!(
                        "the limit near case {case} is ragged: at {factor:.2} times it there is \
                         another"
                    );
                }
            }
            Ok(())
        };
        let found: Vec<Result<()>> = parallel::each(self.nearest_to_limits(answers), check);
        found.into_iter().collect()
    }

    /// The islands beyond the limits of a reference by what was chosen, looked for in more places
    /// than those that refuse one; `None` where no limit is known, or another rule knows it.
    pub fn islands(&self, systems: &Systems, answers: &[Answer]) -> Option<Islands> {
        let limits = self.nearest_to_limits(answers);
        if self.cuts() || limits.is_empty() || self.asked >= FURTHEST_REPORTED {
            return None;
        }
        let places = (MOST_PLACES / limits.len()).max(LEAST_PLACES);
        let distances = self.distances(FURTHEST_REPORTED, places, 0.5);
        let labels = 2 * limits.len() * distances.len();
        let sides = limits
            .into_iter()
            .flat_map(|limit| [(limit, -1.0), (limit, 1.0)]);
        let found = parallel::each(
            sides.collect(),
            |((probe, limit), side): ((&Probe, f64), f64)| {
                let regimes: Vec<Option<bool>> = (distances.iter())
                    .map(|distance| {
                        let factor = limit * (1.0 + side * distance);
                        self.is_inside_at(&systems[probe.string], probe.case, factor)
                    })
                    .collect();
                // A bit sticks below its limit of speed, and whirls above one of friction.
                let is_inside = (side > 0.0) == self.sweep.setting.lateral.is_some();
                let others = regimes.iter().zip(&distances);
                let others = others.filter(|(regime, _)| **regime == Some(!is_inside));
                others.map(|(_, distance)| *distance).collect::<Vec<_>>()
            },
        );
        let others = found.concat();
        Some(Islands {
            labels,
            others: others.len(),
            furthest: others.into_iter().fold(0.0, f64::max),
        })
    }
}
