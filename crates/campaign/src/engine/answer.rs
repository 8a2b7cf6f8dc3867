//! What a run answers to a case by a method.

use sim::Trajectory;

use super::case::Case;
use super::finding::find_sites;
use super::longer::followed;
use super::nearby::certify;
use super::run_options::RunOptions;
use super::systems::MethodSystem;
use crate::plan::Sweep;
use crate::records::Record;

/// The record of a case in a run with these options; `method` is the place of the system's in
/// the sweep's list. A case that panics is one without an answer, and not the end of the sweep.
pub fn answer(
    system: &MethodSystem,
    case: &Case,
    method: usize,
    options: RunOptions,
    sweep: &Sweep,
) -> Record {
    let lateral = system.setting.lateral.as_ref();
    if let Some(finding) = lateral.and_then(|lateral| lateral.finding.as_ref()) {
        return followed(system, case, sweep, |system, case| {
            find_sites(system, finding, case, method, options, sweep)
        });
    }
    followed(system, case, sweep, |system, case| {
        answer_in_its_time(system, case, method, options, sweep)
    })
}

/// The record of a case at the sites of its system, to the end of its time.
fn answer_in_its_time(
    system: &MethodSystem,
    case: &Case,
    method: usize,
    options: RunOptions,
    sweep: &Sweep,
) -> Record {
    // What is measured of a motion, or held against a recording, is followed to the end.
    let is_kept = sweep.keeps_motion() || system.needs_motion();
    let mut motion = is_kept.then(Trajectory::default);
    let mut record = system.follow(case, method, options, sweep, motion.as_mut());
    if record.outcome.is_ok() {
        certify(system, case, options, sweep, &mut record);
    }
    record
}
