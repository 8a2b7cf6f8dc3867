//! A string that lies in its hole: in a well whose course is known, on the walls of its sites.

use linear::well::{PressedBy, SideForce, Survey};
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
    survey: Survey,
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
        survey: survey.clone(),
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
        let course = Course::Surveyed(self.survey.clone());
        let around = statics::Conditions {
            mud: self.mud,
            weight_on_bit: pushed(lateral, conditions),
            bit,
            ..statics::Conditions::new(lateral.bending.youngs_modulus, course)
        };
        LyingString::new(string, &around, &contacts(sites, lateral, conditions))
    }
}

impl Lying {
    /// What a string without stiffness in bending presses on the hole with, up to a distance from the
    /// bit (m): at each of a number of places (m from the bit, from the surface down) what is nearer
    /// to it than to others, N.
    pub fn soft_forces(
        &self,
        string: &Drillstring,
        (lateral, conditions): (&LateralSettings, &Conditions),
        (places, top): (&[f64], f64),
    ) -> Vec<f64> {
        let soft = SideForce::new(string, &self.survey, self.mud, PressedBy::WeightAndTension);
        let mut forces = vec![0.0; places.len()];
        for [depth, force] in soft.forces(pushed(lateral, conditions)) {
            let distance = string.length() - depth;
            // From the surface down.
            let below = places.partition_point(|place| *place > distance);
            let off = |site: &usize| (places[*site] - distance).abs();
            let near = [below.checked_sub(1), Some(below)].into_iter().flatten();
            let nearest = near
                .filter(|site| *site < places.len())
                .min_by(|one, other| off(one).total_cmp(&off(other)));
            if let Some(site) = nearest.filter(|_| distance <= top) {
                forces[site] += force;
            }
        }
        forces
    }
}

/// What pushes the string at its bit, N: pre-compression as a weight does.
fn pushed(lateral: &LateralSettings, conditions: &Conditions) -> f64 {
    1e3 * conditions.weight_on_bit_kn.unwrap_or(0.0) + lateral.bending.compression
}

/// The dynamic coefficient of friction at each site, from the surface down, where all are known.
pub fn frictions(lateral: &LateralSettings, conditions: &Conditions) -> Option<Vec<f64>> {
    let walls = lateral.walls.iter().map(|wall| wall.in_case(conditions));
    walls
        .map(|wall| Some(wall.friction? * wall.dynamic_ratio))
        .collect()
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
