//! `labels.csv`: one row per case and method, tidy.

use std::fs::File;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow};
use sim::{Label, LateralMeasures, TorsionMeasures};

use crate::engine::{Row, RowOutcome};
use crate::hand_table::{HandTable, Mistake, number};
use crate::plan::{Sweep, to_rpm};
use crate::quantities::Axis;
use crate::text_file::{LARGEST_TABLE, read_text};

/// Columns that follow the axes.
const RESULT_COLUMNS: [&str; 21] = [
    "torsion",
    "lateral",
    "first_slip_s",
    "period_s",
    "slip_time_s",
    "sticks",
    "bit_speed_peak_rpm",
    "bit_speed_closing_rpm",
    "site_from_bit_m",
    "first_contact_s",
    "peak_radius_mm",
    "mean_radius_mm",
    "contact_fraction",
    "rolling_fraction",
    "precession_turns_per_s",
    "normal_force_mean_kn",
    "ambiguous_steps",
    "predicted",
    "simulated_s",
    "ended",
    "status",
];

/// The first line of `labels.csv`.
pub fn labels_header(sweep: &Sweep) -> String {
    let mut header = vec!["case".to_owned(), "method".to_owned()];
    header.extend(sweep.design.axes().iter().map(|axis| axis.name()));
    header.extend(shows_torque(sweep).then(|| Axis::TorqueDynamicNm.name()));
    header.extend(RESULT_COLUMNS.map(str::to_owned));
    header.join(",")
}

/// A row of `labels.csv`. No field of it needs quotes: they are names and numbers.
pub fn labels_row(sweep: &Sweep, row: &Row) -> String {
    let mut fields = vec![labels_start(row.case, row.method, &row.values)];
    if shows_torque(sweep) {
        fields.push(optional(row.torque_dynamic_nm));
    }
    fields.extend(result_fields(row));
    fields.join(",")
}

/// The first fields of a row of `labels.csv`: case, method and values along the axes.
pub fn labels_start(case: usize, method: &str, values: &[f64]) -> String {
    let mut fields = vec![case.to_string(), method.to_owned()];
    fields.extend(values.iter().map(f64::to_string));
    fields.join(",")
}

/// What an axis is mapped to on the way to the model is a column too.
fn shows_torque(sweep: &Sweep) -> bool {
    sweep.bit.is_some() && !sweep.design.axes().contains(&Axis::TorqueDynamicNm)
}

fn optional(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn result_fields(row: &Row) -> Vec<String> {
    let done = match &row.outcome {
        RowOutcome::Done(outcome) => Some(outcome),
        RowOutcome::Failed(_) => None,
    };
    let torsion = done.and_then(|outcome| outcome.torsion.as_ref());
    let lateral = done.and_then(|outcome| outcome.lateral.as_ref());
    let mut fields = vec![
        torsion.map_or_else(String::new, |torsion| torsion.regime.name().to_owned()),
        lateral.map_or_else(String::new, |lateral| lateral.regime.name().to_owned()),
    ];
    fields.extend(torsion.map_or_else(|| vec![String::new(); 6], torsion_fields));
    let lateral_fields = |lateral| lateral_fields(row.site_from_bit_m, lateral);
    fields.extend(lateral.map_or_else(|| vec![String::new(); 9], lateral_fields));
    let predicted = done
        .and_then(|outcome| outcome.predicted)
        .map_or("", Label::name);
    fields.push(predicted.to_owned());
    let (ended, status) = match done {
        Some(outcome) => (outcome.ended.name(), "ok"),
        None => ("", "failed"),
    };
    fields.push(optional(done.map(|outcome| outcome.simulated)));
    fields.extend([ended.to_owned(), status.to_owned()]);
    fields
}

fn torsion_fields(torsion: &TorsionMeasures) -> Vec<String> {
    vec![
        optional(torsion.first_slip),
        optional(torsion.period),
        optional(torsion.slip_time),
        torsion.sticks.to_string(),
        to_rpm(torsion.peak_speed).to_string(),
        to_rpm(torsion.closing_speed).to_string(),
    ]
}

fn lateral_fields(site_from_bit_m: Option<f64>, lateral: &LateralMeasures) -> Vec<String> {
    vec![
        optional(site_from_bit_m),
        optional(lateral.first_contact),
        (1e3 * lateral.peak_radius).to_string(),
        (1e3 * lateral.mean_radius).to_string(),
        lateral.contact_fraction.to_string(),
        lateral.rolling_fraction.to_string(),
        (lateral.precession_rate / std::f64::consts::TAU).to_string(),
        (1e-3 * lateral.mean_normal_force).to_string(),
        lateral.ambiguous_steps.to_string(),
    ]
}

/// What is read back of a row: enough to draw it or to run it again.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelRow {
    /// Line of the file.
    pub line: usize,
    /// Number of the case.
    pub case: usize,
    /// Name of the method.
    pub method: String,
    /// Values along the given axes.
    pub values: Vec<f64>,
    /// The torsion label; empty where there is none.
    pub torsion: String,
    /// The lateral label; empty where there is none.
    pub lateral: String,
}

