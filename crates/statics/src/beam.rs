//! The string as beam elements across its hole, from the surface, or a cut, down.
//!
//! The place of the string is that of the hole's axis plus u, small across it; with the curvature
//! κn of the hole the moment is EI (κn + u″), and
//!
//! ```text
//! ∫ EI u″·v″ + T u′·v′ ds = ∫ (w g + T κn)·v ds − ∫ EI κn·v″ ds + Σ F·v      for every v,
//! ```
//!
//! with w the buoyed weight, g the way down across the hole, T the effective tension and F the
//! contact forces. So tension presses the string to the inside of a bend, and where EI κn jumps, at
//! a change of tube, at the end of an arc or at a free end, it puts a couple on the string. T is −W
//! at the bit, at any pressure, and grows upwards by w cos I.

use linear::well::GRAVITY;
use linear::{Drillstring, SurfaceSupport, Tube};

use crate::conditions::{Conditions, Top};
use crate::contact::Contact;
use crate::course::{Axes, dot};
use crate::error::StaticsError;

/// The longest element, m: forces are then as by elements of half the length up to 1e-7.
const LONGEST_ELEMENT: f64 = 0.5;

/// The shortest, m: of one much shorter, rounding would leave nothing. A change of tube as near to
/// a contact is taken to be there.
const SHORTEST_ELEMENT: f64 = 2e-3;

/// Loads out of the vertical plane below this part of those in it are rounding, as curvatures below this
/// are, 1/m.
const SAME_PLANE: f64 = 1e-6;
const STRAIGHT: f64 = 1e-8;

/// Unknowns of a node: displacement and slope along either axis.
pub(crate) const FREEDOMS: usize = 4;

/// An element, from the upper of its nodes to the next.
#[derive(Debug, Clone)]
pub(crate) struct Element {
    pub(crate) tube: Tube,
    pub(crate) length: f64,
    /// EI, N m².
    pub(crate) rigidity: f64,
    /// Effective tension without weight on bit, N, at its upper and lower end.
    tension: [f64; 2],
    /// Of the hole, along both axes, 1/m.
    pub(crate) curvature: [f64; 2],
    /// Load per length without weight on bit, N/m, along both axes, at [`GAUSS`].
    load: [[f64; 2]; 3],
}

/// The string as elements.
#[derive(Debug, Clone)]
pub(crate) struct Beam {
    pub(crate) elements: Vec<Element>,
    /// Distances of the nodes from the bit, m, from the top down.
    pub(crate) distances: Vec<f64>,
    /// The node of each contact, from the top down.
    pub(crate) contact_nodes: Vec<usize>,
    /// Unknowns of the uppermost node that are given.
    pub(crate) held_above: &'static [usize],
    /// How far from the middle of the hole it is held there, m, on the side to which loads press it.
    pub(crate) aside_above: f64,
    /// By which the high side is turned from the first axis at each node, rad.
    pub(crate) high_side: Vec<f64>,
    /// Whether the hole stays in one vertical plane, so that nothing moves the string sideways.
    pub(crate) hole_is_plane: bool,
}

