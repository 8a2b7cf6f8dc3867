//! A string that lies on the low side of its hole: of an inclined well, with a wall.

use linear::bending_modes::holding_spring;
use linear::well::Survey;
use linear::{Bending, Drillstring, Mud, Sites, SurfaceSupport};
use sim::{Lying, Wall};
use statics::{
    Bit, Conditions, Contact, ContactState, Course, LyingString, StaticState, StaticsError,
};

use super::hole::survey_along;
use super::lateral::LateralSettings;
use crate::plan::Data;
use crate::sweep_file::{FileContent, Source, SweepFileError};

/// The acceleration beyond which a shock is counted, where the file does not say it, in g.
const SHOCK_G: f64 = 25.0;

/// The part of its clearance by which a site that does not touch is kept from its wall, so that no
/// rounding makes it touch.
const KEPT_OFF: f64 = 1e-12;

/// How a string lies, but for what a case says of its walls.
#[derive(Debug, Clone, PartialEq)]
pub struct LyingSettings {
    conditions: Conditions,
}

/// How a case begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LyingStart {
    /// Lying as at rest.
    AtRest,
    /// Sliding steadily on its walls, clockwise looking down.
    Sliding,
}

impl LyingSettings {
    /// The string at walls, by their distances from the bit (m).
    ///
    /// # Errors
    /// Where they are not those of a string.
    pub fn string(
        &self,
        string: &Drillstring,
        sites: &Sites,
        walls: &[Wall],
    ) -> Result<LyingString, StaticsError> {
        let places = sites.distances_from_bit().iter().zip(walls);
        let contact = |(&distance_from_bit, wall): (&f64, &Wall)| Contact {
            distance_from_bit,
            clearance: wall.clearance,
            radius: wall.radius,
            stiffness: Some(wall.stiffness).filter(|stiffness| stiffness.is_finite()),
        };
        let contacts: Vec<Contact> = places.map(contact).collect();
        let bit = match sites.bit_site() {
            Some(_) => Bit::Contact,
            None => Bit::Free,
        };
        let conditions = Conditions {
            bit,
            ..self.conditions.clone()
        };
        LyingString::new(string, &conditions, &contacts)
    }

    /// How a case finds it at its walls.
    ///
    /// # Errors
    /// Where there is no such state.
    pub fn in_case(
        &self,
        string: &Drillstring,
        sites: &Sites,
        walls: &[Wall],
        begins: LyingStart,
    ) -> Result<Lying, StaticsError> {
        let lying = self.string(string, sites, walls)?;
        let friction = match begins {
            LyingStart::AtRest => 0.0,
            LyingStart::Sliding => walls.iter().map(|wall| wall.friction).fold(0.0, f64::max),
        };
        let state = match friction {
            0.0 => lying.at_rest()?,
            friction => lying.sliding(friction)?,
        };
        Ok(as_walls_have_it(&state, walls, friction))
    }
}

/// A static state with the forces that the laws of the walls answer with where it is.
fn as_walls_have_it(state: &StaticState, walls: &[Wall], friction: f64) -> Lying {
    let contacts = state.contacts();
    let met = contacts.iter().zip(walls);
    let (positions, normals): (Vec<[f64; 2]>, Vec<f64>) =
        met.map(|(it, wall)| met_by(it, wall)).unzip();
    let forces = positions.iter().zip(&normals).map(|([x, y], normal)| {
        let radius = x.hypot(*y);
        if *normal == 0.0 {
            return [0.0; 2];
        }
        let [cos, sin] = [x / radius, y / radius];
        let along = friction * normal;
        [-normal * cos + along * sin, -normal * sin - along * cos]
    });
    let torque = |(normal, wall): (&f64, &Wall)| -friction * normal * wall.radius;
    Lying {
        forces: forces.collect(),
        torques: normals.iter().zip(walls).map(torque).collect(),
        low_side: (contacts.iter())
            .map(|it| it.high_side + std::f64::consts::PI)
            .collect(),
        positions,
    }
}

