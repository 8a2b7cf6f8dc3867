//! Compares two results folders: which labels differ where the same cases were run.

use anyhow::Result;
use thiserror::Error;

use super::results::Results;
use campaign::quantities::Unit;
use campaign::words::short;
use results::folder::{CaseRows, read_cases};

/// Differing labels that are kept to be listed.
const MOST_LISTED: usize = 30;

/// Why two folders are not of the same cases.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum Unlike {
    /// Their axes differ.
    #[error("their axes are different")]
    Axes,
    /// A case has other values along them.
    #[error("case {0} has other values")]
    Values(usize),
    /// They have no row in common.
    #[error("no case was answered by the same method in both")]
    NoneInCommon,
}

/// What two folders say of the cases that both answer.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FolderComparison {
    /// Rows of the same case and method with an answer in both.
    pub rows: usize,
    /// Those of them whose labels are not the same.
    pub different: usize,
    /// The first of these: case, method, values along the axes, and the labels in the one
    /// folder and in the other.
    pub listed: Vec<Vec<String>>,
}

/// Compares two folders case by case; or why they are known not to have run the same
/// cases.
///
/// # Errors
/// Where their labels cannot be read.
pub fn compare(one: &Results, other: &Results) -> Result<Result<FolderComparison, Unlike>> {
    if one.manifest.axes != other.manifest.axes {
        return Ok(Err(Unlike::Axes));
    }
    let mut compared = FolderComparison::default();
    let axes = one.manifest.axes.iter();
    let units: Vec<Unit> = axes
        .map(|axis| axis.unit(one.manifest.sweep.units))
        .collect();
    let cases = |of: &Results| read_cases(&of.tables.folder.join("labels.csv"), &one.manifest.axes);
    let mut others = cases(other)?;
    let mut theirs = others.next().transpose()?;
    for ours in cases(one)? {
        let ours = ours?;
        // A shard has only some of the cases.
        let is_before = |theirs: &CaseRows| theirs.case < ours.case;
        while theirs.as_ref().is_some_and(is_before) {
            theirs = others.next().transpose()?;
        }
        let Some(theirs) = theirs.as_ref().filter(|theirs| theirs.case == ours.case) else {
            continue;
        };
        if theirs.values != ours.values {
            return Ok(Err(Unlike::Values(ours.case)));
        }
        compared.add(&ours, theirs, &units);
    }
    if compared.rows == 0 {
        return Ok(Err(Unlike::NoneInCommon));
    }
    Ok(Ok(compared))
}

impl FolderComparison {
    /// Adds a case, with values in the `units` of the axes.
    fn add(&mut self, ours: &CaseRows, theirs: &CaseRows, units: &[Unit]) {
        for our in ours.rows.iter().filter(|row| row.labels.is_answer()) {
            let mut answers = theirs.rows.iter().filter(|row| row.labels.is_answer());
            let Some(their) = answers.find(|row| row.method == our.method) else {
                continue;
            };
            self.rows += 1;
            if our.labels == their.labels {
                continue;
            }
            self.different += 1;
            if self.listed.len() < MOST_LISTED {
                let values = ours.values.iter().zip(units);
                let values = values.map(|(&value, unit)| short(unit.number(value)));
                let labels = [our.labels.to_string(), their.labels.to_string()];
                let case = [ours.case.to_string(), our.method.clone()];
                let cells = case.into_iter().chain(values).chain(labels);
                self.listed.push(cells.collect());
            }
        }
    }
}
