//! From the log of a finished run to the tables of its results folder, row by
//! row.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};

use super::failures::{FAILURES_HEADER, Repeat, failures_row};
use super::labels::labels_header;
use super::motion::Motion;
use crate::engine::Log;
use crate::files::{AtomicFile, Checksum};
use crate::plan::Sweep;

/// What came out, counted.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Tally {
    /// Rows.
    pub rows: usize,
    /// Rows per method and label. A row of a scene with bit and wall has two labels,
    /// one of each motion.
    pub labels: BTreeMap<String, BTreeMap<String, usize>>,
    /// Rows without an answer.
    pub failed: usize,
    /// Settled rows that were followed to the end, and those of them whose label
    /// changed.
    pub settled_checked: usize,
    /// See `settled_checked`.
    pub settled_wrong: usize,
}

impl Tally {
    /// The motions that have labels; that of torsion where no case has any.
    pub fn motions(&self) -> Vec<Motion> {
        let has = |motion: &Motion| {
            let mut labels = self.labels.values().flat_map(BTreeMap::keys);
            labels.any(|label| motion.labels().contains(&label.as_str()))
        };
        let found: Vec<Motion> = Motion::ALL.into_iter().filter(has).collect();
        if found.is_empty() {
            vec![Motion::Torsion]
        } else {
            found
        }
    }

    /// The labels of a method, each with its rows, in one list for each motion that
    /// has any: every list adds up to the cases with an answer.
    pub fn by_motion(&self, method: &str) -> Vec<(Motion, Vec<(&str, usize)>)> {
        let list = |motion: Motion| -> Vec<(&str, usize)> {
            let labels = self.labels.get(method).into_iter().flatten();
            labels
                .filter(|(label, _)| motion.labels().contains(&label.as_str()))
                .map(|(label, count)| (label.as_str(), *count))
                .collect()
        };
        let lists = Motion::ALL.into_iter().map(|motion| (motion, list(motion)));
        lists.filter(|(_, list)| !list.is_empty()).collect()
    }
}

/// Where the fields to count are in a row.
pub struct Counted {
    method: usize,
    labels: [usize; 2],
    predicted: usize,
    status: usize,
}

impl Counted {
    /// From the header of `labels.csv`.
    ///
    /// # Errors
    /// Where it is not one.
    pub fn new(header: &str) -> Result<Self> {
        let place = |name: &str| {
            let found = header.split(',').position(|field| field == name);
            found.with_context(|| format!("`labels.csv` has no column `{name}`"))
        };
        Ok(Self {
            method: place("method")?,
            labels: [place("torsion")?, place("lateral")?],
            // As version 0.1.0 called it.
            predicted: place("predicted").or_else(|_| place("foretold"))?,
            status: place("status")?,
        })
    }

    /// Adds a row of `labels.csv` to what came out.
    pub fn add(&self, row: &str, tally: &mut Tally) {
        let fields: Vec<&str> = row.split(',').collect();
        let field = |place: usize| fields.get(place).copied().unwrap_or_default();
        tally.rows += 1;
        tally.failed += usize::from(field(self.status) == "failed");
        let (labels, predicted) = (self.labels.map(field), field(self.predicted));
        if !predicted.is_empty() {
            tally.settled_checked += 1;
            tally.settled_wrong += usize::from(!labels.contains(&predicted));
        }
        for label in labels {
            if !label.is_empty() {
                let method = tally.labels.entry(field(self.method).to_owned());
                *method.or_default().entry(label.to_owned()).or_default() += 1;
            }
        }
    }
}

/// The tables of a run, as they were written.
pub struct Tables {
    /// What came out, counted.
    pub tally: Tally,
    /// Checksums by name.
    pub files: BTreeMap<String, Checksum>,
}

/// Writes `labels.csv` and `failures.csv`, in the order of cases and methods
/// however they were done.
///
/// # Errors
/// Where the log cannot be read or the tables cannot be written.
pub fn write_tables(sweep: &Sweep, repeat: &Repeat, log: &Log, folder: &Path) -> Result<Tables> {
    let header = labels_header(sweep);
    let counted = Counted::new(&header)?;
    let mut tally = Tally::default();
    let mut labels = AtomicFile::create(&folder.join("labels.csv"))?;
    let mut failures = AtomicFile::create(&folder.join("failures.csv"))?;
    labels.write(format!("{header}\n").as_bytes())?;
    failures.write(format!("{FAILURES_HEADER}\n").as_bytes())?;
    log.in_order(|record| {
        counted.add(&record.row, &mut tally);
        labels.write(format!("{}\n", record.row).as_bytes())?;
        if let Some(reason) = &record.reason {
            let method = sweep.methods[record.method].name();
            let command = repeat.command(record.case, method);
            failures.write(&failures_row(record.case, method, reason, &command)?)?;
        }
        Ok(())
    })?;
    let files = [
        ("labels.csv", labels.finish()?),
        ("failures.csv", failures.finish()?),
    ];
    Ok(Tables {
        tally,
        files: files.map(|(name, sum)| (name.to_owned(), sum)).into(),
    })
}
