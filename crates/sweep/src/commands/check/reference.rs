//! The reference: labels of cases of a sweep, by some methods.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::path::Path;

use anyhow::{Result, bail};
use clap::ValueEnum;
use linear::Method;

use crate::commands::input::read_text;
use crate::commands::status::UsageError;
use campaign::engine::Case;
use campaign::plan::Sweep;
use campaign::sweep_file::MethodName;
use results::folder::{LabelRow, read_labels};

/// Reads the reference, and the methods it has: the sweep's, and others with the parameters
/// that its `file` gives them, unless that asks for an accuracy.
///
/// # Errors
/// Where it has no rows, or methods that there are not.
pub fn read_reference(
    path: &Path,
    file: &Path,
    sweep: &Sweep,
) -> Result<(Vec<LabelRow>, Vec<Method>)> {
    let reference =
        read_labels(path, sweep.design.axes()).map_err(|error| UsageError(format!("{error:#}")))?;
    if reference.is_empty() {
        bail!(UsageError(format!("{} has no rows", path.display())));
    }
    let mut others: Vec<MethodName> = Vec::new();
    for row in &reference {
        if sweep
            .methods
            .iter()
            .any(|method| method.name() == row.method)
            || others.iter().any(|method| method.name() == row.method)
        {
            continue;
        }
        match MethodName::from_str(&row.method, false) {
            Ok(method) if sweep.choice.is_none() => others.push(method),
            _ => bail!(UsageError(format!(
                "{}:{}: the sweep has no method `{}`",
                path.display(),
                row.line,
                row.method
            ))),
        }
    }
    let is_named = |method: &&Method| reference.iter().any(|row| row.method == method.name());
    let mut methods: Vec<Method> = sweep.methods.iter().filter(is_named).copied().collect();
    if !others.is_empty() {
        methods.extend(Sweep::read_from(file, &others, &read_text)?.methods);
    }
    Ok((reference, methods))
}

/// The values of each case number; its rows must agree on them.
///
/// # Errors
/// The line that does not make sense.
pub fn cases_of(
    sweep: &Sweep,
    reference: &[LabelRow],
    path: &Path,
) -> Result<BTreeMap<usize, Vec<f64>>> {
    let mut cases: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for row in reference {
        let at =
            |reason: &dyn Display| UsageError(format!("{}:{}: {reason}", path.display(), row.line));
        if !row.labels.is_answer() {
            bail!(at(&"has no label to compare with"));
        }
        let axes = sweep.design.axes();
        for (&axis, &value) in axes.iter().zip(&row.values) {
            axis.check(value)
                .map_err(|reason| at(&format_args!("{}: {reason}", axis.name())))?;
        }
        let setting = (sweep.setting_at(&row.values)).map_err(|error| at(&error))?;
        let conditions = sweep.conditions_at(&row.values);
        let case = Case::under(sweep, &setting, row.case, row.values.clone(), &conditions)
            .map_err(|error| at(&error))?;
        sweep.impulses_are_felt(row.case, case.scene.timing.duration)?;
        if *cases.entry(row.case).or_insert_with(|| row.values.clone()) != row.values {
            bail!(at(&format_args!(
                "case {} has other values above",
                row.case
            )));
        }
    }
    Ok(cases)
}
