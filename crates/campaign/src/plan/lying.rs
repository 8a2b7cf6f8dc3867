//! A string that lies in its hole: in a well whose course is known, on the walls of its sites.

use linear::bending_modes::holding_spring;
use linear::well::{PressedBy, PressedLength, SideForce, Survey};
use linear::{Drillstring, Mud, Sites, SurfaceSupport};
use sim::Wall;
use statics::{Bit, Contact, ContactState, Course, LyingString, StaticState, StaticsError, Top};

use super::conditions::Conditions;
use super::data::Data;
use super::hole::survey_along;
use super::lateral::LateralSettings;
use super::wall::WallSettings;
use crate::sweep_file::{FileContent, MethodName, SitesName, Source, SweepFileError};

/// The part of its clearance by which a site that does not touch is kept from its wall, so that no
/// rounding makes it touch.
const KEPT_OFF: f64 = 1e-12;

/// A string that may touch besides its sites is modelled this much further than where it does, m.
const LEAST_ABOVE: f64 = 0.5;

/// How a case begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LyingStart {
    /// Lying as at rest.
    AtRest,
    /// Sliding steadily on its walls as its surface turns, rad/s, clockwise looking down.
    Sliding(f64),
}

impl LyingStart {
    /// The coefficient of friction on each wall, from the surface down.
    fn frictions(self, walls: &[Wall]) -> Vec<f64> {
        match self {
            Self::AtRest => vec![0.0; walls.len()],
            Self::Sliding(speed) => (walls.iter())
                .map(|wall| wall.friction_at(wall.radius * speed.abs()).copysign(speed))
                .collect(),
        }
    }
}

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
    content: &FileContent,
    (data, mud): (&Data, Option<Mud>),
    string: &Drillstring,
    lateral: Option<&LateralSettings>,
) -> Result<Option<Lying>, SweepFileError> {
    if lateral.is_none() || !content.lies_on_low_side() {
        let message = "says whether a string lies in an inclined well: needs `well.survey` or \
                       `well.inclination_deg`";
        let is_said = content.wall.and_then(|wall| wall.lies_on_low_side) == Some(true);
        source.refuse_if(is_said, "wall.lies_on_low_side", message)?;
        return Ok(None);
    }
    let message = "is relative to what brings a string from the middle of its hole to its wall; one \
                   that lies there needs `amount_ns` instead";
    for (index, impulse) in content.impulses.iter().enumerate() {
        let key = format!("impulses[{index}].ratio");
        source.refuse_if(impulse.amount_ns.is_none(), &key, message)?;
    }
    let message = "loses the slow tail of the displacement, without which a string that lies in its hole \
                   does not come back to where it lies: use held, quadrature or finite-element";
    for (index, name) in content.methods.iter().enumerate() {
        let loses_tail = matches!(name, MethodName::Hilbert | MethodName::DirectIdft);
        source.refuse_if(loses_tail, &format!("methods[{index}]"), message)?;
    }
    let survey = survey_along(source, data, string)?;
    Ok(survey.map(|survey| Lying {
        survey: survey.clone(),
        mud,
    }))
}

impl Lying {
    /// The string as it lies there under the conditions of a case, on the walls of its sites; the bit
    /// too, where that is one of them, and it is not said how it is held.
    ///
    /// # Errors
    /// Where sites are too close to each other.
    pub fn string(
        &self,
        at: (&Drillstring, &Sites),
        lateral: &LateralSettings,
        case: (&Conditions, Option<Bit>),
    ) -> Result<LyingString, StaticsError> {
        self.string_on(&contacts(at.1, lateral, case.0), at, lateral, case)
    }

    /// String at rest, which may touch besides its sites, too.
    ///
    /// # Errors
    /// As [`Self::string`].
    pub fn resting_string(
        &self,
        at: (&Drillstring, &Sites),
        lateral: &LateralSettings,
        case: (&Conditions, Option<Bit>),
    ) -> Result<LyingString, StaticsError> {
        let besides = lateral.besides.iter();
        let besides = besides.map(|(place, wall)| contact(*place, wall, case.0));
        let contacts: Vec<Contact> = contacts(at.1, lateral, case.0)
            .into_iter()
            .chain(besides)
            .collect();
        self.string_on(&contacts, at, lateral, case)
    }

    fn string_on(
        &self,
        contacts: &[Contact],
        (string, sites): (&Drillstring, &Sites),
        lateral: &LateralSettings,
        (conditions, bit): (&Conditions, Option<Bit>),
    ) -> Result<LyingString, StaticsError> {
        let bit = bit.unwrap_or(match sites.bit_site() {
            Some(_) => Bit::Contact,
            None => Bit::Free,
        });
        // Places besides sites are close together.
        let highest = contacts
            .iter()
            .fold(0.0, |most: f64, it| most.max(it.distance_from_bit));
        let upper_end = Top::AboveContacts.distance(sites.distances_from_bit(), string.length());
        let upper_end = upper_end.max(string.length().min(highest + LEAST_ABOVE));
        let course = Course::Surveyed(self.survey.clone());
        let around = statics::Conditions {
            mud: self.mud,
            weight_on_bit: pushed(lateral, conditions),
            bit,
            surface: lateral.support,
            // Higher up it would hang through its wall, and all that weight on the highest sites.
            top: Top::OnWall(upper_end),
            ..statics::Conditions::new(lateral.bending.youngs_modulus, course)
        };
        LyingString::new(string, &around, contacts)
    }
}

