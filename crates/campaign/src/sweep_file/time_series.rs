//! Tables of what was recorded over time, and surveys.

use linear::well::{Station, Survey, SurveyError};
use sim::{Recording, RecordingError};

use super::bha_sheet::comments_words;
use super::error::SweepFileError;
use super::source::{Source, TextOf};
use super::wording::nearest;
use crate::quantities::LONGEST_STRING;
use crate::tables::{Columns, Dimension, Heading, Row, Table, Wanted};

/// What is read of a recording besides its values.
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

/// What a column of a survey holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum OfSurvey {
    Depth,
    Inclination,
    Azimuth,
}

/// What is read of a survey.
const SURVEY: [Wanted<OfSurvey>; 3] = [
    Wanted {
        quantity: OfSurvey::Depth,
        names: &[
            "md",
            "measured_depth",
            "meas_depth",
            "m_depth",
            "depth_md",
            "measured_depth_md",
            "depth",
            "md_rkb",
            "md_rt",
            "mdrt",
            "mdkb",
            "md_kb",
            "ahd",
            "along_hole_depth",
            "survey_depth",
            "bit_depth",
            "hole_depth",
            "md_bgl",
            "station_depth",
        ],
        dimension: Some(Dimension::Length),
        needed: Some("measured depth, `measured_depth_m` or `MD (ft)`"),
        assumed: Some("m"),
    },
    Wanted {
        quantity: OfSurvey::Inclination,
        names: &[
            "inclination",
            "inc",
            "incl",
            "inclin",
            "inclination_angle",
            "inc_angle",
            "dev",
            "deviation",
            "hole_inclination",
            "drift",
            "drift_angle",
            "hole_angle",
            "angle",
            "i",
        ],
        dimension: Some(Dimension::Angle),
        needed: Some("inclination, `inclination_deg` or `Inc (deg)`"),
        assumed: Some("deg"),
    },
    Wanted {
        quantity: OfSurvey::Azimuth,
        names: &[
            "azimuth",
            "azi",
            "az",
            "azim",
            "azimuth_angle",
            "azimuth_grid",
            "azi_grid",
            "grid_azimuth",
            "azimuth_true",
            "azi_true",
            "true_azimuth",
            "azimuth_tn",
            "azimuth_gn",
            "azi_tn",
            "azi_gn",
            "azimuth_mag",
            "azimuth_magnetic",
            "azi_mag",
            "hole_azimuth",
            "hole_direction",
            "direction",
            "azimuth_north",
            "corrected_azimuth",
            "corr_azi",
            "a",
            "azimuth_grid_north",
            "azimuth_true_north",
        ],
        dimension: Some(Dimension::Angle),
        needed: Some("azimuth, `azimuth_deg` or `Azi (deg)`"),
        assumed: Some("deg"),
    },
];

/// What a survey was taken to say.
#[derive(Debug, Clone, Default)]
pub struct SurveyNotes {
    /// What it does not say, and may mean.
    pub doubts: Vec<String>,
    /// What was passed over.
    pub notes: Vec<String>,
}

/// A gap is this much longer than the usual distance of samples, and than a second.
const GAP: f64 = 20.0;

/// Most that samples that belong together are apart, s.
const APART: f64 = 1.0;

/// What was recorded in a column of a file that a `key` names, in the unit of a quantity; without
/// the name of a column, in the only one that has such a unit.
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
) -> Result<Recording, SweepFileError> {
    let path = source.folder_of(key).join(file);
    let name = path.display();
    let error = |message: String| source.error(key, format!("{name}{message}"));
    let is_header = |headings: &[Heading]| Columns::are_in(headings, &TIME);
    let table = Table::read(&path, text_of, &is_header).map_err(error)?;
    let header = |message: String| {
        let (line, names) = (table.header_line, table.names());
        error(format!(":{line}: {message}; {names}"))
    };
    let is_numeric = |place| table.is_numeric(place);
    let columns = Columns::find(&table.headings, &TIME, &is_numeric).map_err(header)?;
    let time = columns
        .get(())
        .map_or((0, 1.0), |column| (column.place, column.factor));
    let (place, factor) = value_column(&table, column, unit).map_err(header)?;
    let mut samples = Samples::default();
    for row in &table.rows {
        let at = |reason: String| error(format!(":{}: {reason}", row.line));
        let [time, value] =
            [time, (place, factor)].map(|(place, factor)| sample(row, place, factor).map_err(at));
        if let (Some(time), Some(value)) = (time?, value?) {
            is_possible(time, value, unit).map_err(at)?;
            samples.times.push(time);
            samples.values.push(value);
            samples.lines.push(row.line);
        }
    }
    if let Some((index, gap)) = gap(&samples.times) {
        let message = format!("nothing was recorded for {gap} s before this");
        return Err(error(format!(":{}: {message}", samples.lines[index])));
    }
    let lines = samples.lines;
    Recording::new(samples.times, samples.values).map_err(|reason| {
        let line = match reason {
            RecordingError::NotFinite(sample) | RecordingError::RunsBack { sample, .. } => {
                lines.get(sample)
            }
            RecordingError::Shape => None,
        };
        error(format!("{}: {reason}", at_line(line)))
    })
}

