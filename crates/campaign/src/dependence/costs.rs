//! Costs of examining labels, next to those of the run.

use linear::Method;

use super::variant::{Change, Variant};
use crate::engine::Case;
use crate::plan::Sweep;
use crate::records::FINER;

/// The part of the run that examining its labels may take,
const PART_OF_RUN: f64 = 0.1;

/// or this little, in steps of a case times its sites: a sixth of a second.
const LITTLE: f64 = 7.5e5;

/// Cases that take as long as building their system does, at most,
const CASES_PER_SYSTEM: f64 = 20.0;

/// and this number of times as many by `held`, which is built in shorter steps.
const HELD_PER_SYSTEM: f64 = 2.0;

/// Sites at which a step takes twice as long a site as at one.
const SITES_FOR_TWICE: f64 = 6.0;

/// About what a run takes and what examining its labels would, in the time of one of its cases. No clock
/// is asked: what is examined is the same on every machine.
pub(super) struct Costs<'a> {
    sweep: &'a Sweep,
    /// Cost of a case, with its system where each has its own.
    case: f64,
    /// Cost of a system for all.
    system: f64,
    /// Cost that is allowed in addition to that of any run.
    little: f64,
}

impl<'a> Costs<'a> {
    /// Costs of a sweep, from how long some of its cases last.
    pub(super) fn of(sweep: &'a Sweep, cases: &[usize]) -> Self {
        let setting = &sweep.setting;
        let some = cases
            .iter()
            .filter_map(|case| Case::of(sweep, setting, *case).ok());
        let durations: Vec<f64> = some.map(|case| case.scene.timing.duration).collect();
        let mean = durations.iter().sum::<f64>() / durations.len().max(1) as f64;
        let (steps, sites) = (
            mean * setting.sampling_frequency,
            setting.sites.len() as f64,
        );
        let (case, system) = match sweep.design.varies_string() {
            true => (1.0 + CASES_PER_SYSTEM, 0.0),
            false => (1.0, CASES_PER_SYSTEM),
        };
        Self {
            sweep,
            case,
            system,
            little: LITTLE / (steps * sites * (1.0 + sites / SITES_FOR_TWICE)),
        }
    }

    /// Whether all that a number of cases takes is little of what the run takes, or little at all.
    pub(super) fn allow(&self, variants: &[Variant], count: usize) -> bool {
        let cases = self.sweep.design.likely_cases() as f64;
        let run = self.sweep.methods.len() as f64 * (cases * self.case + self.system);
        let cost = |variant: &Variant| self.of_variant(variant, count);
        let sample: f64 = variants.iter().map(cost).sum();
        sample <= (PART_OF_RUN * run).max(self.little)
    }

    /// Cost of a variant of a number of cases.
    pub(super) fn of_variant(&self, variant: &Variant, count: usize) -> f64 {
        let cases = count as f64 * self.case;
        match variant.change {
            _ if variant.is_of_list(self.sweep) => 0.0,
            Change::Method(_) if variant.method == Method::Held => {
                HELD_PER_SYSTEM * self.system + cases
            }
            Change::Method(_) => self.system + cases,
            Change::SamplingFrequencyHz(_) => FINER * (self.system + cases),
            Change::Start(_) => cases,
        }
    }
}
