//! What was recorded over time.

use sim::{Recording, RecordingError};

use super::bha_sheet::comments_words;
use super::error::SweepFileError;
use super::named_table::NamedTable;
use super::source::{Source, TextOf};
use super::wording::nearest;
use crate::tables::{Columns, Dimension, Heading, Row, Table, Wanted};

/// What is read of a recording in addition to its values.
const TIME: [Wanted<()>; 1] = [Wanted {
    quantity: (),
    names: &[
        "time",
        "t",
        "elapsed_time",
        "elapsed",
        "relative_time",
        "seconds",
        "",
    ],
    dimension: Some(Dimension::Time),
    needed: Some("times, `time_s` or `Time (s)`"),
    assumed: None,
}];

/// A gap is this much longer than the usual distance of samples, and than a second.
const GAP: f64 = 20.0;

/// Most that samples that belong together are apart, s.
const APART: f64 = 1.0;

/// What was recorded in a column of a file that a `key` names, in the unit of a quantity; without
/// the name of a column, in the only one that has such a unit. With it comes what was ignored, in
/// words.
///
/// # Errors
/// Where the file cannot be read, has no such column, or is no recording.
pub fn read_series(
    source: &Source,
    key: &str,
    file: &str,
    column: Option<&str>,
    unit: &str,
    text_of: TextOf,
) -> Result<(Recording, Vec<String>), SweepFileError> {
    let has_both = |headings: &[Heading]| {
        Columns::are_in(headings, &TIME) && value_column(headings, column, unit).is_ok()
    };
    let mut named = NamedTable::read(source, key, file, text_of, &has_both)?;
    if value_column(&named.table.headings, column, unit).is_err() {
        // Its headings may be where the times are named, for the message.
        let has_times = |headings: &[Heading]| Columns::are_in(headings, &TIME);
        named = NamedTable::read(source, key, file, text_of, &has_times)?;
    }
    let columns = named.columns(&TIME)?;
    let values = value_column(&named.table.headings, column, unit);
    let values = values.map_err(|message| named.header_error(&message))?;
    let times = columns.get(()).map(|it| (it.place, it.factor));
    let mut samples = Samples::default();
    for row in &named.table.rows {
        let at = |reason: String| named.error(Some(row.line), &reason);
        let of = |(place, factor)| sample(row, place, factor).map_err(at);
        let time = times.map(of).transpose()?.flatten();
        if let (Some(time), Some(value)) = (time, of(values)?) {
            is_possible(time, value, unit).map_err(at)?;
            samples.times.push(time);
            samples.values.push(value);
            samples.lines.push(row.line);
        }
    }
    let notes = ignored(file, &named.table, (values.0, samples.times.len()));
    let lines = samples.lines;
    if let Some((index, gap)) = gap(&samples.times) {
        let message = format!("nothing was recorded for {gap} s before this");
        return Err(named.error(Some(lines[index]), &message));
    }
    let recording = Recording::new(samples.times, samples.values).map_err(|reason| {
        let line = match reason {
            RecordingError::NotFinite(sample) | RecordingError::RunsBack { sample, .. } => {
                lines.get(sample).copied()
            }
            _ => None,
        };
        named.error(line, &reason.to_string())
    })?;
    Ok((recording, notes))
}

/// Rows of comments, and rows without a value in the column at a place, in words; `kept` is the
/// number of rows that were read.
fn ignored(file: &str, table: &Table, (place, kept): (usize, usize)) -> Vec<String> {
    let comments = (!table.comments.is_empty()).then(|| comments_words(file, &table.comments));
    let (all, name) = (table.rows.len(), &table.headings[place].text);
    let gaps = (kept < all).then(|| {
        let gaps = all - kept;
        format!("{file}: {gaps} of {all} rows have no value of `{name}` and are ignored")
    });
    comments.into_iter().chain(gaps).collect()
}

/// What was recorded, and where it stands.
#[derive(Default)]
struct Samples {
    times: Vec<f64>,
    values: Vec<f64>,
    lines: Vec<usize>,
}

