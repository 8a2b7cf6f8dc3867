//! Where the bit cuts: cases have several starts, as their motion is often chaotic, and limits are those of
//! steady drilling.

use linear::parallel;
use sim::Stopping;

use super::super::answer::{Answer, answer_of, largest_chance};
use super::super::steady::{Exact, Stepped, growth_within};
use super::super::strings::Systems;
use super::super::trial;
use super::{DOUBLINGS, Probe, Probes};
use crate::engine::MethodSystem;
use crate::quantities::Axis;

/// Starts of each case, at first and at most.
const STARTS: usize = 8;
const MOST_STARTS: usize = 64;

impl Probes<'_> {
    /// Whether the bit cuts: then each case has several starts, and its limit is that of steady drilling.
    pub fn cuts(&self) -> bool {
        self.sweep.setting.cutting.is_some()
    }

    /// Number of the starts of a case at first.
    pub fn starts(&self) -> usize {
        if self.cuts() { STARTS } else { 1 }
    }

    /// Number of the starts of a case by whose means two methods can be compared as certainly as this, a part of
    /// one, by the chance that is left in some answers.
    pub fn starts_for(&self, certain: f64, answers: &[Answer]) -> usize {
        // Chance of two means adds up, and is itself known by a few starts only.
        let chance = 3.0 * largest_chance(answers).part;
        let starts = self.starts() as f64 * (chance / certain).powi(2);
        (starts.ceil() as usize).clamp(self.starts(), MOST_STARTS)
    }

    /// The answers where the bit cuts, each by all starts of its case.
    pub(super) fn answers_of_cutting(
        &self,
        systems: &Systems,
        stopping: Stopping,
        starts: usize,
    ) -> Vec<Answer> {
        let mut outcomes = parallel::map(self.probes.len() * starts, 1, |place| {
            let probe = &self.probes[place / starts];
            let number = (place % starts + 1) as f64;
            let conditions = (self.conditions(probe.case, 1.0)).with(Axis::StartNumber, number);
            trial::outcome(self.sweep, &systems[probe.string], &conditions, stopping)
        })
        .into_iter();
        let limits = parallel::map(self.probes.len(), 1, |place| {
            let probe = &self.probes[place];
            self.stepped_drilling_limit(&systems[probe.string], probe)
        });
        let probes = self.probes.iter().zip(limits);
        let answer = |(probe, limit): (&Probe, Option<f64>)| {
            let of_starts: Vec<_> = outcomes.by_ref().take(starts).collect();
            let sites = systems[probe.string].setting.sites.len();
            Answer {
                limit,
                ..answer_of(probe.case, &of_starts, sites)
            }
        };
        probes.map(answer).collect()
    }

    /// The limits of steady drilling near all probes, as they are.
    pub fn drilling_limits(&self) -> impl Iterator<Item = Option<f64>> {
        self.probes.iter().map(|probe| probe.drilling)
    }

    /// The limit of steady drilling near a case as it is, in multiples of its surface speed; `None` where there
    /// is none, or the bit does not cut, or there are other limits near that one: which of them is next depends
    /// on anything.
    pub(super) fn exact_drilling_limit(&self, probe: &Probe) -> Option<f64> {
        let values = self.sweep.design.values(probe.case);
        let (setting, bit) = (
            self.sweep.setting_at(&values).ok()?,
            self.sweep.bit.as_ref()?,
        );
        let at = |factor: f64| self.conditions(probe.case, factor);
        let growth = growth_within(probe.duration);
        let exact = Exact::new(&setting, bit, growth, &at(2f64.powi(-DOUBLINGS)))?;
        let grows = |factor: f64| exact.grows(&at(factor));
        let limit = self.limit(grows, grows(1.0)?, None)?;
        let has_another = |side: f64| self.island_next_to(limit, side, grows).is_some();
        (!has_another(-1.0) && !has_another(1.0)).then_some(limit)
    }

    /// The same as a method steps it, near where it is.
    fn stepped_drilling_limit(&self, system: &MethodSystem, probe: &Probe) -> Option<f64> {
        let (near, bit) = (probe.drilling?, self.sweep.bit.as_ref()?);
        let at = |factor: f64| self.conditions(probe.case, factor);
        let growth = growth_within(probe.duration);
        let stepped = Stepped::new(system, bit, growth, &at(2f64.powi(-DOUBLINGS)))?;
        let grows = |factor: f64| stepped.grows(&at(factor));
        self.limit(grows, grows(1.0)?, Some(near))
    }
}
