//! The survey of a well.

use linear::well::{Station, Survey, SurveyError};

use super::bha_sheet::comments_words;
use super::error::SweepFileError;
use super::named_table::NamedTable;
use super::source::{Source, TextOf};
use crate::quantities::LONGEST_STRING;
use crate::tables::{Columns, Dimension, Heading, Row, Wanted};

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
            "inclin",
            "inc_inclination",
            "inclination_angle",
            "inc_angle",
            "dev",
            "deviation",
            "hole_inclination",
            "drift",
            "drift_angle",
            "hole_angle",
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
            "azimuth_angle",
            "azi_azimuth",
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
            "corrected_azi",
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
    /// What was ignored.
    pub notes: Vec<String>,
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
    let is_header = |headings: &[Heading]| Columns::are_in(headings, &SURVEY);
    let named = NamedTable::read(source, key, file, text_of, &is_header)?;
    let columns = named.columns(&SURVEY)?;
    let rows = &named.table.rows;
    let stations = rows
        .iter()
        .map(|row| station(row, &columns).map_err(|message| named.error(Some(row.line), &message)));
    let stations = stations.collect::<Result<_, _>>()?;
    let survey = Survey::new(stations).map_err(|reason| {
        let row = match reason {
            SurveyError::NoPlace(station) | SurveyError::GoesBack(station) => Some(station),
            SurveyError::TurnsRound(station) => Some(station + 1),
            SurveyError::BeginsBelow(_) => Some(0),
            _ => None,
        };
        let line = row.and_then(|row| rows.get(row)).map(|row| row.line);
        named.error(line, &reason.to_string())
    })?;
    let assumed = columns.assumed.iter().map(|(heading, unit)| {
        format!("{file}: `{heading}` names no unit: its numbers are taken to be in {unit}")
    });
    let comments = &named.table.comments;
    let comments = (!comments.is_empty()).then(|| comments_words(file, comments));
    let notes = SurveyNotes {
        doubts: assumed.collect(),
        notes: comments.into_iter().collect(),
    };
    Ok((survey, notes))
}

/// The station of a row.
fn station(row: &Row, columns: &Columns<OfSurvey>) -> Result<Station, String> {
    let within = |quantity, [least, most]: [f64; 2], unit: &str| {
        let value = columns.number(row, quantity)?;
        match (least..=most).contains(&value) {
            true => Ok(value),
            false => Err(columns.named(
                quantity,
                &format!("{value} {unit} is not between {least} and {most} {unit}"),
            )),
        }
    };
    Ok(Station {
        measured_depth: within(OfSurvey::Depth, [0.0, LONGEST_STRING], "m")?,
        inclination: within(OfSurvey::Inclination, [0.0, 180.0], "deg")?.to_radians(),
        azimuth: within(OfSurvey::Azimuth, [-360.0, 720.0], "deg")?.to_radians(),
    })
}
