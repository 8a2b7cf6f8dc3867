//! Files that a sweep file names, read once: a survey, and what was recorded.

use std::sync::Arc;

use linear::well::{Station, Survey};
use serde::Serialize;
use sim::Recording;

use super::compare::{self, Comparison};
use crate::design::Design;
use crate::quantities::{Axis, LONGEST_STRING};
use crate::sweep_file::{
    AutoOr, FileContent, Source, SurveyNotes, SweepFileError, TextOf, read_series, read_survey,
};

/// What was read.
#[derive(Debug, Clone, Default)]
pub struct Data {
    /// The course of the well.
    pub survey: Option<Arc<Survey>>,
    /// Whether the sweep file itself says it.
    is_straight: bool,
    /// The speed of the surface, rpm.
    pub surface_speed: Option<Recording>,
    /// What cases are held against.
    pub comparisons: Vec<Comparison>,
    /// What the survey does not say, and may mean.
    pub doubts: Vec<String>,
    /// What was ignored in the files, each once.
    pub notes: Vec<String>,
}

/// What results depend on, in the order in which it is hashed.
#[derive(Serialize)]
struct Meaning<'a> {
    survey: Option<Vec<[f64; 3]>>,
    recorded: Vec<[&'a [f64]; 2]>,
}

impl Data {
    /// Reads what the file names.
    ///
    /// # Errors
    /// Where a file cannot be read or is not what it should be.
    pub fn read(
        source: &Source,
        content: &FileContent,
        design: &Design,
        text_of: TextOf,
    ) -> Result<Self, SweepFileError> {
        let survey = (content.well.iter().flat_map(|well| &well.survey).next())
            .map(|file| read_survey(source, "well.survey", file, text_of))
            .transpose()?;
        let (survey, of_survey) = survey.unzip();
        let straight = straight(source, content)?;
        let SurveyNotes { doubts, mut notes } = of_survey.unwrap_or_default();
        let (key, column) = (
            "surface_speed_file",
            content.surface_speed_column.as_deref(),
        );
        let surface_speed = (content.surface_speed_file.as_ref())
            .map(|file| read_series(source, key, file, column, "_rpm", text_of))
            .transpose()?;
        let (surface_speed, of_surface) = surface_speed.unzip();
        let has_none = surface_speed.is_none() && column.is_some();
        let message = "names a column of `surface_speed_file`, which is not given";
        source.refuse_if(has_none, "surface_speed_column", message)?;
        if let Some(recording) = &surface_speed {
            check_surface(source, content, design, recording)?;
        }
        let (comparisons, of_comparisons) = compare::resolve(source, content, text_of)?;
        for note in of_surface.into_iter().flatten().chain(of_comparisons) {
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
        Ok(Self {
            is_straight: straight.is_some(),
            survey: survey.or(straight).map(Arc::new),
            surface_speed,
            comparisons,
            doubts,
            notes,
        })
    }

    /// The fastest that the surface was, rpm.
    pub fn fastest_surface_rpm(&self) -> Option<f64> {
        let speeds = self.surface_speed.as_ref()?.values().iter();
        Some(speeds.fold(0.0, |most: f64, speed| most.max(speed.abs())))
    }

    /// The time until which a case is held against a recording, s; 0 without one.
    pub fn compared_until(&self) -> f64 {
        let ends = self.comparisons.iter().map(|comparison| comparison.to);
        ends.fold(0.0, f64::max)
    }

    /// What results depend on of all this, if there is any.
    pub fn meaning(&self) -> Option<impl Serialize + use<'_>> {
        let recordings = (self.surface_speed.iter()).chain(
            self.comparisons
                .iter()
                .map(|comparison| &comparison.recorded),
        );
        let recorded: Vec<_> = recordings.map(|it| [it.times(), it.values()]).collect();
        let survey = self.survey.as_ref().filter(|_| !self.is_straight);
        let survey = survey.map(|survey| {
            let station = |it: &Station| [it.measured_depth, it.inclination, it.azimuth];
            survey.stations().iter().map(station).collect()
        });
        let is_there = survey.is_some() || !recorded.is_empty();
        is_there.then_some(Meaning { survey, recorded })
    }
}

/// The course of a well that the file says is straight, as deep as any string is long.
fn straight(source: &Source, content: &FileContent) -> Result<Option<Survey>, SweepFileError> {
    let key = "well.inclination_deg";
    let degrees = content.well.as_ref().and_then(|well| well.inclination_deg);
    let Some(degrees) = degrees else {
        return Ok(None);
    };
    let inclination = source.within(key, degrees, 0.0, 180.0, "°")?.to_radians();
    let station = |measured_depth: f64| Station {
        measured_depth,
        inclination,
        azimuth: 0.0,
    };
    let survey = Survey::new(vec![station(0.0), station(LONGEST_STRING)]);
    source.checked(key, survey).map(Some)
}

/// A recording takes the place of all else that says how the surface turns, and lasts as long as
/// the cases do.
fn check_surface(
    source: &Source,
    content: &FileContent,
    design: &Design,
    recording: &Recording,
) -> Result<(), SweepFileError> {
    let key = "surface_speed_file";
    let is_still = recording.values().iter().all(|speed| *speed == 0.0);
    source.refuse_if(is_still, key, "the surface does not turn in all the time")?;
    let message = "conflicts with `surface_speed_rpm`: give only one";
    let is_axis = design.axes().contains(&Axis::SurfaceSpeedRpm);
    let has_both = content.surface_speed_rpm.is_some() || is_axis;
    source.refuse_if(has_both, key, message)?;
    let message = "what was recorded rises as it did";
    let rises = content.surface_speed_rise_s != 0.0;
    source.refuse_if(rises, "surface_speed_rise_s", message)?;
    let message = format!(
        "the recording begins at {} s, after the start",
        recording.begin()
    );
    source.refuse_if(recording.begin() > 0.0, key, message)?;
    if let AutoOr::Given(time) = content.time_s {
        let message = format!("the surface was recorded for {} s only", recording.end());
        source.refuse_if(time > recording.end(), "time_s", message)?;
    }
    Ok(())
}