/// Places along an element, as parts of it, and their weights: exact up to the fifth power.
const GAUSS: [(f64, f64); 3] = [
    (0.112_701_665_379_258_31, 5.0 / 18.0),
    (0.5, 4.0 / 9.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];

impl Element {
    /// Effective tension at its upper and lower end, N, under a weight on bit (N).
    pub(crate) fn tension(&self, weight_on_bit: f64) -> [f64; 2] {
        self.tension.map(|tension| tension - weight_on_bit)
    }

    fn tension_at(&self, part: f64, weight_on_bit: f64) -> f64 {
        let [upper, lower] = self.tension(weight_on_bit);
        upper + part * (lower - upper)
    }

    /// Its stiffness in one plane: displacement and slope of the upper node, then of the lower.
    pub(crate) fn stiffness(&self, weight_on_bit: f64) -> [[f64; 4]; 4] {
        let l = self.length;
        let scale = self.rigidity / l.powi(3);
        let mut stiffness = [
            [12.0, 6.0 * l, -12.0, 6.0 * l],
            [6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l],
            [-12.0, -6.0 * l, 12.0, -6.0 * l],
            [6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l],
        ]
        .map(|row| row.map(|entry| scale * entry));
        for (part, weight) in GAUSS {
            let tension = self.tension_at(part, weight_on_bit);
            let slopes = slopes(part, l);
            for row in 0..4 {
                for column in 0..4 {
                    stiffness[row][column] += weight * l * tension * slopes[row] * slopes[column];
                }
            }
        }
        stiffness
    }

    /// Whether what presses and bends it out of the vertical plane of the bit is rounding.
    fn is_in_plane(&self) -> bool {
        let along = |plane: usize| {
            self.load
                .map(|it| it[plane].abs())
                .into_iter()
                .fold(0.0, f64::max)
        };
        along(1) <= SAME_PLANE * along(0) && self.curvature[1].abs() <= STRAIGHT
    }

    /// What loads along it put on its nodes in a plane, couples of its curvature included.
    pub(crate) fn nodal_loads(&self, plane: usize, weight_on_bit: f64) -> [f64; 4] {
        let couple = self.rigidity * self.curvature[plane];
        let mut loads = [0.0, couple, 0.0, -couple];
        for ((part, weight), load) in GAUSS.into_iter().zip(self.load) {
            let load = load[plane] - weight_on_bit * self.curvature[plane];
            let shapes = shapes(part, self.length);
            for (sum, shape) in loads.iter_mut().zip(shapes) {
                *sum += weight * self.length * load * shape;
            }
        }
        loads
    }
}

/// Cubic shape functions at a part of an element of a length (m).
pub(crate) fn shapes(x: f64, l: f64) -> [f64; 4] {
    let (x2, x3) = (x * x, x * x * x);
    [
        1.0 - 3.0 * x2 + 2.0 * x3,
        l * (x - 2.0 * x2 + x3),
        3.0 * x2 - 2.0 * x3,
        l * (x3 - x2),
    ]
}

/// Their slopes.
pub(crate) fn slopes(x: f64, l: f64) -> [f64; 4] {
    let x2 = x * x;
    [
        6.0 * (x2 - x) / l,
        1.0 - 4.0 * x + 3.0 * x2,
        6.0 * (x - x2) / l,
        3.0 * x2 - 2.0 * x,
    ]
}

impl Beam {
    /// Of a string with contacts from the top down.
    pub(crate) fn new(
        string: &Drillstring,
        conditions: &Conditions,
        contacts: &[Contact],
    ) -> Result<Self, StaticsError> {
        let places: Vec<f64> = contacts.iter().map(|it| it.distance_from_bit).collect();
        let top = conditions.top.distance(&places, string.length());
        let tubes = tubes(string, top);
        let distances = nodes(string, &tubes, conditions, contacts, top)?;
        let node_of = |contact: &Contact| {
            let after = distances.partition_point(|it| *it > contact.distance_from_bit);
            // Equal up to the bit's rounding.
            after.min(distances.len() - 1)
        };
        let contact_nodes = contacts.iter().map(node_of).collect();
        let heavier = string.material().density - conditions.mud.map_or(0.0, |mud| mud.density);
        let length = string.length();
        let mut axes = conditions.course.at_bit(length);
        let mut tension = 0.0;
        let mut elements = Vec::with_capacity(distances.len());
        let mut high_side = vec![axes.high_side_angle()];
        for pair in distances.windows(2).rev() {
            let middle = 0.5 * (pair[0] + pair[1]);
            let (_, tube) = tubes[tubes
                .partition_point(|(end, _)| *end < middle)
                .min(tubes.len() - 1)];
            let curvature = conditions.course.curvature(length - middle);
            let weight = heavier * tube.area() * GRAVITY;
            let element = Element::new(
                (&axes, curvature),
                tube,
                (pair[0] - pair[1], tension),
                (weight, conditions.youngs_modulus),
            );
            axes = axes.moved(curvature, -element.length);
            tension = element.tension[0];
            high_side.push(axes.high_side_angle());
            elements.push(element);
        }
        elements.reverse();
        high_side.reverse();
        let hole_is_plane = elements.iter().all(Element::is_in_plane);
        if hole_is_plane {
            // Rounding would choose the side to which a string snakes.
            for element in &mut elements {
                element.curvature[1] = 0.0;
                element.load.iter_mut().for_each(|it| it[1] = 0.0);
            }
        }
        let is_cut = length - top > SHORTEST_ELEMENT;
        let held_above: &[usize] = match conditions.surface {
            SurfaceSupport::Free if !is_cut => &[],
            SurfaceSupport::Clamped if !is_cut => &[0, 1, 2, 3],
            _ => &[0, 2],
        };
        let highest = contacts.first().map_or(0.0, |it| it.clearance);
        let rests_above = is_cut && matches!(conditions.top, Top::AboveContacts | Top::OnWall(_));
        Ok(Self {
            elements,
            held_above,
            aside_above: if rests_above { highest } else { 0.0 },
            distances,
            contact_nodes,
            high_side,
            hole_is_plane,
        })
    }

    /// How many unknowns there are.
    pub(crate) fn size(&self) -> usize {
        FREEDOMS * self.distances.len()
    }
}

impl Element {
    /// Above a place with these axes, where the hole has a curvature, of a length (m) under a
    /// tension below (N), with a buoyed weight (N/m) and a Young's modulus (Pa).
    fn new(
        (below, curvature): (&Axes, [f64; 3]),
        tube: Tube,
        (length, tension): (f64, f64),
        (weight, youngs_modulus): (f64, f64),
    ) -> Self {
        let at = |part: f64| below.moved(curvature, (part - 1.0) * length);
        let hanging: f64 = GAUSS
            .iter()
            .map(|(part, share)| share * weight * at(*part).along[2] * length)
            .sum();
        let tension = [tension + hanging, tension];
        let bend = below.bend(curvature);
        let load = GAUSS.map(|(part, _)| {
            let pulled = tension[0] + part * (tension[1] - tension[0]);
            let axes = at(part);
            [0, 1]
                .map(|axis| weight * dot(axes.across[axis], [0.0, 0.0, 1.0]) + pulled * bend[axis])
        });
        Self {
            tube,
            length,
            rigidity: youngs_modulus * tube.second_moment(),
            tension,
            curvature: bend,
            load,
        }
    }
}

/// The tubes from the bit up to a distance from it (m), with where each ends.
fn tubes(string: &Drillstring, top: f64) -> Vec<(f64, Tube)> {
    let mut end = 0.0;
    let cells = (string.sections().iter().rev())
        .flat_map(|section| (0..section.repeat).flat_map(|_| section.parts.iter().rev()));
    let mut tubes = Vec::new();
    for tube in cells {
        if end >= top {
            break;
        }
        end += tube.length;
        tubes.push((end, *tube));
    }
    tubes
}

/// Distances of nodes from the bit, m, from the top down: at contacts, at changes of tube, where
/// arcs end, and as many in between as elements need.
fn nodes(
    string: &Drillstring,
    tubes: &[(f64, Tube)],
    conditions: &Conditions,
    contacts: &[Contact],
    top: f64,
) -> Result<Vec<f64>, StaticsError> {
    // Ends and contacts stay where they are.
    let mut places = vec![0.0];
    places.extend(contacts.iter().rev().map(|it| it.distance_from_bit));
    places.push(top);
    // The bit may be a contact.
    places.dedup_by(|next, before| *next == 0.0 && *before == 0.0);
    if let Some(pair) = places
        .windows(2)
        .find(|pair| pair[1] - pair[0] < SHORTEST_ELEMENT)
    {
        let (distance, least) = (pair[0], SHORTEST_ELEMENT);
        return Err(StaticsError::TooClose { distance, least });
    }
    let length = string.length();
    let arcs = conditions.course.ends_of_arcs().map(|depth| length - depth);
    let others = tubes.iter().map(|(end, _)| *end).chain(arcs);
    let mut within: Vec<f64> = others.filter(|it| *it > 0.0 && *it < top).collect();
    within.sort_by(f64::total_cmp);
    for place in within {
        let after = places.partition_point(|it| *it < place);
        let is_far = |other: &f64| (other - place).abs() >= SHORTEST_ELEMENT;
        if places[after.saturating_sub(1)..(after + 1).min(places.len())]
            .iter()
            .all(is_far)
        {
            places.insert(after, place);
        }
    }
    let longest = conditions.longest_element.unwrap_or(LONGEST_ELEMENT);
    let mut distances = vec![0.0];
    for pair in places.windows(2) {
        let length = pair[1] - pair[0];
        let count = (length / longest - 1e-6).ceil().max(1.0);
        let inner = (1..count as usize).map(|it| pair[0] + it as f64 * length / count);
        distances.extend(inner);
        distances.push(pair[1]);
    }
    distances.reverse();
    Ok(distances)
}
