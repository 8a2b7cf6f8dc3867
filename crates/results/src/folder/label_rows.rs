//! Reads `labels.csv`: rows for maps, reports and merges, and rows of a person for `check`.

use std::path::Path;

use anyhow::{Context, Result, anyhow};
use sim::{Label, Labels, Motion, PerMotion};

use super::label_row::LabelRow;
use super::recorded_rows::RecordedRows;
use campaign::records::{
    Certainty, FAILED, FOUND_ROUNDS, FOUND_SITES, MISFIT, MOTOR_STALLED, Measure, PUSH_COLUMNS,
    ResultColumn, STICK_SLIP_MARGIN, WHIRL_AGREES, WallPush, name_now,
};

use campaign::quantities::Axis;
use campaign::sweep_file::nearest;
use campaign::tables::hand_table::{HandTable, Mistake, NumberError, number};
use campaign::text_file::{LARGEST_TABLE, read_text, unreadable};

/// The columns of a `labels.csv` that say how far its cases are from what was recorded.
///
/// # Errors
/// Where it cannot be read.
pub fn misfit_columns(path: &Path) -> Result<Vec<String>> {
    let mut reader = csv::Reader::from_path(path).with_context(|| unreadable(path))?;
    let header = reader.headers().with_context(|| unreadable(path))?;
    let columns = header.iter().filter(|name| name.starts_with(MISFIT));
    Ok(columns.map(str::to_owned).collect())
}

/// Where the columns are that are read back: `case`, `method`, the axes and measures asked
/// for, `torsion` and, if they are there, `lateral`, `predicted`, misfits, certainties,
/// the margin to Eq. 74, found sites, `motor_stalled`, pushes into walls and `status`; others are
/// ignored.
pub struct LabelColumns {
    case: usize,
    method: usize,
    values: Vec<(Axis, usize)>,
    labels: PerMotion<Option<usize>>,
    predicted: Option<usize>,
    misfits: Vec<usize>,
    measures: Vec<usize>,
    stick_slip_margin: Option<usize>,
    certainty: PerMotion<Option<usize>>,
    whirl_agrees: Option<usize>,
    found: [Option<usize>; 2],
    motor_stalled: Option<usize>,
    wall_push: [Option<usize>; 5],
    status: Option<usize>,
}

/// What is wrong with a row of labels, or with the names of its columns.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LabelError {
    /// A column is missing.
    #[error("has no column `{0}`")]
    MissingColumn(String),
    /// It is not clear which of two columns is meant.
    #[error("has the column `{0}` twice")]
    TwoColumns(String),
    /// The case is no number.
    #[error("`{0}` is not a case number")]
    Case(String),
    /// A value along an axis is no number.
    #[error("{}: {error}", axis.name())]
    Value {
        /// The axis.
        axis: Axis,
        /// What it holds instead.
        error: NumberError,
    },
    /// What was predicted is no label.
    #[error("`{0}` is no regime")]
    Predicted(String),
    /// A label is not among those of its column.
    #[error("{column}: `{word}` is no {column} regime; {hint}")]
    Regime {
        /// The column.
        column: &'static str,
        /// What it holds.
        word: String,
        /// What is meant, or what is known.
        hint: String,
    },
}

