//! Cases whose time is by rule, followed for longer while their motion fades: stick-slip in which
//! the bit sticks for ever shorter, and the swing of a string that lies in its hole. Irregular stick-slip is
//! followed once.
//!
//! Responses are built for the longest time of the rule. Those of a longer case are built when the
//! first case needs them, and are no part of a case that is decided in its time.

use std::borrow::Cow;

use linear::parallel;

use super::case::Case;
use super::memory::StringMemory;
use super::systems::{MethodSystem, Recipe};
use super::timing::{TIMES, is_by_rule};
use crate::plan::Sweep;
use crate::records::Record;

/// The record of a case followed for longer, while its motion fades or, once, while it is irregular;
/// `answer` is how a system answers a case.
pub(super) fn followed(
    system: &MethodSystem,
    case: &Case,
    sweep: &Sweep,
    answer: impl Fn(&MethodSystem, &Case) -> Record,
) -> Record {
    let mut record = answer(system, case);
    if !is_by_rule(sweep, &system.setting) {
        return record;
    }
    for place in 0..TIMES.len() {
        // What is as irregular after three times the time lasts.
        let outcome = record.outcome.as_ref();
        if !outcome.is_ok_and(|it| it.fades() || place == 0 && it.is_irregular()) {
            return record;
        }
        let Some(long) = longer(system, sweep, place) else {
            break;
        };
        let next = answer(long, &case.lasting(TIMES[place]));
        // As where the speed of its surface was recorded for no longer.
        if next.outcome.is_err() {
            break;
        }
        record = next;
    }
    record.outcome = record.outcome.map(sim::Outcome::undetermined);
    record
}

/// System and case, in its length, that a record was reached with.
pub(super) fn reached<'a>(
    system: &'a MethodSystem,
    case: &'a Case,
    sweep: &Sweep,
    record: &Record,
) -> (&'a MethodSystem, Cow<'a, Case>) {
    let simulated = record.outcome.as_ref().map_or(0.0, |it| it.simulated);
    // A case ends with the step in which its time does.
    let step = 1.0 / system.setting.sampling_frequency;
    let lasts = |case: &Case| simulated <= case.scene.timing.duration + step;
    let mut reached = (system, Cow::Borrowed(case));
    for (place, times) in TIMES.into_iter().enumerate() {
        if lasts(&reached.1) {
            break;
        }
        if let Some(long) = longer(system, sweep, place) {
            reached = (long, Cow::Owned(case.lasting(times)));
        }
    }
    reached
}

/// The system for cases of a sweep that are followed for longer, by a place in [`TIMES`]; none where
/// that takes too much memory.
fn longer<'a>(system: &'a MethodSystem, sweep: &Sweep, place: usize) -> Option<&'a MethodSystem> {
    let built = system.longer[place].get_or_init(|| {
        let (setting, method) = (&system.setting, system.method);
        let longest = system.responses.longest_time;
        StringMemory::longer(sweep, setting, &method, longest)[place]?;
        let recipe = Recipe::of(sweep, setting, method, TIMES[place] * longest);
        parallel::apart(|| recipe.build())?.ok().map(Box::new)
    });
    built.as_deref()
}
