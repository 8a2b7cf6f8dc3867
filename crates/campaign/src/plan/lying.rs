//! A string that lies in its hole: in a well whose course is known, on the walls of its sites.

use linear::{Drillstring, Mud, Sites};
use statics::{Bit, Contact, Course, LyingString, StaticsError};

use super::conditions::Conditions;
use super::data::Data;
use super::hole::survey_along;
use super::lateral::LateralSettings;
use super::wall::WallSettings;
use crate::sweep_file::{Source, SweepFileError};

/// What a string lies in.
#[derive(Debug, Clone, PartialEq)]
pub struct Lying {
    /// The course of its hole.
    course: Course,
    /// What buoys it.
    mud: Option<Mud>,
}

/// What the string of a setting with a wall lies in, where the course of its well is known.
///
/// # Errors
/// Where the survey is shorter than the string.
pub fn resolve(
    source: &Source,
    (data, mud): (&Data, Option<Mud>),
    string: &Drillstring,
    lateral: Option<&LateralSettings>,
) -> Result<Option<Lying>, SweepFileError> {
    if lateral.is_none() {
        return Ok(None);
    }
    let survey = survey_along(source, data, string)?;
    Ok(survey.map(|survey| Lying {
        course: Course::Surveyed(survey.clone()),
        mud,
    }))
}

impl Lying {
    /// The string as it lies there under the conditions of a case, on the walls of its sites; the bit
    /// too, where that is one of them.
    ///
    /// # Errors
    /// Where sites are too close to each other.
    pub fn string(
        &self,
        (string, sites): (&Drillstring, &Sites),
        lateral: &LateralSettings,
        conditions: &Conditions,
    ) -> Result<LyingString, StaticsError> {
        let bit = match sites.bit_site() {
            Some(_) => Bit::Contact,
            None => Bit::Free,
        };
        let weight_on_bit = 1e3 * conditions.weight_on_bit_kn.unwrap_or(0.0);
        let bending = &lateral.bending;
        let around = statics::Conditions {
            mud: self.mud,
            // Pre-compression pushes as a weight does.
            weight_on_bit: weight_on_bit + bending.compression,
            bit,
            ..statics::Conditions::new(bending.youngs_modulus, self.course.clone())
        };
        LyingString::new(string, &around, &contacts(sites, lateral, conditions))
    }
}

/// The walls of sites, as contacts.
fn contacts(sites: &Sites, lateral: &LateralSettings, conditions: &Conditions) -> Vec<Contact> {
    let sites = sites.distances_from_bit().iter().zip(&lateral.walls);
    let contact = |(distance_from_bit, wall): (&f64, &WallSettings)| {
        let wall = wall.in_case(conditions);
        Contact {
            distance_from_bit: *distance_from_bit,
            clearance: wall.clearance,
            radius: wall.radius,
            stiffness: wall.stiffness.is_finite().then_some(wall.stiffness),
        }
    };
    sites.map(contact).collect()
}
