//! `[string_friction]`: how the string lies in its well, and what friction does to its pieces.

use std::sync::Arc;

use linear::well::{PressedBy, QuasiStaticTwist, SideForce, least_pieces};
use linear::{Drillstring, Method, Mud, Sites};
use sim::PipeFriction;

use super::conditions::Conditions;
use super::data::Data;
use super::hole::survey_along;
use crate::design::Design;
use crate::quantities::Axis;
use crate::quantities::RPM;
use crate::sweep_file::{
    FileContent, MethodName, PressedByName, SectionTable, Source, SweepFileError, TubeTable,
};

/// More pieces than a string has joints make nothing better.
const MOST_PIECES: usize = 2000;

/// As many nodes of a string that rubs have some hundred responses between them.
const MANY_NODES: usize = 10;

/// Weights on bit at which pieces are held to a tolerance, where that is an axis: both ends, and
/// between them, as what presses may vanish somewhere.
const WEIGHTS: usize = 9;

/// A string that rubs along its well.
#[derive(Debug, Clone)]
pub struct StringFriction {
    /// Where torques act: in the middle of each piece, and at the bit; and the places that are
    /// observed.
    pub nodes: Sites,
    /// The piece of each node, where it is the middle of one.
    piece_of: Vec<Option<usize>>,
    /// Nodes of the sites that are observed.
    pub observed: Vec<usize>,
    pieces: usize,
    /// Whether these follow from a tolerance: friction then is divided between them as finely as
    /// they are cut. Where their number is given it stays as it was added up, so that the answers
    /// of files stay what they are.
    by_tolerance: bool,
    force: Arc<SideForce>,
    /// By how much friction in pieces is off.
    off_by: f64,
    /// Whether the greatest torque along the string is followed.
    pub follows_torque: bool,
    /// rad.
    inclination_at_bit: f64,
}

impl StringFriction {
    /// The friction of each node under a static coefficient; none where nothing presses it on the
    /// wall.
    pub fn at_nodes(&self, conditions: &Conditions, coefficient: f64) -> Vec<Option<PipeFriction>> {
        let weight_on_bit = 1e3 * conditions.weight_on_bit_kn.unwrap_or(0.0);
        let pieces = (self.pieces, self.by_tolerance);
        let pressing = friction_torques(&self.force, pieces, weight_on_bit);
        let ratio = conditions.string_friction_ratio.unwrap_or(1.0);
        let stribeck_speed = RPM * conditions.string_friction_stribeck_rpm.unwrap_or(0.0);
        let friction = |piece: &Option<usize>| {
            let pressed = pressing[(*piece)?];
            let torque_static = coefficient * pressed;
            (pressed > 0.0).then_some(PipeFriction {
                torque_static,
                torque_dynamic: ratio * torque_static,
                stribeck_speed,
            })
        };
        self.piece_of.iter().map(friction).collect()
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

    /// By how much the torque at the surface is off for that, in parts of that at which the string
    /// breaks loose ([`QuasiStaticTwist::off_by`]).
    pub fn off_by(&self) -> f64 {
        self.off_by
    }
}

/// Whether a method steps a string that rubs piece by piece, whose responses are short: where joining
/// pieces and making responses of them may change places. By others, and below a drive whose torque is
/// limited (N m), responses of the whole string lead from each node to every other.
pub fn is_in_pieces(method: &Method, drive_limit: Option<f64>) -> bool {
    let may_change_places = matches!(method, Method::Quadrature | Method::FiniteElement(_));
    may_change_places && drive_limit.is_none()
}

/// What to know of the methods of a string that rubs in many pieces, where one takes minutes to build
/// that others do not.
pub fn slow_methods_note(
    methods: &[Method],
    friction: &StringFriction,
    drive_limit: Option<f64>,
) -> Option<String> {
    let slow = methods
        .iter()
        .filter(|method| !is_in_pieces(method, drive_limit));
    let slow: Vec<&str> = slow.map(Method::name).collect();
    let are_many = friction.nodes.len() >= MANY_NODES;
    (are_many && !slow.is_empty()).then(|| {
        format!(
            "by {} the string rubs by responses between all of its {} pieces, which may take minutes \
             to build; {}",
            slow.join(" and "),
            friction.pieces,
            match drive_limit {
                None => "`quadrature` and `finite-element` step piece by piece, and begin at once",
                Some(_) => "fewer of them take less (`string_friction.pieces`)",
            }
        )
    })
}

/// How the string of the file rubs, where it does.
///
/// # Errors
/// Where a key is refused, or something needed is missing.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    (data, mud): (&Data, Option<Mud>),
    (conditions, design): (&Conditions, &Design),
    string: &Drillstring,
    sites: &Sites,
) -> Result<Option<StringFriction>, SweepFileError> {
    let Some(table) = &content.string_friction else {
        return Ok(None);
    };
    refuse_others(source, content)?;
    let Some(survey) = survey_along(source, data, string)? else {
        let message = "what presses the string on its wall follows from the survey: \
                       needs `survey` or `inclination_deg` in [well]";
        return Err(source.error("string_friction", message));
    };
    let pressed_by = match table.pressed_by {
        PressedByName::WeightAndTension => PressedBy::WeightAndTension,
        PressedByName::Weight => PressedBy::Weight,
    };
    let touching = |section: &SectionTable| {
        section
            .parts
            .iter()
            .map(TubeTable::contact_radius)
            .collect()
    };
    let touching: Vec<Vec<f64>> = content.string.sections.iter().map(touching).collect();
    let force = SideForce::touching(string, &touching, survey, mud, pressed_by);
    let weights = weights_on_bit(conditions, design);
    let by_tolerance = table.tolerance.is_some();
    let (key, pieces) = match table.tolerance {
        Some(tolerance) => {
            let key = "string_friction.tolerance";
            source.within(key, tolerance, 1e-4, 0.1, "")?;
            let windings = weights.iter().map(|weight| force.wound_up(*weight));
            let windings: Vec<QuasiStaticTwist> = windings.collect();
            let pieces = least_pieces(&windings, tolerance, MOST_PIECES);
            (key, source.checked(key, pieces)?)
        }
        None => {
            let (key, most) = ("string_friction.pieces", MOST_PIECES as f64);
            source.within(key, table.pieces as f64, 1.0, most, "")?;
            (key, table.pieces)
        }
    };
    let off_by = |weight: &f64| {
        let torques = friction_torques(&force, (pieces, by_tolerance), *weight);
        force.wound_up(*weight).off_by(&torques)
    };
    let off_by = weights.iter().map(off_by).fold(0.0, f64::max);
    let nodes = nodes(string, sites, pieces);
    let error = |error: linear::DrillstringError| source.error(key, error.to_string());
    let distances: Vec<f64> = nodes.iter().map(|(distance, _)| *distance).collect();
    let at = |distance: &f64| distances.iter().position(|node| node == distance);
    Ok(Some(StringFriction {
        nodes: Sites::new(string, &distances).map_err(error)?,
        piece_of: nodes.iter().map(|(_, piece)| *piece).collect(),
        observed: sites.distances_from_bit().iter().filter_map(at).collect(),
        pieces,
        by_tolerance,
        off_by,
        follows_torque: table.torque_along_string,
        inclination_at_bit: survey.inclination(string.length().min(survey.depth())),
        force: Arc::new(force),
    }))
}