/// Where the columns are that are read back: `case`, `method`, the axes asked
/// for, `torsion` and, if it is there, `lateral`; others are passed over.
struct Columns {
    case: usize,
    method: usize,
    values: Vec<usize>,
    torsion: usize,
    lateral: Option<usize>,
}

impl Columns {
    /// An error is the name of a missing column.
    fn find(header: &csv::StringRecord, axes: &[Axis]) -> Result<Self, String> {
        let column = |name: &str| {
            let found = header.iter().position(|field| field == name);
            found.ok_or_else(|| format!("has no column `{name}`"))
        };
        Ok(Self {
            case: column("case")?,
            method: column("method")?,
            values: (axes.iter())
                .map(|axis| column(&axis.name()))
                .collect::<Result<_, _>>()?,
            torsion: column("torsion")?,
            lateral: column("lateral").ok(),
        })
    }

    /// An error is what is wrong with the record.
    fn row(&self, record: &csv::StringRecord, line: usize) -> Result<LabelRow, String> {
        let field = |column: usize| record.get(column).unwrap_or_default();
        let case = field(self.case);
        Ok(LabelRow {
            line,
            case: case
                .parse()
                .map_err(|_| format!("`{case}` is not a case number"))?,
            method: field(self.method).to_owned(),
            values: (self.values.iter())
                .map(|&column| number(field(column)))
                .collect::<Result<_, _>>()?,
            torsion: field(self.torsion).to_owned(),
            lateral: self
                .lateral
                .map_or_else(String::new, |column| field(column).to_owned()),
        })
    }
}

/// Reads labels that a person may have written or exported from a spreadsheet.
///
/// # Errors
/// Where they cannot be read; the message names file and line.
pub fn read_labels(path: &Path, axes: &[Axis]) -> Result<Vec<LabelRow>> {
    let text = read_text(path, LARGEST_TABLE)
        .with_context(|| format!("{} cannot be read", path.display()))?;
    let parsed = HandTable::new(&text).and_then(|table| rows_of(&table, axes));
    parsed.map_err(|mistake| anyhow!("{}:{mistake}", path.display()))
}

fn rows_of(table: &HandTable, axes: &[Axis]) -> Result<Vec<LabelRow>, Mistake> {
    let columns =
        Columns::find(table.header(), axes).map_err(|reason| table.header_mistake(reason))?;
    let rows = table.rows().map(|row| {
        let row = row?;
        (columns.row(&row.cells, row.line)).map_err(|message| Mistake {
            line: row.line,
            message,
        })
    });
    rows.collect()
}

/// The rows of a `labels.csv`; only one is in memory at a time.
pub struct LabelReader {
    path: PathBuf,
    reader: csv::Reader<File>,
    record: csv::StringRecord,
    columns: Columns,
}

impl LabelReader {
    /// Opens a `labels.csv` of which the values along `axes` are wanted.
    ///
    /// # Errors
    /// Where it cannot be read or lacks a column.
    pub fn open(path: &Path, axes: &[Axis]) -> Result<Self> {
        let unreadable = || format!("{} cannot be read", path.display());
        let mut reader = csv::Reader::from_path(path).with_context(unreadable)?;
        let header = reader.headers().with_context(unreadable)?.clone();
        let columns = Columns::find(&header, axes)
            .map_err(|reason| anyhow!("{}:1: {reason}", path.display()))?;
        Ok(Self {
            path: path.to_owned(),
            reader,
            record: csv::StringRecord::new(),
            columns,
        })
    }

    fn read(&mut self) -> Result<Option<LabelRow>> {
        let is_row = self.reader.read_record(&mut self.record);
        if !is_row.with_context(|| format!("{} cannot be read", self.path.display()))? {
            return Ok(None);
        }
        let line = self.record.position().map_or(0, csv::Position::line) as usize;
        let row = self.columns.row(&self.record, line);
        row.map(Some)
            .map_err(|reason| anyhow!("{}:{line}: {reason}", self.path.display()))
    }
}

/// The message of an error names file and line.
impl Iterator for LabelReader {
    type Item = Result<LabelRow>;

    fn next(&mut self) -> Option<Self::Item> {
        self.read().transpose()
    }
}
