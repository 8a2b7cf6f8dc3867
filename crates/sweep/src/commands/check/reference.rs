//! The reference: labels of cases of a sweep, by some of its methods.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Result, bail};
use linear::Method;
use sim::{LateralRegime, TorsionRegime};

use crate::commands::status::UsageError;
use crate::engine::Case;
use crate::output::{LabelRow, read_labels};
use crate::plan::Sweep;
use crate::sweep_file::nearest;

/// Reads the reference, and which of the sweep's methods it has.
///
/// # Errors
/// Where it has no rows, or methods that the sweep has not.
pub fn read_reference(path: &Path, sweep: &Sweep) -> Result<(Vec<LabelRow>, Vec<Method>)> {
    let reference =
        read_labels(path, sweep.design.axes()).map_err(|error| UsageError(format!("{error:#}")))?;
    if reference.is_empty() {
        bail!(UsageError(format!("{} has no rows", path.display())));
    }
    let methods = methods_of(sweep, &reference, path)?;
    Ok((reference, methods))
}

/// The reference says which methods it was made with.
fn methods_of(sweep: &Sweep, reference: &[LabelRow], path: &Path) -> Result<Vec<Method>> {
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
    let is_named = |method: &&Method| reference.iter().any(|row| row.method == method.name());
    Ok(sweep.methods.iter().filter(is_named).copied().collect())
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
    let torsion = TorsionRegime::ALL.map(TorsionRegime::name);
    let lateral = LateralRegime::ALL.map(LateralRegime::name);
    let mut cases: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for row in reference {
        let at = |reason: String| UsageError(format!("{}:{}: {reason}", path.display(), row.line));
        if row.torsion.is_empty() && row.lateral.is_empty() {
            bail!(at("has no label to compare with".to_owned()));
        }
        refuse_unknown("torsion", &row.torsion, &torsion).map_err(at)?;
        refuse_unknown("lateral", &row.lateral, &lateral).map_err(at)?;
        let axes = sweep.design.axes();
        for (&axis, &value) in axes.iter().zip(&row.values) {
            axis.check(value)
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

/// A word that is none of the regimes is a mistake in the reference, and no label
/// that differs.
fn refuse_unknown(column: &str, label: &str, known: &[&str]) -> Result<(), String> {
    if label.is_empty() || known.contains(&label) {
        return Ok(());
    }
    let hint = nearest(label, known).map_or_else(
        || format!("known: {}", known.join(", ")),
        |known| format!("did you mean `{known}`?"),
    );
    Err(format!("{column}: `{label}` is no {column} regime; {hint}"))
}
