//! Cases whose time is by rule, followed for longer while their motion fades: stick-slip in which
//! the bit sticks for ever shorter, and the swing of a string that lies in its hole.
//!
//! Responses are built for the longest time of the rule. Those of a longer case are built when the
//! first case needs them, and are no part of a case that is decided in its time.

use std::borrow::Cow;

use super::case::Case;
use super::memory::StringMemory;
use super::systems::MethodSystem;
use crate::plan::{Setting, Sweep};
use crate::records::Record;
use crate::sweep_file::AutoOr;

/// Times as long as by rule, one after the other.
pub(super) const TIMES: [f64; 2] = [3.0, 9.0];

/// Bytes of a system for such a time, at most, with a case that is stepped against it. What takes
/// more is not built, and the case is undetermined; so no other sweep takes much more memory.
const MOST_BYTES: f64 = 256.0 * 1024.0 * 1024.0;

/// Whether a label may be undetermined: the time is by rule, and that waits for motion to fade.
fn is_by_rule(sweep: &Sweep, setting: &Setting) -> bool {
    matches!(sweep.time, AutoOr::Auto) && setting.cutting.is_none()
}

/// Memory for each of [`TIMES`], of the systems by a method that are built where a case asks for
/// them; none where they are not.
pub(super) fn memory(
    sweep: &Sweep,
    setting: &Setting,
    method: &linear::Method,
    longest: f64,
) -> [Option<StringMemory>; TIMES.len()] {
    let finds_sites = (setting.lateral.as_ref()).is_some_and(|lateral| lateral.finding.is_some());
    let may_fade = sweep.bit.is_some() || setting.friction.is_some() || setting.lying.is_some();
    let follows = is_by_rule(sweep, setting) && may_fade && !finds_sites;
    TIMES.map(|times| {
        let memory = || StringMemory::at_sites(sweep, setting, method, times * longest);
        let fits = |memory: &StringMemory| {
            let bytes = memory.systems.kept + memory.case;
            memory.too_long.is_none() && bytes > 0.0 && bytes <= MOST_BYTES
        };
        follows.then(memory).filter(fits)
    })
}

/// The record of a case followed for longer, while what is known of it is that its motion fades;
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
        if !fades(&record) {
            return record;
        }
        let Some(longer) = system.longer(sweep, place) else {
            break;
        };
        let next = answer(longer, &case.lasting(TIMES[place]));
        // As where the speed of its surface was recorded for no longer.
        if next.outcome.is_err() {
            break;
        }
        record = next;
    }
    record.outcome = record.outcome.map(sim::Outcome::undetermined);
    record
}

fn fades(record: &Record) -> bool {
    record.outcome.as_ref().is_ok_and(sim::Outcome::fades)
}

/// What a case was followed with that has a record: its system, and how long it lasted.
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
        if let Some(longer) = system.longer(sweep, place) {
            reached = (longer, Cow::Owned(case.lasting(times)));
        }
    }
    reached
}
