//! The labels of a reference beside those that were found.

use std::collections::BTreeMap;
use std::path::Path;

use linear::estimates::{largest_undershoot, stick_slip_speed_limit};
use sim::Outcome;

use crate::engine::{MethodSystem, Row, RowOutcome};
use crate::output::{LabelRow, rolling_bound};
use crate::plan::Sweep;
use crate::words::counted;

/// Rows by the reference's numbers of cases and by method.
pub type Found = BTreeMap<(usize, &'static str), Row>;

/// What came out of a comparison.
pub struct Compared {
    /// How many labels the reference has.
    labels: usize,
    /// A line about each that differs.
    pub different: Vec<String>,
}

impl Compared {
    /// In lines, for the reference at `path`.
    pub fn text(&self, path: &Path) -> String {
        format!(
            "{}{}: {} of {} as expected\n",
            self.different.concat(),
            path.display(),
            self.labels - self.different.len(),
            counted(self.labels, "label")
        )
    }
}

/// Compares every label of the reference with the one that was found.
pub fn compare(
    sweep: &Sweep,
    systems: &[MethodSystem],
    reference: &[LabelRow],
    found: &Found,
) -> Compared {
    let mut labels = 0;
    let mut different = Vec::new();
    for expected in reference {
        let Some(row) = found.get(&(expected.case, expected.method.as_str())) else {
            continue;
        };
        for (expected_label, label) in [
            (&expected.torsion, label(row, torsion_label)),
            (&expected.lateral, label(row, lateral_label)),
        ] {
            // A label that the reference leaves out is not checked.
            if !expected_label.is_empty() {
                labels += 1;
                if label != *expected_label {
                    different.push(difference(
                        sweep,
                        systems,
                        expected,
                        expected_label,
                        row,
                        &label,
                    ));
                }
            }
        }
    }
    Compared { labels, different }
}

fn label(row: &Row, of: fn(&Outcome) -> Option<&'static str>) -> String {
    match &row.outcome {
        RowOutcome::Done(outcome) => of(outcome).unwrap_or_default().to_owned(),
        RowOutcome::Failed(reason) => format!("failed ({reason})"),
    }
}

fn torsion_label(outcome: &Outcome) -> Option<&'static str> {
    outcome.torsion.map(|torsion| torsion.regime.name())
}

fn lateral_label(outcome: &Outcome) -> Option<&'static str> {
    outcome.lateral.map(|lateral| lateral.regime.name())
}

/// A line about a label that differs.
fn difference(
    sweep: &Sweep,
    systems: &[MethodSystem],
    expected: &LabelRow,
    expected_label: &str,
    row: &Row,
    label: &str,
) -> String {
    let values: Vec<String> = (sweep.design.axes().iter())
        .zip(&expected.values)
        .map(|(axis, value)| format!("{} = {value}", axis.name()))
        .collect();
    let distance = distance_to_limit(sweep, systems, expected, row).unwrap_or_default();
    format!(
        "case {} by {}: {}: expected {}, found {label}{distance}\n",
        expected.case,
        expected.method,
        values.join(", "),
        expected_label,
    )
}

/// Where a case is in relation to the analytic limit, in words.
fn distance_to_limit(
    sweep: &Sweep,
    systems: &[MethodSystem],
    expected: &LabelRow,
    row: &Row,
) -> Option<String> {
    let conditions = sweep.conditions_at(&expected.values);
    if let (Some(lateral), Some(friction)) = (&sweep.setting.lateral, conditions.friction) {
        let speed = conditions.surface_speed_rpm?;
        let bound = rolling_bound(&sweep.setting, lateral, speed)
            .ok()
            .flatten()?;
        let ratio = friction / bound;
        return Some(format!(
            ", at {ratio:.3} times the least friction of steady rolling whirl"
        ));
    }
    let system = (systems.iter()).find(|system| system.method.name() == row.method)?;
    let torques = sweep.bit.as_ref()?.torques(row.torque_dynamic_nm?);
    let limit = stick_slip_speed_limit(
        largest_undershoot(system.driving_point()?),
        torques.torque_static,
        torques.torque_dynamic,
    );
    let ratio = conditions.surface_speed()? / limit;
    Some(format!(", at {ratio:.3} times the speed limit of Eq. 74"))
}