/// Where a string is at a wall, and what that presses with: at rigid ones as the state has it, at
/// others as their law answers there.
fn met_by(state: &ContactState, wall: &Wall) -> ([f64; 2], f64) {
    let [x, y] = state.displacement;
    let radius = x.hypot(y);
    let at = |there: f64| [x, y].map(|it| it * there / radius);
    match wall.stiffness.is_finite() {
        true if radius > wall.clearance => {
            let depth = radius - wall.clearance;
            ([x, y], wall.stiffness * depth.powf(1.5))
        }
        false if state.touches => (at(wall.clearance), state.normal()),
        // Not touching, up to rounding.
        _ if radius >= wall.clearance => (at((1.0 - KEPT_OFF) * wall.clearance), 0.0),
        _ => ([x, y], 0.0),
    }
}

/// The string's lateral part as it lies, where it does, with springs at its sites where it buckles
/// without its walls.
///
/// # Errors
/// Where something needed is missing, or no state is found.
pub(super) fn resolve(
    source: &Source,
    content: &FileContent,
    (data, mud): (&Data, Option<Mud>),
    weight_on_bit: f64,
    string: &Drillstring,
    (lateral, sites): (&mut Option<LateralSettings>, Sites),
) -> Result<Sites, SweepFileError> {
    let Some(lateral) = lateral else {
        return Ok(sites);
    };
    let wall = content.wall.unwrap_or_default();
    let lies = content.lies_on_low_side();
    let shock = wall.shock_g.or(lies.then_some(SHOCK_G));
    if let Some(shock) = shock {
        let shock = source.within("wall.shock_g", shock, 1e-3, 1e5, "g")?;
        lateral.shocks = Some(shock * linear::well::GRAVITY);
    }
    let survey = match lies {
        true => survey_along(source, data, string)?,
        false => None,
    };
    let Some(survey) = survey else {
        let message = "says whether a string lies in an inclined well: needs `well.survey` or \
                       `well.inclination_deg`";
        source.refuse_if(wall.lies_on_low_side == Some(true), LIES, message)?;
        return Ok(sites);
    };
    refuse_others(source, content, &lateral.bending)?;
    let lying = LyingSettings {
        conditions: Conditions {
            mud,
            weight_on_bit,
            ..Conditions::new(lateral.bending.youngs_modulus, course(survey))
        },
    };
    let sites = held(source, string, (&lateral.bending, lateral.support), sites)?;
    lateral.lying = Some(lying);
    Ok(sites)
}

/// The key that says whether a string lies in its hole.
const LIES: &str = "wall.lies_on_low_side";

fn course(survey: &Survey) -> Course {
    Course::Surveyed(survey.clone())
}

/// Refuses what goes with a string in the middle of its hole alone.
fn refuse_others(
    source: &Source,
    content: &FileContent,
    bending: &Bending,
) -> Result<(), SweepFileError> {
    let message = "the axial force of a string that lies in its hole follows from its weight: \
                   needs a compression of 0";
    let is_compressed = bending.compression != 0.0;
    source.refuse_if(is_compressed, "string.bending.compression_kn", message)?;
    let message = "is relative to what brings a string from the middle of its hole to its wall; one \
                   that lies there needs `amount_ns` instead";
    for (index, impulse) in content.impulses.iter().enumerate() {
        let key = format!("impulses[{index}].ratio");
        source.refuse_if(impulse.amount_ns.is_none(), &key, message)?;
    }
    Ok(())
}

/// The sites with springs that keep the string from buckling, where it buckles without its walls.
fn held(
    source: &Source,
    string: &Drillstring,
    (bending, support): (&Bending, SurfaceSupport),
    sites: Sites,
) -> Result<Sites, SweepFileError> {
    let spring = source.checked("wall", holding_spring(string, bending, support, &sites))?;
    match spring {
        Some(0.0) => Ok(sites),
        Some(spring) => {
            let springs = vec![spring; sites.len()];
            source.checked("wall", sites.held_by(springs))
        }
        None => {
            let message = "the string buckles even if it is held at every site: more sites, closer \
                           together and higher up, hold it, or less weight on bit";
            Err(source.error("wall.sites", message))
        }
    }
}
