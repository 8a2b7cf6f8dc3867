//! The labels of a reference compared with those that were found.

use std::collections::BTreeMap;
use std::fmt;

use linear::estimates::{largest_undershoot, stick_slip_speed_limit};
use serde::{Serialize, Serializer};
use sim::{Label, Motion};

use campaign::engine::MethodSystem;
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::records::Record;
use limits::rolling_bound;
use results::folder::LabelRow;

/// Rows by the reference's numbers of cases and by method.
pub type FoundRecords = BTreeMap<(usize, &'static str), Record>;

/// A label of the reference and the one that was found.
#[derive(Serialize)]
pub struct ComparedLabel {
    /// Line of the reference.
    pub line: usize,
    /// Number of its case.
    pub case: usize,
    /// Name of the method.
    pub method: String,
    /// What the label is about.
    pub motion: Motion,
    /// The values of the case.
    #[serde(serialize_with = "by_name")]
    pub values: Vec<(Axis, f64)>,
    /// The label of the reference.
    pub expected: Label,
    /// The label that was found; none where the case has no answer, or its scene no such label.
    pub found: Option<Label>,
    /// Why the case has no answer.
    pub failure: Option<String>,
    /// How far a case whose label differs is from the limit of its motion, where all cases share
    /// a string.
    pub distance: Option<Distance>,
}

/// Where a case is, in multiples of a speed or a friction that is known without a simulation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Distance {
    /// Surface speed in multiples of the one-slip estimate of stick-slip, Eq. 74.
    TimesSpeedLimit(f64),
    /// Of the least friction of steady rolling whirl.
    TimesRollingFriction(f64),
}

impl fmt::Display for Distance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Distance::TimesSpeedLimit(ratio) => {
                write!(f, "at {ratio:.3} times the speed of Eq. 74")
            }
            Distance::TimesRollingFriction(ratio) => {
                write!(
                    f,
                    "at {ratio:.3} times the least friction of steady rolling whirl"
                )
            }
        }
    }
}

impl ComparedLabel {
    /// Whether another label was found than expected, or none.
    pub fn differs(&self) -> bool {
        self.found != Some(self.expected)
    }

    /// The axes of the case with their values, in words.
    pub fn place(&self) -> String {
        let values = self.values.iter();
        let words = values.map(|(axis, value)| format!("{} = {value}", axis.name()));
        words.collect::<Vec<_>>().join(", ")
    }

    /// What was expected and what was found, in words, where they differ.
    pub fn difference(&self) -> Option<String> {
        let found = match (&self.failure, self.found) {
            (Some(reason), _) => format!("failed ({reason})"),
            (None, found) => found.map_or("none", Label::name).to_owned(),
        };
        let distance = self
            .distance
            .map_or_else(String::new, |it| format!(", {it}"));
        let expected = self.expected.name();
        (self.differs()).then(|| format!("expected {expected}, found {found}{distance}"))
    }
}

fn by_name<S: Serializer>(values: &[(Axis, f64)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(values.iter().map(|(axis, value)| (axis.name(), value)))
}

/// Compares every label of the reference with the one that was found.
pub fn compare(
    sweep: &Sweep,
    systems: &[MethodSystem],
    reference: &[LabelRow],
    found: &FoundRecords,
) -> Vec<ComparedLabel> {
    let mut compared = Vec::new();
    for row in reference {
        let Some(record) = found.get(&(row.case, row.method.as_str())) else {
            continue;
        };
        // A label that the reference leaves out is not checked.
        for expected in row.labels.each() {
            let motion = expected.motion();
            let outcome = record.outcome.as_ref();
            let values = sweep.design.axes().iter().zip(&row.values);
            let mut label = ComparedLabel {
                line: row.line,
                case: row.case,
                method: row.method.clone(),
                motion,
                values: values.map(|(axis, value)| (*axis, *value)).collect(),
                expected,
                found: outcome.ok().and_then(|outcome| outcome.labels()[motion]),
                failure: outcome.err().map(ToString::to_string),
                distance: None,
            };
            if label.differs() {
                label.distance = distance(sweep, systems, row, motion, record);
            }
            compared.push(label);
        }
    }
    compared
}

/// Where a case is in relation to the limit of a motion.
fn distance(
    sweep: &Sweep,
    systems: &[MethodSystem],
    row: &LabelRow,
    motion: Motion,
    record: &Record,
) -> Option<Distance> {
    match motion {
        // Each string has its own limit, and only that of the file is at hand.
        _ if sweep.design.varies_string() => None,
        Motion::Torsion => distance_in_torsion(sweep, systems, row, record),
        Motion::Lateral => distance_of_whirl(sweep, row),
        // None is known in closed form.
        Motion::Axial => None,
    }
}

/// Where a case is in relation to the analytic limit of whirl.
fn distance_of_whirl(sweep: &Sweep, expected: &LabelRow) -> Option<Distance> {
    let conditions = sweep.conditions_at(&expected.values);
    let lateral = sweep.setting.lateral.as_ref()?;
    // Each wall has its own limit, and only that of the file is at hand.
    if sweep
        .design
        .axes()
        .iter()
        .any(|axis| axis.changes_whirl_limit())
    {
        return None;
    }
    let bound = rolling_bound(&sweep.setting, lateral, conditions.surface_speed_rpm?);
    let ratio = conditions.value(Axis::FRICTION)? / bound.ok().flatten()?;
    Some(Distance::TimesRollingFriction(ratio))
}

/// Where a case is in relation to the one-slip estimate of stick-slip, Eq. 74.
fn distance_in_torsion(
    sweep: &Sweep,
    systems: &[MethodSystem],
    expected: &LabelRow,
    record: &Record,
) -> Option<Distance> {
    let system = systems.get(record.method)?;
    if !system.setting.has_stick_slip_limit() {
        return None;
    }
    let conditions = sweep.conditions_at(&expected.values);
    let torques = conditions.torques(record.torque_dynamic_nm?);
    let limit = stick_slip_speed_limit(
        largest_undershoot(system.driving_point()?),
        torques.torque_static,
        torques.torque_dynamic,
    );
    let ratio = conditions.surface_speed()? / limit;
    Some(Distance::TimesSpeedLimit(ratio))
}
