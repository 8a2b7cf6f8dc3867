//! The labels of a reference compared with those that were found.

use std::collections::BTreeMap;

use linear::estimates::{largest_undershoot, stick_slip_speed_limit};
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
pub struct ComparedLabel {
    /// Line of the reference.
    pub line: usize,
    /// Number of its case.
    pub case: usize,
    /// Name of the method.
    pub method: String,
    /// What the label is about.
    pub motion: Motion,
    /// The axes of the case with their values, in words.
    pub values: String,
    /// What was expected and what was found, in words, where they differ.
    pub difference: Option<String>,
}

/// Compares every label of the reference with the one that was found.
pub fn compare(
    sweep: &Sweep,
    systems: &[MethodSystem],
    reference: &[LabelRow],
    found: &FoundRecords,
) -> Vec<ComparedLabel> {
    let mut compared = Vec::new();
    for expected in reference {
        let Some(record) = found.get(&(expected.case, expected.method.as_str())) else {
            continue;
        };
        // A label that the reference leaves out is not checked.
        for expected_label in expected.labels.each() {
            let motion = expected_label.motion();
            let label = label(record, motion);
            let differs = label != expected_label.name();
            let difference =
                || difference(sweep, systems, expected, expected_label, record, &label);
            compared.push(ComparedLabel {
                line: expected.line,
                case: expected.case,
                method: expected.method.clone(),
                motion,
                values: values(sweep, expected),
                difference: differs.then(difference),
            });
        }
    }
    compared
}

fn label(record: &Record, motion: Motion) -> String {
    match &record.outcome {
        Ok(outcome) => {
            let label = outcome.labels()[motion];
            label.map_or("none", Label::name).to_owned()
        }
        Err(reason) => format!("failed ({reason})"),
    }
}

fn values(sweep: &Sweep, expected: &LabelRow) -> String {
    let values: Vec<String> = (sweep.design.axes().iter())
        .zip(&expected.values)
        .map(|(axis, value)| format!("{} = {value}", axis.name()))
        .collect();
    values.join(", ")
}

/// What is said of a label that differs.
fn difference(
    sweep: &Sweep,
    systems: &[MethodSystem],
    expected: &LabelRow,
    expected_label: Label,
    record: &Record,
    label: &str,
) -> String {
    // Each string has its own limit, and only that of the file is at hand.
    let distance = match expected_label.motion() {
        _ if sweep.design.varies_string() => None,
        Motion::Torsion => distance_in_torsion(sweep, systems, expected, record),
        Motion::Lateral => distance_of_whirl(sweep, expected),
    };
    format!(
        "expected {}, found {label}{}",
        expected_label.name(),
        distance.unwrap_or_default()
    )
}

/// Where a case is in relation to the analytic limit of whirl, in words.
fn distance_of_whirl(sweep: &Sweep, expected: &LabelRow) -> Option<String> {
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
    Some(format!(
        ", at {ratio:.3} times the least friction of steady rolling whirl"
    ))
}

/// Where a case is in relation to the analytic limit of stick-slip, in words.
fn distance_in_torsion(
    sweep: &Sweep,
    systems: &[MethodSystem],
    expected: &LabelRow,
    record: &Record,
) -> Option<String> {
    let system = systems.get(record.method)?;
    let conditions = sweep.conditions_at(&expected.values);
    let torques = conditions.torques(record.torque_dynamic_nm?);
    let limit = stick_slip_speed_limit(
        largest_undershoot(system.driving_point()?),
        torques.torque_static,
        torques.torque_dynamic,
    );
    let ratio = conditions.surface_speed()? / limit;
    Some(format!(", at {ratio:.3} times the speed limit of Eq. 74"))
}
