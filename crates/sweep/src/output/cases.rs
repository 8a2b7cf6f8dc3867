//! `labels.csv` case by case: what all methods say of each.

use std::iter::Peekable;
use std::path::Path;

use anyhow::Result;

use super::label_rows::{LabelReader, LabelRow};
use super::motion::Motion;
use crate::quantities::Axis;

/// The rows of one case.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseRows {
    /// Its number.
    pub case: usize,
    /// Values along the axes asked for.
    pub values: Vec<f64>,
    /// A row for each method.
    pub rows: Vec<LabelRow>,
}

impl CaseRows {
    /// Whether two methods that have an answer give different labels.
    pub fn differs(&self) -> bool {
        let rows = self.rows.iter().map(|row| row.labels);
        let mut answers = rows.filter(|labels| labels.is_answer());
        let first = answers.next();
        answers.any(|labels| Some(labels) != first)
    }

    /// Whether a method has a label of a motion.
    pub fn has(&self, motion: Motion) -> bool {
        (self.rows.iter()).any(|row| row.labels.get(motion).is_some())
    }
}

/// The cases of a `labels.csv`; only one is in memory at a time.
pub struct CaseReader {
    rows: Peekable<LabelReader>,
}

impl CaseReader {
    /// Opens a `labels.csv` of which the values along `axes` are wanted.
    ///
    /// # Errors
    /// Where it cannot be read or lacks a column.
    pub fn open(path: &Path, axes: &[Axis]) -> Result<Self> {
        let rows = LabelReader::open(path, axes)?.peekable();
        Ok(Self { rows })
    }
}

/// The message of an error names file and line.
impl Iterator for CaseReader {
    type Item = Result<CaseRows>;

    fn next(&mut self) -> Option<Self::Item> {
        let first = match self.rows.next()? {
            Ok(row) => row,
            Err(error) => return Some(Err(error)),
        };
        let case = first.case;
        let values = first.values.clone();
        let mut rows = vec![first];
        let is_of_case = |row: &Result<LabelRow>| row.as_ref().is_ok_and(|row| row.case == case);
        while let Some(Ok(row)) = self.rows.next_if(is_of_case) {
            rows.push(row);
        }
        Some(Ok(CaseRows { case, values, rows }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Vec<Result<CaseRows>> {
        let file = tempfile::NamedTempFile::new().expect("a file");
        std::fs::write(file.path(), text).expect("written");
        let cases = CaseReader::open(file.path(), &[Axis::Friction]).expect("a table");
        cases.collect()
    }

    #[test]
    fn the_rows_of_a_case_stay_together() {
        let cases = read(
            "case,method,friction,torsion,lateral\n\
             3,a,0.5,stuck,backward_whirl\n3,b,0.5,stuck,no_contact\n\
             4,a,1,,\n4,b,1,,no_contact\n5,a,2,smooth,\n5,b,2,smooth,\n",
        );
        let cases: Vec<CaseRows> = cases.into_iter().map(|case| case.expect("read")).collect();
        let numbers: Vec<_> = (cases.iter())
            .map(|case| (case.case, case.values[0], case.rows.len()))
            .collect();
        assert_eq!(numbers, [(3, 0.5, 2), (4, 1.0, 2), (5, 2.0, 2)]);
        let differ: Vec<_> = cases.iter().map(CaseRows::differs).collect();
        assert_eq!(differ, [true, false, false]);
        assert_eq!(cases[0].rows[0].labels.to_string(), "stuck, backward_whirl");
    }

    #[test]
    fn a_broken_row_is_named_by_its_line() {
        let cases = read("case,method,friction,torsion\n0,a,1,smooth\nx,a,1,smooth\n");
        let message = format!("{:#}", cases[1].as_ref().expect_err("no number"));
        assert!(
            message.contains(":3: `x` is not a case number"),
            "{message}"
        );
    }
}
