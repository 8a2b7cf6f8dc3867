//! `sweep check`: the regression of regime labels.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::sync::Mutex;

use anyhow::{Result, bail};
use linear::estimates::{largest_undershoot, stick_slip_speed_limit};
use sim::Label;

use super::{
    Progress, Status, UsageError, build_systems, choose, say, survey_cases, use_threads,
    warn_of_unstable,
};
use crate::cli::CheckArguments;
use crate::design::{Design, List};
use crate::engine::{Case, MethodSystem, Record, RunOptions, Shard, Work};
use crate::memory::{Purpose, admit};
use crate::output::{LabelRow, Labels, Motion, read_labels, rolling_bound};
use crate::sweep_file::{Sweep, check_setting};
use crate::words::counted;

/// Reruns the cases of a reference file and compares their labels.
pub fn check(arguments: &CheckArguments) -> Result<Status> {
    use_threads(arguments.jobs)?;
    let mut sweep = Sweep::read(&arguments.file)?;
    let limit = arguments.memory.limit();
    choose(&mut sweep, false, &limit, false)?;
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
    let numbers: Vec<usize> = cases.keys().copied().collect();
    sweep.design = Design::List(List::new(axes, cases.into_values().collect()));
    let survey = survey_cases(&arguments.reference, &sweep)?;
    let setting = sweep.setting.for_labels();
    let memory = admit(&sweep, &setting, &survey, Purpose::Labels, &limit)?;
    let systems = build_systems(&arguments.file, &sweep, &setting, survey.longest)?;
    warn_of_unstable(&systems);
    let found = run_all(&sweep, &systems, &numbers, memory.strings_at_once)?;

    let mut different = 0;
    let mut labels = 0;
    let mut text = String::new();
    for expected in &reference {
        let Some(record) = found.get(&(expected.case, expected.method.as_str())) else {
            continue;
        };
        // A label that the reference leaves out is not checked.
        for expected_label in expected.labels.each() {
            let label = label(record, Motion::of(expected_label));
            labels += 1;
            if label != expected_label.name() {
                different += 1;
                text += &difference(&sweep, &systems, expected, expected_label, record, &label);
            }
        }
    }
    writeln!(
        text,
        "{}: {} of {} as expected",
        arguments.reference.display(),
        labels - different,
        counted(labels, "label")
    )?;
    say(&text)?;
    Ok(if different == 0 {
        Status::Complete
    } else {
        Status::LabelsDiffer
    })
}

/// The rows of all cases, by the reference's numbers and by method.
fn run_all(
    sweep: &Sweep,
    systems: &[MethodSystem],
    numbers: &[usize],
    strings_at_once: usize,
) -> Result<BTreeMap<(usize, &'static str), Record>> {
    let found = Mutex::new(BTreeMap::new());
    let progress = Progress::new(numbers.len() * systems.len(), 0, false);
    let work = Work {
        sweep,
        shard: Shard::WHOLE,
        options: RunOptions {
            full: false,
            allow_unstable: true,
        },
        strings_at_once,
        is_open: &|_, _| true,
        stops: &|| false,
    };
    let keep = |record: Record| {
        if let Ok(mut found) = found.lock() {
            let method = sweep.methods[record.method].name();
            found.insert((numbers[record.case], method), record);
        }
        progress.tick();
        Ok(())
    };
    work.run(systems, &keep)?;
    progress.finish();
    Ok(found.into_inner().unwrap_or_default())
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

/// The values of each case number; its rows must agree on them.
fn cases_of(
    sweep: &Sweep,
    reference: &[LabelRow],
    path: &Path,
) -> Result<BTreeMap<usize, Vec<f64>>> {
    let mut cases: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for row in reference {
        let at = |reason: String| UsageError(format!("{}:{}: {reason}", path.display(), row.line));
        if !row.labels.is_answer() {
            bail!(at("has no label to compare with".to_owned()));
        }
        let axes = sweep.design.axes();
        for (&axis, &value) in axes.iter().zip(&row.values) {
            check_setting(axis, value)
                .map_err(|reason| at(format!("{}: {reason}", axis.name())))?;
        }
        let setting = sweep
            .setting_at(&row.values)
            .map_err(|error| at(error.to_string()))?;
        let conditions = sweep.conditions_at(&row.values);
        let case = Case::under(sweep, &setting, row.case, row.values.clone(), &conditions);
        sweep.impulses_are_felt(row.case, case.map_err(at)?.scene.timing.duration)?;
        if *cases.entry(row.case).or_insert_with(|| row.values.clone()) != row.values {
            bail!(at(format!("case {} has other values above", row.case)));
        }
    }
    Ok(cases)
}

fn label(record: &Record, motion: Motion) -> String {
    match &record.outcome {
        Ok(outcome) => Labels::of(outcome)
            .get(motion)
            .map_or_else(String::new, |label| label.name().to_owned()),
        Err(reason) => format!("failed ({reason})"),
    }
}

fn difference(
    sweep: &Sweep,
    systems: &[MethodSystem],
    expected: &LabelRow,
    expected_label: Label,
    record: &Record,
    label: &str,
) -> String {
    let values: Vec<String> = (sweep.design.axes().iter())
        .zip(&expected.values)
        .map(|(axis, value)| format!("{} = {value}", axis.name()))
        .collect();
    let distance = distance_to_limit(sweep, systems, expected, record).unwrap_or_default();
    format!(
        "case {} by {}: {}: expected {}, found {label}{distance}\n",
        expected.case,
        expected.method,
        values.join(", "),
        expected_label.name(),
    )
}

/// Where a case is in relation to the analytic limit, in words.
fn distance_to_limit(
    sweep: &Sweep,
    systems: &[MethodSystem],
    expected: &LabelRow,
    record: &Record,
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
    let system = systems.get(record.method)?;
    let torques = sweep.bit.as_ref()?.torques(record.torque_dynamic_nm?);
    let limit = stick_slip_speed_limit(
        largest_undershoot(system.driving_point()?),
        torques.torque_static,
        torques.torque_dynamic,
    );
    let ratio = conditions.surface_speed()? / limit;
    Some(format!(", at {ratio:.3} times the speed limit of Eq. 74"))
}
