//! Writes the tables of a results folder from the log of its run, row by row.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use anyhow::Result;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use sim::Label;

use super::failures::{FAILURES_HEADER, Repeat, failures_row};
use super::labels::LabelTable;
use super::motion::{Labels, Motion};
use crate::engine::{Log, Record};
use crate::files::{AtomicFile, Checksum};
use crate::plan::Sweep;

/// What came out, counted.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Tally {
    /// Rows.
    pub rows: usize,
    /// Rows per method and label. A row of a scene with bit and wall has two labels,
    /// one of each motion.
    pub labels: BTreeMap<String, BTreeMap<Label, usize>>,
    /// Rows without an answer.
    pub failed: usize,
    /// Settled rows that were followed to the end, and those of them whose label
    /// changed.
    pub settled_checked: usize,
    /// See `settled_checked`.
    pub settled_wrong: usize,
}

impl Tally {
    /// Counts what a case is by a method: whether it failed, its labels, and the label
    /// predicted when motion settled.
    pub fn add(&mut self, method: &str, failed: bool, labels: Labels, predicted: Option<Label>) {
        self.rows += 1;
        self.failed += usize::from(failed);
        if let Some(predicted) = predicted {
            self.settled_checked += 1;
            self.settled_wrong += usize::from(labels.each().all(|label| label != predicted));
        }
        for label in labels.each() {
            let of_method = self.labels.entry(method.to_owned()).or_default();
            *of_method.entry(label).or_default() += 1;
        }
    }

    /// The motions that have labels; that of torsion where no case has any.
    pub fn motions(&self) -> Vec<Motion> {
        let labels = self.labels.values().flat_map(BTreeMap::keys);
        let found: BTreeSet<Motion> = labels.map(|label| Motion::of(*label)).collect();
        if found.is_empty() {
            vec![Motion::Torsion]
        } else {
            found.into_iter().collect()
        }
    }

    /// The labels of a method, each with its rows, in one list for each motion that
    /// has any: every list adds up to the cases with an answer.
    pub fn by_motion(&self, method: &str) -> Vec<(Motion, Vec<(&'static str, usize)>)> {
        let list = |motion: Motion| -> Vec<(&'static str, usize)> {
            let labels = self.labels.get(method).into_iter().flatten();
            labels
                .filter(|(label, _)| Motion::of(**label) == motion)
                .map(|(label, count)| (label.name(), *count))
                .collect()
        };
        let lists = Motion::ALL.into_iter().map(|motion| (motion, list(motion)));
        lists.filter(|(_, list)| !list.is_empty()).collect()
    }
}

/// The tables of a run, as they were written.
pub struct Tables {
    /// What came out, counted.
    pub tally: Tally,
    /// Checksums by name.
    pub files: BTreeMap<String, Checksum>,
}

/// Rows that all threads together format at once.
const ROWS_AT_ONCE: usize = 1 << 12;

/// `labels.csv` and `failures.csv` being written.
pub struct TableWriter<'a> {
    table: LabelTable<'a>,
    repeat: Repeat<'a>,
    labels: AtomicFile,
    failures: AtomicFile,
    tally: Tally,
}

impl<'a> TableWriter<'a> {
    /// Tables without a row.
    ///
    /// # Errors
    /// Where they cannot be written.
    pub fn create(table: LabelTable<'a>, repeat: Repeat<'a>, folder: &Path) -> Result<Self> {
        let mut labels = AtomicFile::create(&folder.join("labels.csv"))?;
        let mut failures = AtomicFile::create(&folder.join("failures.csv"))?;
        labels.write(format!("{}\n", table.header()).as_bytes())?;
        failures.write(format!("{FAILURES_HEADER}\n").as_bytes())?;
        Ok(Self {
            table,
            repeat,
            labels,
            failures,
            tally: Tally::default(),
        })
    }

    /// Adds rows, which come after those of earlier cases and methods.
    ///
    /// # Errors
    /// Where they cannot be written.
    pub fn add(&mut self, records: &[Record]) -> Result<()> {
        for records in records.chunks(ROWS_AT_ONCE) {
            let rows: Vec<String> = (records.par_iter())
                .map(|record| self.table.row(record) + "\n")
                .collect();
            self.labels.write(rows.concat().as_bytes())?;
            records.iter().try_for_each(|record| self.count(record))?;
        }
        Ok(())
    }

    fn count(&mut self, record: &Record) -> Result<()> {
        let method = self.table.methods[record.method];
        let (labels, predicted) = match &record.outcome {
            Ok(outcome) => (Labels::of(outcome), outcome.predicted),
            Err(reason) => {
                let command = self.repeat.command(record.case, method);
                let row = failures_row(record.case, method, reason.text(), &command)?;
                self.failures.write(&row)?;
                Default::default()
            }
        };
        (self.tally).add(method, record.outcome.is_err(), labels, predicted);
        Ok(())
    }

    /// Puts both tables in their place.
    ///
    /// # Errors
    /// Where they cannot be written.
    pub fn finish(self) -> Result<Tables> {
        let files = [
            ("labels.csv", self.labels.finish()?),
            ("failures.csv", self.failures.finish()?),
        ];
        Ok(Tables {
            tally: self.tally,
            files: files.map(|(name, sum)| (name.to_owned(), sum)).into(),
        })
    }
}

/// Writes `labels.csv` and `failures.csv`, in the order of cases and methods
/// however they were done.
///
/// # Errors
/// Where the log cannot be read or the tables cannot be written.
pub fn write_tables(sweep: &Sweep, repeat: Repeat, log: &Log, folder: &Path) -> Result<Tables> {
    let mut tables = TableWriter::create(LabelTable::of(sweep), repeat, folder)?;
    log.in_order(|records| tables.add(records))?;
    tables.finish()
}