/// Torque on each piece per coefficient of friction, N m; their number may follow from a tolerance.
fn friction_torques(
    force: &SideForce,
    (pieces, by_tolerance): (usize, bool),
    weight_on_bit: f64,
) -> Vec<f64> {
    if by_tolerance {
        force.wound_up(weight_on_bit).friction_torques(pieces)
    } else {
        force.friction_torques(pieces, weight_on_bit)
    }
}

/// Weights on bit that cases may have, N: what they press on the string changes what a number of
/// pieces is off by.
fn weights_on_bit(conditions: &Conditions, design: &Design) -> Vec<f64> {
    let given = match design.ends(Axis::TorqueDynamicNm) {
        // In place of a weight.
        Some(_) => 0.0,
        None => conditions.weight_on_bit_kn.unwrap_or(0.0),
    };
    let Some([least, most]) = design.ends(Axis::WeightOnBitKn) else {
        return vec![1e3 * given];
    };
    let part = |index: usize| index as f64 / (WEIGHTS - 1) as f64;
    let weight = |index: usize| 1e3 * (least + part(index) * (most - least));
    (0..WEIGHTS).map(weight).collect()
}

/// What is not known together with friction along the string.
fn refuse_others(source: &Source, content: &FileContent) -> Result<(), SweepFileError> {
    let message = "no accuracy is promised with friction along the string: leave it out";
    source.refuse_if(content.accuracy.is_some(), "accuracy", message)?;
    let follows = content.string_friction.as_ref();
    if !follows.is_some_and(|table| table.torque_along_string) {
        return Ok(());
    }
    let saturates = content.top_drive.is_some_and(|drive| drive.saturates);
    let message = "below a drive whose torque is limited the string is not in pieces, along which the torque \
                   is followed: leave one of both out";
    source.refuse_if(saturates, "string_friction.torque_along_string", message)?;
    for method in &content.methods {
        let is_in_pieces = matches!(method, MethodName::Quadrature | MethodName::FiniteElement);
        let key = "string_friction.torque_along_string";
        let message = format!(
            "the torque along the string is followed where that is in pieces, by quadrature or \
             finite-element, and not by {}: leave one of both out",
            method.name()
        );
        source.refuse_if(!is_in_pieces, key, message)?;
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
