//! The rows of `labels.csv` from the records that a finished folder keeps, without their text.

use std::path::Path;

use anyhow::{Context, Result, anyhow};
use sim::Outcome;

use super::label_row::LabelRow;
use super::manifest::Manifest;
use super::open::MANIFEST;
use super::records::{RECORDS, read_records};
use campaign::quantities::Axis;
use campaign::records::{
    Certainty, Certified, Measure, Record, RecordRow, WallPush, certainty, certified, to_rpm,
};

/// What the rows of a folder are made of.
pub(super) struct RecordedRows {
    methods: Vec<String>,
    /// The places of the methods that certify labels, where any do.
    certifying: Option<[usize; 2]>,
    /// Where the values of the axes that are wanted are among those of a record.
    places: Vec<(Axis, Option<usize>)>,
    /// Axes of the design, each with a value in every record.
    axes: usize,
    measures: Vec<Measure>,
    misfits: usize,
}

impl RecordedRows {
    /// Of the folder of a table, of which the values along `axes`, some measures and a number of
    /// misfits are wanted; none where it keeps no records, as those of earlier versions, or holds
    /// those of an earlier run.
    pub(super) fn of(
        folder: &Path,
        (axes, measures): (&[Axis], &[Measure]),
        misfits: usize,
    ) -> Option<Self> {
        if !folder.join(MANIFEST).exists() {
            return None;
        }
        let manifest = Manifest::read(folder).ok()?;
        let are_its_own = manifest.files.contains_key(RECORDS)
            && manifest
                .damage(folder, &[RECORDS, "labels.csv"])
                .ok()?
                .is_empty();
        let names = manifest.method_names();
        let place = |name: &String| names.iter().position(|method| method == name);
        let certifying = manifest
            .certified_by
            .as_ref()
            .map(|by| by.methods.each_ref());
        let certifying = match certifying {
            None => None,
            Some(methods) => Some([place(methods[0])?, place(methods[1])?]),
        };
        let own = |axis: &Axis| manifest.axes.iter().position(|own| own == axis);
        are_its_own.then(|| Self {
            methods: names.into_iter().map(str::to_owned).collect(),
            certifying,
            places: axes.iter().map(|axis| (*axis, own(axis))).collect(),
            axes: manifest.axes.len(),
            measures: measures.to_vec(),
            misfits,
        })
    }

    /// The rows, of which only those of a case are in memory at a time.
    ///
    /// # Errors
    /// Where records cannot be read.
    pub(super) fn read(
        self,
        folder: &Path,
    ) -> Result<impl Iterator<Item = Result<LabelRow>> + use<>> {
        let name = folder.join(RECORDS).display().to_string();
        let records = read_records(folder)?.enumerate().map(move |(index, line)| {
            let line = line?;
            let parsed = serde_json::from_str::<Record>(&line);
            parsed.with_context(|| format!("{name}:{}: is no record", index + 1))
        });
        let mut records = records.peekable();
        let mut line = 1;
        let cases = std::iter::from_fn(move || {
            let first = match records.next()? {
                Ok(first) => first,
                Err(error) => return Some(vec![Err(error)]),
            };
            let case = first.case;
            let is_next = |record: &Result<Record>| record.as_ref().is_ok_and(|it| it.case == case);
            let others = std::iter::from_fn(|| records.next_if(is_next)?.ok());
            let records: Vec<Record> = std::iter::once(first).chain(others).collect();
            let certified = self.certifying.map(|places| certified(&records, places));
            let rows = records.iter().map(|record| {
                line += 1;
                self.row(line, record, certified)
            });
            Some(rows.collect::<Vec<_>>())
        });
        Ok(cases.flatten())
    }

    fn row(&self, line: usize, record: &Record, certified: Option<Certified>) -> Result<LabelRow> {
        record.check_values(self.axes)?;
        let outcome = record.outcome.as_ref();
        let labels = outcome.map(Outcome::labels).unwrap_or_default();
        let certainty =
            certified.map_or_else(Certainty::default, |certified| certainty(labels, certified));
        let row = RecordRow::new(record, certainty);
        let value = |(axis, place): &(Axis, Option<usize>)| {
            let value = match (place, axis) {
                (Some(place), _) => record.values.get(*place).copied(),
                (None, Axis::TorqueDynamicNm) => record.torque_dynamic_nm,
                (None, _) => None,
            };
            value.ok_or_else(|| anyhow!("case {} has no {}", record.case, axis.name()))
        };
        Ok(LabelRow {
            line,
            case: record.case,
            method: (self.methods.get(record.method).cloned())
                .ok_or_else(|| anyhow!("case {} is of no method of the run", record.case))?,
            values: self.places.iter().map(value).collect::<Result<_>>()?,
            labels,
            predicted: outcome.ok().and_then(|outcome| outcome.predicted),
            misfits: (0..self.misfits)
                .map(|place| record.misfits.get(place).copied().flatten())
                .collect(),
            measures: (self.measures.iter())
                .map(|measure| measure.field(&row).number())
                .collect(),
            stick_slip_margin: record.above_limit.map(to_rpm),
            certainty,
            found: (record.found.as_ref()).map(|found| [found.sites.len(), found.rounds]),
            motor_stalled: row.motor_stalled(),
            wall_push: row.wall_push().map(WallPush::as_in_table),
            failed: outcome.is_err(),
        })
    }
}
