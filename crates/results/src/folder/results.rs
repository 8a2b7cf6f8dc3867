//! Writes the tables of a results folder from the records of its run, row by row, and keeps these.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::Result;
use linear::parallel;

use super::about::About;
use super::failures::{FAILURES_HEADER, failures_row, repeat_command};
use super::records::{RECORDS, RecordWriter};
use super::tally::Tally;
use crate::files::{AtomicFile, Checksum};
use campaign::labels::LabelTable;
use campaign::records::{Certainty, Record, RecordRow, WallPush, to_mm, to_turns};
use sim::{Label, Outcome};

/// Rows that all threads together format at once.
const ROWS_AT_ONCE: usize = 1 << 12;

/// `labels.csv` and `failures.csv` being written.
pub struct TableWriter<'a> {
    about: &'a About,
    table: LabelTable<'a>,
    labels: AtomicFile,
    failures: AtomicFile,
    records: RecordWriter,
    tally: Tally,
}

impl<'a> TableWriter<'a> {
    /// Tables without a row.
    ///
    /// # Errors
    /// Where they cannot be written.
    pub fn create(about: &'a About, folder: &Path) -> Result<Self> {
        let table = about.label_table();
        let mut labels = AtomicFile::create(&folder.join("labels.csv"))?;
        let mut failures = AtomicFile::create(&folder.join("failures.csv"))?;
        labels.write(format!("{}\n", table.header()).as_bytes())?;
        failures.write(format!("{FAILURES_HEADER}\n").as_bytes())?;
        Ok(Self {
            about,
            table,
            labels,
            failures,
            records: RecordWriter::create(folder)?,
            tally: Tally::default(),
        })
    }

    /// Adds the rows of whole cases, which come after those of earlier ones.
    ///
    /// # Errors
    /// Where they cannot be written, or are of another design.
    pub fn add(&mut self, records: &[Record]) -> Result<()> {
        let axes = self.about.manifest.axes.len();
        for record in records {
            record.check_values(axes)?;
        }
        let certainties = self.table.certainties(records);
        let blocks = certainties.chunks(ROWS_AT_ONCE);
        for (records, certainties) in records.chunks(ROWS_AT_ONCE).zip(blocks) {
            let row = |place: usize| self.table.row(&records[place], certainties[place]) + "\n";
            let rows = parallel::map(records.len(), 1, row);
            self.labels.write(rows.concat().as_bytes())?;
            let line = |place: usize| serde_json::to_string(&records[place]);
            let lines = parallel::map(records.len(), 1, line).into_iter();
            let lines = lines.collect::<Result<Vec<_>, _>>()?;
            self.records.write(&(lines.join("\n") + "\n"))?;
            let mut rows = records.iter().zip(certainties);
            rows.try_for_each(|(record, certainty)| self.count(record, *certainty))?;
        }
        Ok(())
    }

    fn count(&mut self, record: &Record, certainty: Certainty) -> Result<()> {
        let method = self.table.methods[record.method];
        let (labels, predicted) = match &record.outcome {
            Ok(outcome) => {
                self.tally.fading += usize::from(outcome.fades());
                (outcome.labels(), outcome.predicted)
            }
            Err(reason) => {
                let command = repeat_command(self.about, record.case, method);
                let row = failures_row(record.case, method, reason.text(), &command)?;
                self.failures.write(&row)?;
                Default::default()
            }
        };
        (self.tally).add(
            method,
            record.outcome.is_err(),
            labels,
            predicted,
            certainty,
        );
        (self.tally).add_margin(method, labels, record.above_limit);
        let lateral = record.outcome.as_ref().ok().and_then(Outcome::lateral);
        let whirl =
            lateral.filter(|lateral| Label::Lateral(lateral.regime).is_sustained() == Some(true));
        if let Some(whirl) = whirl {
            (self.tally).add_whirl(method, to_turns(whirl.precession_rate));
        }
        let stalled = RecordRow::new(record, certainty).motor_stalled();
        (self.tally).add_motor(method, stalled, labels);
        if let Some(push) = record.wall_push.map(WallPush::as_in_table) {
            (self.tally).add_push(method, push);
        }
        if let Some(stress) = record.outcome.as_ref().ok().and_then(|it| it.stress) {
            (self.tally).add_stress(method, stress.von_mises.value);
        }
        if let Some(axial) = record.outcome.as_ref().ok().and_then(Outcome::axial) {
            (self.tally).add_cut(method, to_mm(axial.peak_depth_of_cut));
        }
        if let Some(found) = &record.found {
            (self.tally).add_found(method, [found.sites.len(), found.rounds]);
        }
        Ok(())
    }

    /// Puts the tables and records in their place: what is in them, and their checksums by name.
    ///
    /// # Errors
    /// Where they cannot be written.
    pub fn finish(self) -> Result<(Tally, BTreeMap<String, Checksum>)> {
        let files = [
            ("labels.csv", self.labels.finish()?),
            ("failures.csv", self.failures.finish()?),
            (RECORDS, self.records.seal()?.publish()?),
        ];
        let files = files.map(|(name, sum)| (name.to_owned(), sum));
        Ok((self.tally, files.into()))
    }
}
