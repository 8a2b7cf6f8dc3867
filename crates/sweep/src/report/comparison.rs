//! Compares two results folders: which labels differ where the same cases were run.

use anyhow::Result;

use super::results::Results;
use crate::output::{CaseReader, CaseRows};

/// Differing labels that are kept to be listed.
const MOST_LISTED: usize = 30;

/// What two folders say of the same cases.
#[derive(Debug, Clone, PartialEq)]
pub enum Comparison {
    /// They did not run the same cases; why that is known.
    OtherCases(String),
    /// They did, at least in part.
    SameCases(Compared),
}

/// What two folders say of the cases that both answer.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Compared {
    /// Rows of the same case and method with an answer in both.
    pub rows: usize,
    /// Those of them whose labels are not the same.
    pub different: usize,
    /// The first of these.
    pub listed: Vec<Difference>,
}

/// A case and method that has another label in another folder.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// Number of the case.
    pub case: usize,
    /// Name of the method.
    pub method: String,
    /// Values along the axes.
    pub values: Vec<f64>,
    /// The labels in the one folder and in the other.
    pub regimes: [String; 2],
}

impl Comparison {
    /// Of two folders, case by case.
    ///
    /// # Errors
    /// Where their labels cannot be read.
    pub fn of(one: &Results, other: &Results) -> Result<Self> {
        if one.manifest.axes != other.manifest.axes {
            return Ok(Self::OtherCases("their axes are different".to_owned()));
        }
        let mut compared = Compared::default();
        let cases = |of: &Results| CaseReader::open(&of.tables.labels(), &one.manifest.axes);
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
                let case = ours.case;
                return Ok(Self::OtherCases(format!("case {case} has other values")));
            }
            compared.add(&ours, theirs);
        }
        if compared.rows == 0 {
            let why = "no case was answered by the same method in both";
            return Ok(Self::OtherCases(why.to_owned()));
        }
        Ok(Self::SameCases(compared))
    }
}

impl Compared {
    fn add(&mut self, ours: &CaseRows, theirs: &CaseRows) {
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
                self.listed.push(Difference {
                    case: ours.case,
                    method: our.method.clone(),
                    values: ours.values.clone(),
                    regimes: [our.labels.to_string(), their.labels.to_string()],
                });
            }
        }
    }
}
