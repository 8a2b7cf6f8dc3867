//! `[string_friction]`: how the string lies in its well, and what friction does to its pieces.

use std::sync::Arc;

use linear::well::{PressedBy, SideForce};
use linear::{Drillstring, Mud, Sites};
use sim::{NodeTorque, PipeFriction};

use super::conditions::{Conditions, RPM};
use super::data::Data;
use super::hole::survey_along;
use crate::sweep_file::{FileContent, MethodName, PressedByName, Source, SweepFileError};

/// More pieces than a string has joints make nothing better.
const MOST_PIECES: f64 = 2000.0;

/// A string that rubs along its well.
#[derive(Debug, Clone)]
pub struct StringFriction {
    /// Where torques act: in the middle of each piece, and at the bit; and the places that are
    /// looked at.
    pub nodes: Sites,
    /// The piece of each node, where it is the middle of one.
    piece_of: Vec<Option<usize>>,
    /// Nodes of the sites that are looked at.
    pub looked_at: Vec<usize>,
    pieces: usize,
    force: Arc<SideForce>,
    /// rad.
    inclination_at_bit: f64,
}

impl StringFriction {
    /// What acts at each node under a static coefficient, and at the bit.
    pub fn torques(
        &self,
        conditions: &Conditions,
        coefficient: f64,
        at_bit: NodeTorque,
    ) -> Vec<NodeTorque> {
        let weight_on_bit = 1e3 * conditions.weight_on_bit_kn.unwrap_or(0.0);
        let pressing = self.force.friction_torques(self.pieces, weight_on_bit);
        let ratio = conditions.string_friction_ratio.unwrap_or(1.0);
        let stribeck_speed = RPM * conditions.string_friction_stribeck_rpm.unwrap_or(0.0);
        let last = self.piece_of.len() - 1;
        let torque = |(node, piece): (usize, &Option<usize>)| match piece {
            Some(piece) if pressing[*piece] > 0.0 => {
                let torque_static = coefficient * pressing[*piece];
                NodeTorque::Pipe(PipeFriction {
                    torque_static,
                    torque_dynamic: ratio * torque_static,
                    stribeck_speed,
                })
            }
            _ if node == last => at_bit,
            _ => NodeTorque::None,
        };
        self.piece_of.iter().enumerate().map(torque).collect()
    }

    /// What the hook carries above a bit off bottom, N.
    pub fn hook_load(&self) -> f64 {
        self.force.hook_load()
    }

    /// Torque that it takes to turn all of the string, N m per coefficient of friction.
    pub fn torque_to_turn(&self, weight_on_bit: f64) -> f64 {
        self.force
            .friction_torques(self.pieces, weight_on_bit)
            .iter()
            .sum()
    }

    /// Inclination of the well at the bit, rad.
    pub fn inclination_at_bit(&self) -> f64 {
        self.inclination_at_bit
    }

    /// How many pieces slip as wholes.
    pub fn pieces(&self) -> usize {
        self.pieces
    }
}

/// How the string of the file rubs, where it does.
///
/// # Errors
/// Where a key is refused, or something needed is missing.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    data: &Data,
    string: &Drillstring,
    sites: &Sites,
    mud: Option<Mud>,
) -> Result<Option<StringFriction>, SweepFileError> {
    let Some(table) = &content.string_friction else {
        return Ok(None);
    };
    refuse_others(source, content)?;
    let Some(survey) = survey_along(source, data, string)? else {
        let message = "what presses the string on its wall follows from the survey: \
                       needs `survey` in [well]";
        return Err(source.error("string_friction", message));
    };
    let pieces = table.pieces;
    let (key, most) = ("string_friction.pieces", MOST_PIECES);
    source.within(key, pieces as f64, 1.0, most, "")?;
    let pressed_by = match table.pressed_by {
        PressedByName::WeightAndTension => PressedBy::WeightAndTension,
        PressedByName::Weight => PressedBy::Weight,
    };
    let nodes = nodes(string, sites, pieces);
    let error =
        |error: linear::DrillstringError| source.error("string_friction.pieces", error.to_string());
    let distances: Vec<f64> = nodes.iter().map(|(distance, _)| *distance).collect();
    let at = |distance: &f64| distances.iter().position(|node| node == distance);
    Ok(Some(StringFriction {
        nodes: Sites::new(string, &distances).map_err(error)?,
        piece_of: nodes.iter().map(|(_, piece)| *piece).collect(),
        looked_at: sites.distances_from_bit().iter().filter_map(at).collect(),
        pieces,
        inclination_at_bit: survey.inclination(string.length().min(survey.depth())),
        force: Arc::new(SideForce::new(string, survey, mud, pressed_by)),
    }))
}

/// What is not stepped together with friction along the string.
fn refuse_others(source: &Source, content: &FileContent) -> Result<(), SweepFileError> {
    let message = "lateral motion and friction along the string are not simulated together";
    source.refuse_if(content.wall.is_some(), "wall", message)?;
    let message = "no accuracy is promised with friction along the string: leave it out";
    source.refuse_if(content.accuracy.is_some(), "accuracy", message)?;
    for (index, method) in content.methods.iter().enumerate() {
        let is_able = matches!(method, MethodName::Quadrature | MethodName::FiniteElement);
        let message = format!(
            "friction along the string is stepped by quadrature or finite-element, not by {}: \
             give `methods`",
            method.name()
        );
        let given = source.gives("methods");
        let key = if given {
            format!("methods[{index}]")
        } else {
            "string_friction".to_owned()
        };
        source.refuse_if(!is_able, &key, message)?;
    }
    Ok(())
}

/// Distances from the bit, from the surface down, and which is the middle of which piece,
/// counted from the surface.
fn nodes(string: &Drillstring, sites: &Sites, pieces: usize) -> Vec<(f64, Option<usize>)> {
    let piece = string.length() / pieces as f64;
    let middle = |index: usize| {
        let distance = (pieces as f64 - index as f64 - 0.5) * piece;
        (distance, Some(index))
    };
    let mut nodes: Vec<(f64, Option<usize>)> = (0..pieces).map(middle).collect();
    for &site in sites.distances_from_bit() {
        // A site in the middle of a piece is its node.
        match nodes
            .iter_mut()
            .find(|(node, _)| (node - site).abs() < 1e-6)
        {
            Some((node, _)) => *node = site,
            None => nodes.push((site, None)),
        }
    }
    nodes.sort_by(|one, other| other.0.total_cmp(&one.0));
    nodes
}