impl LabelColumns {
    /// From the names of all columns, the values along `axes` and these measures being wanted.
    ///
    /// # Errors
    /// Where one is missing, or there twice.
    pub fn find<'a>(
        header: impl Iterator<Item = &'a str> + Clone,
        axes: &[Axis],
        measures: &[Measure],
    ) -> Result<Self, LabelError> {
        let place = |name: &str| {
            let mut fields = header.clone().enumerate();
            let mut next = || fields.find(|(_, field)| name_now(field) == name);
            match (next(), next()) {
                (Some(_), Some(_)) => Err(LabelError::TwoColumns(name.to_owned())),
                (first, _) => Ok(first.map(|(place, _)| place)),
            }
        };
        let no_column = |name: &str| LabelError::MissingColumn(name.to_owned());
        let column = |name: &str| place(name)?.ok_or_else(|| no_column(name));
        // What every table has.
        column(ResultColumn::label_of(Motion::Torsion))?;
        let of_motions = |name: fn(Motion) -> &'static str| {
            let mut places = PerMotion::default();
            for motion in Motion::ALL {
                places[motion] = place(name(motion))?;
            }
            Ok(places)
        };
        Ok(Self {
            case: column("case")?,
            method: column("method")?,
            values: (axes.iter())
                .map(|&axis| column(&axis.name()).map(|place| (axis, place)))
                .collect::<Result<_, _>>()?,
            labels: of_motions(ResultColumn::label_of)?,
            predicted: place("predicted")?,
            misfits: (header.clone().enumerate())
                .filter(|(_, name)| name.starts_with(MISFIT))
                .map(|(place, _)| place)
                .collect(),
            measures: (measures.iter())
                .map(|measure| column(measure.column()))
                .collect::<Result<_, _>>()?,
            stick_slip_margin: place(STICK_SLIP_MARGIN)?,
            certainty: of_motions(ResultColumn::certainty_of)?,
            whirl_agrees: place(WHIRL_AGREES)?,
            found: [place(FOUND_SITES)?, place(FOUND_ROUNDS)?],
            motor_stalled: place(MOTOR_STALLED)?,
            wall_push: {
                let mut places = [None; 5];
                for (place_of, name) in places.iter_mut().zip(PUSH_COLUMNS) {
                    *place_of = place(name)?;
                }
                places
            },
            status: place("status")?,
        })
    }

    /// A row by its fields.
    ///
    /// # Errors
    /// Where a field is not what its column holds.
    pub fn row<'a>(
        &self,
        line: usize,
        field: impl Fn(usize) -> Option<&'a str>,
    ) -> Result<LabelRow, LabelError> {
        let field = |column: usize| field(column).unwrap_or_default();
        let optional = |column: Option<usize>| column.map_or("", field);
        let case = field(self.case);
        Ok(LabelRow {
            line,
            case: (case.parse()).map_err(|_| LabelError::Case(case.to_owned()))?,
            method: field(self.method).to_owned(),
            values: (self.values.iter())
                .map(|&(axis, column)| {
                    number(field(column)).map_err(|error| LabelError::Value { axis, error })
                })
                .collect::<Result<_, _>>()?,
            labels: {
                let mut labels = Labels::default();
                for motion in Motion::ALL {
                    labels[motion] = label(motion, optional(self.labels[motion]))?;
                }
                labels
            },
            predicted: match optional(self.predicted) {
                "" => None,
                word => {
                    let label = Label::of_name(word);
                    Some(label.ok_or_else(|| LabelError::Predicted(word.to_owned()))?)
                }
            },
            // Of a row without an answer, nothing.
            misfits: (self.misfits.iter())
                .map(|&column| number(field(column)).ok())
                .collect(),
            measures: (self.measures.iter())
                .map(|&column| number(field(column)).ok())
                .collect(),
            stick_slip_margin: number(optional(self.stick_slip_margin)).ok(),
            certainty: Certainty {
                labels: PerMotion::from_fn(|motion| optional(self.certainty[motion]).parse().ok()),
                whirl_agrees: optional(self.whirl_agrees).parse().ok(),
            },
            found: {
                let [sites, rounds] = self.found.map(optional);
                let sites = sites.split(';').filter(|site| !site.is_empty()).count();
                rounds.parse().ok().map(|rounds| [sites, rounds])
            },
            motor_stalled: optional(self.motor_stalled).parse().ok(),
            wall_push: {
                let [depth, from_bit, force, pressure, breaks] = self.wall_push.map(optional);
                let of = |text: &str, unit: f64| number(text).ok().map(|value| unit * value);
                (of(depth, 1e-3).zip(of(from_bit, 1.0))).map(|(depth, from_bit)| WallPush {
                    from_bit,
                    depth,
                    force: of(force, 1e3),
                    pressure: of(pressure, 1e6),
                    breaks: breaks.parse().ok(),
                })
            },
            failed: optional(self.status) == FAILED,
        })
    }
}

/// A label of a motion, or none. A word that is no regime is an error, not a label that
/// differs.
fn label(motion: Motion, word: &str) -> Result<Option<Label>, LabelError> {
    if word.is_empty() {
        return Ok(None);
    }
    let all = Label::all(motion);
    if let Some(label) = all.iter().find(|label| label.name() == word) {
        return Ok(Some(*label));
    }
    let known: Vec<&str> = all.iter().map(|label| label.name()).collect();
    let hint = nearest(word, &known).map_or_else(
        || format!("known: {}", known.join(", ")),
        |known| format!("did you mean `{known}`?"),
    );
    Err(LabelError::Regime {
        column: ResultColumn::label_of(motion),
        word: word.to_owned(),
        hint,
    })
}

/// Reads labels that a person may have written or exported from a spreadsheet.
///
/// # Errors
/// Where they cannot be read; the message names file and line.
pub fn read_labels(path: &Path, axes: &[Axis]) -> Result<Vec<LabelRow>> {
    let text = read_text(path, LARGEST_TABLE).with_context(|| unreadable(path))?;
    let parsed = HandTable::new(&text).and_then(|table| rows_of(&table, axes));
    parsed.map_err(|mistake| anyhow!("{}:{mistake}", path.display()))
}

fn rows_of(table: &HandTable, axes: &[Axis]) -> Result<Vec<LabelRow>, Mistake> {
    let columns = LabelColumns::find(table.header().iter(), axes, &[])
        .map_err(|error| table.header_mistake(error.to_string()))?;
    let rows = table.rows().map(|row| {
        let row = row?;
        let cell = |column| row.cells.get(column);
        columns.row(row.line, cell).map_err(|error| Mistake {
            line: row.line,
            message: error.to_string(),
        })
    });
    rows.collect()
}

/// The rows of a `labels.csv` of which the values along `axes` and some measures are wanted: from
/// the records of its folder, where that keeps them, and from its text where not. Only the rows of a
/// case are in memory at a time.
///
/// # Errors
/// Where it cannot be read or lacks a column; the message names file and line.
pub fn label_rows(
    path: &Path,
    axes: &[Axis],
    measures: &[Measure],
) -> Result<Box<dyn Iterator<Item = Result<LabelRow>>>> {
    let name = path.display().to_string();
    let mut reader = csv::Reader::from_path(path).with_context(|| unreadable(path))?;
    let header = reader.headers().with_context(|| unreadable(path))?;
    let columns = LabelColumns::find(header.iter(), axes, measures);
    let columns = columns.map_err(|reason| anyhow!("{name}:1: {reason}"))?;
    let wanted = (axes, measures);
    if let Some(folder) = path.parent() {
        if let Some(rows) = RecordedRows::of(folder, wanted, columns.misfits.len()) {
            return Ok(Box::new(rows.read(folder)?));
        }
    }
    Ok(Box::new(reader.into_records().map(move |record| {
        let record = record.with_context(|| unreadable(Path::new(&name)))?;
        let line = record.position().map_or(0, csv::Position::line) as usize;
        let row = columns.row(line, |column| record.get(column));
        row.map_err(|reason| anyhow!("{name}:{line}: {reason}"))
    })))
}
