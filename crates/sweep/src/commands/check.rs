//! `sweep check`: the regression of regime labels.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use anyhow::{Result, bail};
use linear::estimates::{largest_undershoot, stick_slip_speed_limit};
use sim::Outcome;

use super::{Progress, Status, UsageError, build_systems, say, use_threads};
use crate::cli::CheckArguments;
use crate::engine::{Case, MethodSystem, Row, RowOutcome, run_cases};
use crate::output::{LabelRow, read_labels};
use crate::spec::{Sweep, check_setting};

/// Reruns the cases of a reference file and compares their labels.
pub fn check(arguments: &CheckArguments) -> Result<Status> {
    let mut sweep = Sweep::read(&arguments.file)?;
    let axes = sweep.design.axes().to_vec();
    let reference = read_labels(&arguments.reference, &axes)
        .map_err(|error| UsageError(format!("{error:#}")))?;
    if reference.is_empty() {
        bail!(UsageError(format!(
            "{} has no rows",
            arguments.reference.display()
        )));
    }
    keep_methods_of(&mut sweep, &reference, &arguments.reference)?;
    let cases = cases_of(&sweep, &reference, &arguments.reference)?;
    use_threads(arguments.jobs)?;
    let systems = build_systems(&arguments.file, &sweep, &cases)?;
    let progress = Progress::new(cases.len() * systems.len(), false);
    let rows = run_cases(&systems, &cases, || progress.tick());
    progress.finish();

    let found: BTreeMap<(usize, &str), &Row> = rows
        .iter()
        .map(|row| ((row.case, row.method), row))
        .collect();
    let mut different = 0;
    let mut text = String::new();
    for expected in &reference {
        let Some(row) = found.get(&(expected.case, expected.method.as_str())) else {
            continue;
        };
        for (expected_label, label) in [
            (&expected.torsion, label(row, torsion_label)),
            (&expected.lateral, label(row, lateral_label)),
        ] {
            // A label that the reference leaves out is not checked.
            if !expected_label.is_empty() && label != *expected_label {
                different += 1;
                text += &difference(&sweep, &systems, expected, expected_label, row, &label);
            }
        }
    }
    writeln!(
        text,
        "{}: {} of {} labels as expected",
        arguments.reference.display(),
        reference.len() - different,
        reference.len()
    )?;
    say(&text)?;
    Ok(if different == 0 {
        Status::Complete
    } else {
        Status::LabelsDiffer
    })
}

/// The reference says which methods it was made with.
fn keep_methods_of(sweep: &mut Sweep, reference: &[LabelRow], path: &Path) -> Result<()> {
    for row in reference {
        if !sweep
            .methods
            .iter()
            .any(|method| method.name() == row.method)
        {
            bail!(UsageError(format!(
                "{}:{}: the sweep has no method `{}`",
                path.display(),
                row.line,
                row.method
            )));
        }
    }
    sweep
        .methods
        .retain(|method| reference.iter().any(|row| row.method == method.name()));
    Ok(())
}

/// One case for each case number; its rows must agree on its values.
fn cases_of(sweep: &Sweep, reference: &[LabelRow], path: &Path) -> Result<Vec<Case>> {
    let mut cases: BTreeMap<usize, Case> = BTreeMap::new();
    for row in reference {
        let at = |reason: String| UsageError(format!("{}:{}: {reason}", path.display(), row.line));
        if row.torsion.is_empty() && row.lateral.is_empty() {
            bail!(at("has no label to compare with".to_owned()));
        }
        if let Some(case) = cases.get(&row.case) {
            if case.values != row.values {
                bail!(at(format!("case {} has other values above", row.case)));
            }
            continue;
        }
        let axes = sweep.design.axes();
        for (&axis, &value) in axes.iter().zip(&row.values) {
            check_setting(axis, value)
                .map_err(|reason| at(format!("{}: {reason}", axis.name())))?;
        }
        let conditions = sweep.conditions_at(&row.values);
        let case = Case::under(sweep, row.case, row.values.clone(), &conditions).map_err(at)?;
        cases.insert(row.case, case);
    }
    Ok(cases.into_values().collect())
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
    let distance = distance_to_limit(sweep, systems, expected, row)
        .map_or_else(String::new, |ratio| {
            format!(", at {ratio:.3} times the speed limit of Eq. 74")
        });
    format!(
        "case {} by {}: {}: expected {}, found {label}{distance}\n",
        expected.case,
        expected.method,
        values.join(", "),
        expected_label,
    )
}

/// Surface speed of a case over the analytic limit.
fn distance_to_limit(
    sweep: &Sweep,
    systems: &[MethodSystem],
    expected: &LabelRow,
    row: &Row,
) -> Option<f64> {
    let system = systems
        .iter()
        .find(|system| system.method.name() == row.method)?;
    let torques = sweep.bit.as_ref()?.torques(row.torque_dynamic_nm?);
    let limit = stick_slip_speed_limit(
        largest_undershoot(system.driving_point()?),
        torques.torque_static,
        torques.torque_dynamic,
    );
    let conditions = sweep.conditions_at(&expected.values);
    Some(conditions.surface_speed()? / limit)
}