/// A line as it follows the name of a file.
fn at_line(line: Option<&usize>) -> String {
    line.map_or(String::new(), |line| format!(":{line}"))
}

/// What was recorded, and where it stands.
#[derive(Default)]
struct Samples {
    times: Vec<f64>,
    values: Vec<f64>,
    lines: Vec<usize>,
}

/// The column of values, and what they are multiplied by.
fn value_column(table: &Table, column: Option<&str>, unit: &str) -> Result<(usize, f64), String> {
    let (dimension, in_unit) = match unit {
        "_rpm" => (Dimension::RotationSpeed, "rpm"),
        _ => (Dimension::Torque, "nm"),
    };
    let scale = dimension.factor(in_unit).unwrap_or(1.0);
    let factor = |heading: &Heading| Some(heading.factor(dimension)? / scale);
    let headings = || table.headings.iter().enumerate();
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

/// The survey of a file that a `key` names, and what it was taken to say.
///
/// # Errors
/// Where the file cannot be read, lacks a column, or is no survey.
pub fn read_survey(
    source: &Source,
    key: &str,
    file: &str,
    text_of: TextOf,
) -> Result<(Survey, SurveyNotes), SweepFileError> {
    let path = source.folder_of(key).join(file);
    let name = path.display();
    let error = |message: String| source.error(key, format!("{name}{message}"));
    let is_header = |headings: &[Heading]| Columns::are_in(headings, &SURVEY);
    let table = Table::read(&path, text_of, &is_header).map_err(error)?;
    let header = |message: String| {
        let (line, names) = (table.header_line, table.names());
        error(format!(":{line}: {message}; {names}"))
    };
    let is_numeric = |place| table.is_numeric(place);
    let columns = Columns::find(&table.headings, &SURVEY, &is_numeric).map_err(header)?;
    let mut stations = Vec::new();
    for row in &table.rows {
        let value = |quantity, range: (f64, f64, &str)| {
            let column = columns.get(quantity);
            let (place, factor, name) =
                column.map_or((0, 1.0, ""), |it| (it.place, it.factor, &it.name));
            let at = |reason: String| error(format!(":{}: {name}: {reason}", row.line));
            let number = (row.number(place)).map_err(|reason| at(reason.to_string()))?;
            let (value, (least, most, unit)) = (factor * number, range);
            match (least..=most).contains(&value) {
                true => Ok(value),
                false => Err(at(format!(
                    "{value} {unit} is not between {least} and {most} {unit}"
                ))),
            }
        };
        stations.push(Station {
            measured_depth: value(OfSurvey::Depth, (0.0, LONGEST_STRING, "m"))?,
            inclination: value(OfSurvey::Inclination, (0.0, 180.0, "deg"))?.to_radians(),
            azimuth: value(OfSurvey::Azimuth, (-360.0, 720.0, "deg"))?.to_radians(),
        });
    }
    let survey = Survey::new(stations).map_err(|reason| {
        let row = match reason {
            SurveyError::NoPlace(station) | SurveyError::GoesBack(station) => Some(station),
            SurveyError::TurnsRound(station) => Some(station + 1),
            SurveyError::BeginsBelow(_) => Some(0),
            SurveyError::TooFew => None,
        };
        let line = row.and_then(|row| table.rows.get(row)).map(|row| row.line);
        error(format!("{}: {reason}", at_line(line.as_ref())))
    })?;
    let assumed = columns.assumed.iter().map(|(heading, unit)| {
        format!("{file}: `{heading}` names no unit: its numbers are taken to be in {unit}")
    });
    let comments = (!table.comments.is_empty()).then(|| comments_words(file, &table.comments));
    let notes = SurveyNotes {
        doubts: assumed.collect(),
        notes: comments.into_iter().collect(),
    };
    Ok((survey, notes))
}
