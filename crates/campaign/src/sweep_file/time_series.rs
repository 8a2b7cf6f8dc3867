//! Tables of what was recorded over time, and surveys: columns found by name and unit.

use linear::well::{Station, Survey};
use sim::Recording;

use super::cells::Cells;
use super::error::SweepFileError;
use super::source::{Source, TextOf};
use super::wording::nearest;
use crate::hand_table::number;
use crate::quantities::{FOOT, factor_of_recorded};

/// Names of a column of times, s.
const TIMES: [&str; 2] = ["time_s", "t_s"];

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
    let cells = Cells::read(&path, text_of).map_err(error)?;
    let header = |message: String| error(format!(":{}: {message}", cells.header_line));
    let time = column_of(&cells.header, &TIMES)
        .ok_or_else(|| header(format!("has no column of times, `{}`", TIMES[0])))?;
    let has_unit = |name: &str| factor_of_recorded(name, unit);
    let (place, factor) = match column {
        Some(column) => {
            let place = (cells.header.iter()).position(|name| name == column);
            let place = place.ok_or_else(|| {
                let known: Vec<&str> = cells.header.iter().map(String::as_str).collect();
                let hint = nearest(column, &known).map_or_else(
                    || format!("it has {}", known.join(", ")),
                    |known| format!("did you mean `{known}`?"),
                );
                header(format!("has no column `{column}`; {hint}"))
            })?;
            let factor = has_unit(column);
            let message = format!(
                "the name of column `{column}` does not end in `{unit}` or another unit of that"
            );
            (place, factor.ok_or_else(|| header(message))?)
        }
        None => {
            let columns = cells.header.iter().enumerate();
            let mut known = columns.filter_map(|(place, name)| Some((place, has_unit(name)?)));
            match (known.next(), known.next()) {
                (Some(found), None) => found,
                (None, _) => {
                    return Err(header(format!(
                        "has no column whose name ends in `{unit}` or another unit of that"
                    )));
                }
                _ => return Err(header("has several such columns: name one".to_owned())),
            }
        }
    };
    let (mut times, mut values, mut lines) = (Vec::new(), Vec::new(), Vec::new());
    for (line, row) in &cells.rows {
        let value = |place: usize| number(row.get(place).map_or("", String::as_str));
        let at = |reason: &dyn std::fmt::Display| error(format!(":{line}: {reason}"));
        times.push(value(time).map_err(|reason| at(&reason))?);
        values.push(factor * value(place).map_err(|reason| at(&reason))?);
        lines.push(*line);
    }
    if let Some((index, gap)) = gap(&times) {
        let message = format!("nothing was recorded for {gap} s before this");
        return Err(error(format!(":{}: {message}", lines[index])));
    }
    Recording::new(times, values).map_err(|reason| error(format!(": {reason}")))
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

/// The survey of a file that a `key` names.
///
/// # Errors
/// Where the file cannot be read, lacks a column, or is no survey.
pub fn read_survey(
    source: &Source,
    key: &str,
    file: &str,
    text_of: TextOf,
) -> Result<Survey, SweepFileError> {
    let path = source.folder_of(key).join(file);
    let name = path.display();
    let error = |message: String| source.error(key, format!("{name}{message}"));
    let cells = Cells::read(&path, text_of).map_err(error)?;
    let column = |names: &[&str]| {
        let message = || format!(":{}: has no column `{}`", cells.header_line, names[0]);
        column_of(&cells.header, names).ok_or_else(|| error(message()))
    };
    let in_feet = ["measured_depth_ft", "md_ft"];
    let (depth, unit) = match column_of(&cells.header, &in_feet) {
        Some(depth) => (depth, FOOT),
        None => (column(&["measured_depth_m", "md_m"])?, 1.0),
    };
    let inclination = column(&["inclination_deg", "inc_deg"])?;
    let azimuth = column(&["azimuth_deg", "azi_deg"])?;
    let stations = cells.rows.iter().map(|(line, row)| {
        let value = |place: usize| {
            let cell = row.get(place).map_or("", String::as_str);
            number(cell).map_err(|reason| error(format!(":{line}: {reason}")))
        };
        Ok(Station {
            measured_depth: unit * value(depth)?,
            inclination: value(inclination)?.to_radians(),
            azimuth: value(azimuth)?.to_radians(),
        })
    });
    let stations = stations.collect::<Result<_, SweepFileError>>()?;
    Survey::new(stations).map_err(|reason| error(format!(": {reason}")))
}

fn column_of(header: &[String], names: &[&str]) -> Option<usize> {
    header
        .iter()
        .position(|name| names.contains(&name.as_str()))
}