/// The column of values, and what they are multiplied by.
fn value_column(
    headings: &[Heading],
    column: Option<&str>,
    unit: &str,
) -> Result<(usize, f64), String> {
    let dimension = match unit {
        "_rpm" => Dimension::RotationSpeed,
        _ => Dimension::Torque,
    };
    let factor = |heading: &Heading| heading.factor(dimension);
    let headings = || headings.iter().enumerate();
    let Some(column) = column else {
        let mut known = headings().filter_map(|(place, it)| Some((place, factor(it)?)));
        return match (known.next(), known.next()) {
            (Some(found), None) => Ok(found),
            (None, _) => Err(format!(
                "has no column whose name ends in `{unit}` or another unit of that ({})",
                dimension.units()
            )),
            _ => Err("has several such columns: name one".to_owned()),
        };
    };
    let wanted = Heading::new(column).snake();
    let found = headings()
        .find(|(_, it)| it.text == column)
        .or_else(|| headings().find(|(_, it)| it.snake() == wanted));
    let (place, heading) = found.ok_or_else(|| {
        let known: Vec<&str> = headings().map(|(_, it)| it.text.as_str()).collect();
        let hint = nearest(column, &known)
            .map_or(String::new(), |known| format!("; did you mean `{known}`?"));
        format!("has no column `{column}`{hint}")
    })?;
    let factor = factor(heading).ok_or_else(|| {
        format!(
            "the name of column `{column}` does not end in `{unit}` or another unit of that ({})",
            dimension.units()
        )
    })?;
    Ok((place, factor))
}

/// What a row has in a column; nothing, where nothing was recorded.
fn sample(row: &Row, place: usize, factor: f64) -> Result<Option<f64>, String> {
    if is_absent(row.text(place).trim()) {
        return Ok(None);
    }
    let number = row.number(place).map_err(|error| error.to_string())?;
    Ok((!is_null(number)).then_some(factor * number))
}

/// Words for a value that is not there.
fn is_absent(text: &str) -> bool {
    let words = [
        "", "-", "--", "nan", "null", "nil", "none", "na", "n/a", "#n/a", "absent", "void",
    ];
    words.contains(&text.to_lowercase().as_str())
}

/// Numbers that stand for none where logs are kept: −999.25 and its like, of which no digit but
/// those of a quarter is another than 9.
fn is_null(number: f64) -> bool {
    let whole = -number.trunc();
    let fraction = -number.fract();
    let digits = format!("{whole:.0}");
    let is_nines = digits.len() >= 3 && digits.bytes().all(|digit| digit == b'9');
    let fractions = [0.0, 0.25, 0.9, 0.99, 0.999];
    let is_usual = fractions
        .iter()
        .any(|usual| (fraction - usual).abs() < 1e-3);
    is_nines && is_usual
}

/// The longest that is recorded, s: three years.
const LONGEST: f64 = 1e8;

/// The fastest turning, rpm, and the largest torque, N m, of any string.
const FASTEST: f64 = 1e4;
const STRONGEST: f64 = 1e7;

/// Refuses what no string does.
fn is_possible(time: f64, value: f64, unit: &str) -> Result<(), String> {
    let (most, words) = match unit {
        "_rpm" => (FASTEST, "rpm"),
        _ => (STRONGEST, "N m"),
    };
    // Nor what is no number.
    let is_within = |value: f64, most: f64| (-most..=most).contains(&value);
    if !is_within(time, LONGEST) {
        return Err(format!("a time of {time} s is not between -1e8 and 1e8 s"));
    }
    if !is_within(value, most) {
        return Err(format!(
            "{value} {words} is not between -{most} and {most} {words}"
        ));
    }
    Ok(())
}

/// The first sample after a gap, and how long that is, s.
fn gap(times: &[f64]) -> Option<(usize, f64)> {
    let steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mut sorted = steps.clone();
    sorted.sort_by(f64::total_cmp);
    let usual = sorted.get(sorted.len() / 2)?;
    let most = APART.max(GAP * usual);
    let index = steps.iter().position(|step| *step > most)?;
    Some((index + 1, steps[index]))
}
