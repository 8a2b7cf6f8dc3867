//! Whether a label holds at surface speeds next to that of a case.
//!
//! Whether stick-slip lasts from the start of a case has a ragged edge in the surface speed, far
//! from the limit of Eq. 74 where tool joints and collars send echoes: labels alternate there, and
//! depend on details of the string that no method resolves.

use linear::Method;
use sim::{Label, Motion, Stopping};

use super::case::Case;
use super::run_options::RunOptions;
use super::systems::MethodSystem;
use crate::plan::Sweep;
use crate::quantities::Axis;
use crate::records::{Record, Verdict};

/// Surface speeds as fractions of that of a case, at which a certain label is the same. Edges that
/// methods put as much as 8 % apart are not missed, nor are labels that alternate every 2 %; of
/// pockets that are narrower some are.
const NEARBY_SPEEDS: [f64; 14] = [
    0.9, 0.93, 0.95, 0.97, 0.98, 0.99, 0.995, 1.005, 1.01, 1.02, 1.03, 1.05, 1.07, 1.1,
];

/// Whether the method at a place of a sweep's list is the one that looks at nearby speeds: of the
/// two that certify labels `held`, or the first.
fn looks_nearby(sweep: &Sweep, method: usize) -> bool {
    sweep.certifying.is_some_and(|places| {
        let is_held = |place: &&usize| sweep.methods[**place] == Method::Held;
        *places.iter().find(is_held).unwrap_or(&places[0]) == method
    })
}

/// Whether the bit of a case has a label at nearby speeds, too: false where a case there has
/// another one, or no answer. Each lasts as long as the case does.
fn agrees_nearby(
    system: &MethodSystem,
    case: &Case,
    label: Label,
    sweep: &Sweep,
    stopping: Stopping,
) -> bool {
    NEARBY_SPEEDS.iter().all(|part| {
        let speed = part * case.conditions.surface_speed_rpm.unwrap_or_default();
        let conditions = case.conditions.with(Axis::SurfaceSpeedRpm, speed);
        let values = case.values.clone();
        let nearby = Case::under(sweep, &system.setting, case.index, values, &conditions);
        let verdict = nearby.ok().and_then(|mut nearby| {
            nearby.scene.timing = case.scene.timing;
            system.verdict(&nearby, stopping)
        });
        let of_bit = verdict.and_then(|verdict| verdict[Motion::Torsion]);
        of_bit.is_some_and(|verdict| verdict.label() == label)
    })
}

/// Adds what is to certify the labels of a case to its record: what the method says in shorter
/// steps and, where these agree with its own, of nearby speeds.
pub fn certify(
    system: &MethodSystem,
    case: &Case,
    options: RunOptions,
    sweep: &Sweep,
    record: &mut Record,
) {
    let stopping = options.stopping(case.index);
    record.finer = system.finer_verdict(case, stopping);
    let of_bit = |verdict: Verdict| verdict[Motion::Torsion].map(|it| it.label());
    let agreed = record.finer.and_then(of_bit);
    let label = of_bit(record.verdict()).filter(|it| agreed == Some(*it));
    record.agrees_nearby = label
        .filter(|_| looks_nearby(sweep, record.method))
        .map(|label| agrees_nearby(system, case, label, sweep, stopping));
}