impl Lying {
    /// How a case finds it at its walls.
    ///
    /// # Errors
    /// Where there is no such state.
    pub fn in_case(
        &self,
        at: (&Drillstring, &Sites),
        (lateral, conditions): (&LateralSettings, &Conditions),
        walls: &[Wall],
        begins: LyingStart,
    ) -> Result<sim::Lying, StaticsError> {
        let frictions = begins.frictions(walls);
        let state = self.state(at, (lateral, conditions), walls, begins)?;
        Ok(as_walls_have_it(&state, walls, &frictions))
    }

    /// The string as a case finds it.
    ///
    /// # Errors
    /// Where there is no such state.
    pub fn state(
        &self,
        at: (&Drillstring, &Sites),
        (lateral, conditions): (&LateralSettings, &Conditions),
        walls: &[Wall],
        begins: LyingStart,
    ) -> Result<StaticState, StaticsError> {
        let lying = self.string(at, lateral, (conditions, None))?;
        match begins {
            LyingStart::AtRest => lying.at_rest(),
            LyingStart::Sliding(_) => lying.sliding_with(&begins.frictions(walls)),
        }
    }

    /// The string as one without stiffness in bending, from the surface down.
    pub fn along(
        &self,
        string: &Drillstring,
        (lateral, conditions): (&LateralSettings, &Conditions),
    ) -> Vec<PressedLength> {
        let soft = SideForce::new(string, &self.survey, self.mud, PressedBy::WeightAndTension);
        soft.along(pushed(lateral, conditions)).collect()
    }

    /// What a string without stiffness in bending presses on the hole with, up to a distance from the
    /// bit (m): at each of a number of places (m from the bit, from the surface down) what is nearer
    /// to it than to others, N.
    pub fn soft_forces(
        &self,
        string: &Drillstring,
        (lateral, conditions): (&LateralSettings, &Conditions),
        (places, top): (&[f64], f64),
    ) -> Vec<f64> {
        let mut forces = vec![0.0; places.len()];
        for it in self.along(string, (lateral, conditions)) {
            let (distance, force) = (string.length() - it.depth, it.load * it.length);
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
    let contact = |(place, wall): (&f64, &WallSettings)| contact(*place, wall, conditions);
    sites.map(contact).collect()
}

fn contact(distance_from_bit: f64, wall: &WallSettings, conditions: &Conditions) -> Contact {
    let wall = wall.in_case(conditions);
    Contact {
        distance_from_bit,
        clearance: wall.clearance,
        radius: wall.radius,
        stiffness: wall.stiffness.is_finite().then_some(wall.stiffness),
    }
}

/// A static state with the forces that the laws of the walls answer with where it is.
fn as_walls_have_it(state: &StaticState, walls: &[Wall], frictions: &[f64]) -> sim::Lying {
    let contacts = state.contacts();
    let met = contacts.iter().zip(walls);
    let (positions, normals): (Vec<[f64; 2]>, Vec<f64>) =
        met.map(|(it, wall)| met_by(it, wall)).unzip();
    let rubbing = normals.iter().zip(frictions);
    let along: Vec<f64> = rubbing
        .map(|(normal, friction)| normal * friction)
        .collect();
    let pressed = positions.iter().zip(normals.iter().zip(&along));
    let forces = pressed.map(|([x, y], (normal, along))| {
        if *normal == 0.0 {
            return [0.0; 2];
        }
        let radius = x.hypot(*y);
        let [cos, sin] = [x / radius, y / radius];
        [-normal * cos + along * sin, -normal * sin - along * cos]
    });
    let torque = |(along, wall): (&f64, &Wall)| -along * wall.radius;
    sim::Lying {
        forces: forces.collect(),
        torques: along.iter().zip(walls).map(torque).collect(),
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

/// Whether a string lies in its hole at sites that are yet to be found.
pub fn finds_sites(content: &FileContent) -> bool {
    let finds = content.wall.map(|wall| wall.sites) == Some(SitesName::Auto);
    content.lies_on_low_side() && finds
}

/// Whether a string buckles between its sites, even if it is held at every one.
pub fn buckles_between(string: &Drillstring, lateral: &LateralSettings, sites: &Sites) -> bool {
    let spring = holding_spring(string, &lateral.bending, lateral.support, sites);
    matches!(spring, Ok(None))
}

/// A string that lies in its hole, held above its sites where it is at rest, and they with springs
/// that keep it from buckling where it does without its walls. Where sites are yet to be found, it
/// is held at the surface alone.
///
/// # Errors
/// Where no springs at its sites keep it from buckling.
pub fn held(
    source: &Source,
    content: &FileContent,
    (string, mut lateral, sites): (Drillstring, Option<LateralSettings>, Sites),
) -> Result<(Drillstring, Option<LateralSettings>, Sites), SweepFileError> {
    let Some(bends) = lateral.as_mut().filter(|_| content.lies_on_low_side()) else {
        return Ok((string, lateral, sites));
    };
    let length = string.length();
    let upper_end = Top::AboveContacts.distance(sites.distances_from_bit(), length);
    let string = match bends.finding {
        None if upper_end < length => {
            bends.support = SurfaceSupport::Pinned;
            source.checked("wall.sites", string.held_above(upper_end))?
        }
        _ => string,
    };
    let spring = holding_spring(&string, &bends.bending, bends.support, &sites);
    let sites = match source.checked("wall", spring)? {
        Some(0.0) => sites,
        Some(spring) => {
            let springs = vec![spring; sites.len()];
            source.checked("wall", sites.held_by(springs))?
        }
        None => {
            let message = "the string buckles even if it is held at every site: more sites, closer \
                           together, hold it, or less weight on bit";
            return Err(source.error("wall.sites", message));
        }
    };
    Ok((string, lateral, sites))
}
