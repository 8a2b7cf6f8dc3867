//! `labels.csv` case by case: what all methods say of each.

use std::path::Path;

use anyhow::Result;

use super::label_row::LabelRow;
use super::label_rows::label_rows;
use campaign::quantities::Axis;
use campaign::records::Measure;
use sim::{Label, Motion, TorsionRegime};

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

/// How many of the methods of a case find what of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FoundByMethods {
    /// Sustained vibration.
    pub sustained: usize,
    /// That the start decides.
    pub bistable: usize,
    /// Snaking, which is less than sustained vibration.
    pub snaking: usize,
    /// Methods.
    pub methods: usize,
}

impl FoundByMethods {
    /// Of the labels by each method; none where one has no answer, or one that tells nothing.
    pub fn of(labels: impl Iterator<Item = Option<Label>>) -> Option<Self> {
        let mut found = Self {
            sustained: 0,
            bistable: 0,
            snaking: 0,
            methods: 0,
        };
        for label in labels {
            let label = label?;
            found.sustained += usize::from(label.is_sustained()?);
            found.bistable += usize::from(label == BISTABLE);
            found.snaking += usize::from(label.is_snaking());
            found.methods += 1;
        }
        Some(found)
    }
}

const BISTABLE: Label = Label::Torsion(TorsionRegime::Bistable);

impl CaseRows {
    /// What its methods find of a motion; none where one has no answer, or one that tells nothing.
    pub fn found(&self, motion: Motion) -> Option<FoundByMethods> {
        FoundByMethods::of(self.rows.iter().map(|row| row.labels[motion]))
    }

    /// Whether two methods that have an answer give different labels.
    pub fn differs(&self) -> bool {
        let rows = self.rows.iter().map(|row| row.labels);
        let mut answers = rows.filter(|labels| labels.is_answer());
        let first = answers.next();
        answers.any(|labels| Some(labels) != first)
    }

    /// Whether a method has a label of a motion.
    pub fn has(&self, motion: Motion) -> bool {
        (self.rows.iter()).any(|row| row.labels[motion].is_some())
    }
}

/// The cases of a `labels.csv` of which the values along `axes` are wanted; only one is in
/// memory at a time.
///
/// # Errors
/// Where it cannot be read or lacks a column; the message names file and line.
pub fn read_cases(
    path: &Path,
    axes: &[Axis],
) -> Result<impl Iterator<Item = Result<CaseRows>> + use<>> {
    read_measured_cases(path, axes, &[])
}

/// The same with some measures.
///
/// # Errors
/// As [`read_cases`].
pub fn read_measured_cases(
    path: &Path,
    axes: &[Axis],
    measures: &[Measure],
) -> Result<impl Iterator<Item = Result<CaseRows>> + use<>> {
    let mut rows = label_rows(path, axes, measures)?.peekable();
    Ok(std::iter::from_fn(move || {
        let first = rows.next()?;
        Some(first.map(|first| {
            let (case, values) = (first.case, first.values.clone());
            let is_next = |row: &Result<LabelRow>| row.as_ref().is_ok_and(|row| row.case == case);
            let others = std::iter::from_fn(|| rows.next_if(is_next)?.ok());
            let rows = std::iter::once(first).chain(others).collect();
            CaseRows { case, values, rows }
        }))
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Vec<Result<CaseRows>> {
        let file = tempfile::NamedTempFile::new().expect("a file");
        std::fs::write(file.path(), text).expect("written");
        let cases = read_cases(file.path(), &[Axis::FRICTION]).expect("a table");
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
