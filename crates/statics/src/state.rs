//! What a string that lies in its hole does along its length: where it is, what it lies on, and
//! how it is bent and stressed.
//!
//! The moment between nodes comes from what keeps their elements in equilibrium and not from the
//! curvature of the shape functions, which is off by a square of the length of elements.

use std::f64::consts::{PI, TAU};

use linear::Stress;

use crate::beam::{Beam, Element, shapes, slopes};
use crate::contact::Contact;
use crate::equilibrium::Equilibrium;

/// Parts of an element at whose ends the greatest of what varies along it is looked for.
const PARTS: usize = 8;

/// How often the distance to the greatest is cut by 0.6.
const CUTS: usize = 30;

/// A contact of a string at rest, or in steady motion. Vectors are along h, to the high side at
/// the bit, and r, to the right there looking down, carried along the hole without twist.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactState {
    /// The contact.
    pub contact: Contact,
    /// Where the string is, from the middle of its hole, m.
    pub displacement: [f64; 2],
    /// Force of the wall on the string, N.
    pub force: [f64; 2],
    /// Whether it touches.
    pub touches: bool,
    /// By which the high side there is turned from the first axis towards the second, rad.
    pub high_side: f64,
}

/// A place along the string; vectors are along the axes of [`ContactState`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Distance from the bit, m.
    pub distance_from_bit: f64,
    /// From the middle of the hole, m.
    pub displacement: [f64; 2],
    /// Slope to the axis of the hole, downwards, rad.
    pub slope: [f64; 2],
    /// Bending moment, that of the bent hole included, N m; positive where the string is bent
    /// towards the axis.
    pub moment: [f64; 2],
    /// Effective tension, N.
    pub tension: f64,
    /// Stress.
    pub stress: Stress,
    /// By which the high side there is turned from the first axis towards the second, rad.
    pub high_side: f64,
}

impl Place {
    /// A vector of this place along its own high side, and to the right of that looking down.
    pub fn by_high_side(&self, vector: [f64; 2]) -> [f64; 2] {
        by_high_side(self.high_side, vector)
    }
}

/// A vector along axes that are turned by an angle, rad.
fn by_high_side(angle: f64, [x, y]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * x + sin * y, cos * y - sin * x]
}

/// A string in equilibrium with its hole.
///
/// ```
/// use linear::{Drillstring, Material, Section, Tube};
/// use statics::{Conditions, Contact, Course, LyingString};
///
/// let steel = Material { shear_modulus: 80e9, density: 7850.0 };
/// let collar = Tube { length: 9.0, inner_radius: 0.0357, outer_radius: 0.1016 };
/// let collars = Section { repeat: 20, parts: vec![collar] };
/// let string = Drillstring::new(steel, vec![collars], 0.0)?;
/// let at = |distance_from_bit: f64| Contact {
///     distance_from_bit,
///     clearance: 0.03,
///     radius: 0.1016,
///     stiffness: None,
/// };
/// let contacts: Vec<Contact> = (0..20).map(|it| at(9.0 * f64::from(it))).collect();
/// let flat = Course::Straight { inclination: std::f64::consts::FRAC_PI_2 };
/// let state = LyingString::new(&string, &Conditions::new(206e9, flat), &contacts)?.at_rest()?;
/// // In the middle each of equal spans bears its weight.
/// let weight = 7850.0 * collar.area() * linear::well::GRAVITY * 9.0;
/// assert!((state.contacts()[10].normal() / weight - 1.0).abs() < 0.01);
/// let (place, moment) = state.greatest_moment(60.0);
/// assert!(moment > weight * 9.0 / 12.0 && place <= 60.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct StaticState {
    contacts: Vec<ContactState>,
    beam: Beam,
    /// Of each element.
    moved: Vec<Bent>,
    weight_on_bit: f64,
    torque: f64,
    frictions: Vec<f64>,
    negative_pivots: [usize; 2],
}

/// An element in equilibrium, in both planes.
#[derive(Debug, Clone)]
struct Bent {
    /// Displacement and slope of the upper node, then of the lower.
    ends: [[f64; 4]; 2],
    /// Moment and how it grows downwards, at the upper end, then at the lower.
    moment: [[f64; 4]; 2],
}

impl ContactState {
    /// What the wall presses with, N.
    pub fn normal(&self) -> f64 {
        let [x, y] = self.displacement;
        let reached = x.hypot(y);
        match reached {
            // Held in the middle.
            0.0 => self.force[0].hypot(self.force[1]),
            // Without the sign of a zero.
            _ => 0.0 - (self.force[0] * x + self.force[1] * y) / reached,
        }
    }

    /// A vector of this contact along its own high side, and to the right of that looking down.
    pub fn by_high_side(&self, vector: [f64; 2]) -> [f64; 2] {
        by_high_side(self.high_side, vector)
    }

    /// How far up the hole it is, from its low side there to where a string climbs that turns
    /// clockwise looking down, rad; to the other side negative.
    pub fn climb(&self) -> f64 {
        let [high, right] = self.by_high_side(self.displacement);
        right.atan2(-high)
    }
}

impl StaticState {
    pub(crate) fn new(lying: &Equilibrium, beam: &Beam, contacts: &[Contact], torque: f64) -> Self {
        let forces = lying.forces();
        let state = |index: usize| ContactState {
            contact: contacts[index],
            displacement: lying.place(index),
            force: forces[index],
            touches: lying.touches(index),
            high_side: beam.high_side[beam.contact_nodes[index]],
        };
        let bent = beam.elements.iter().enumerate().map(|(upper, element)| {
            let first = 4 * upper;
            let ends = [0, 1]
                .map(|plane| [0, 1, 4, 5].map(|it: usize| lying.moved[first + 2 * plane + it]));
            Bent::new(element, ends, lying.weight_on_bit)
        });
        Self {
            contacts: (0..contacts.len()).map(state).collect(),
            moved: bent.collect(),
            beam: beam.clone(),
            weight_on_bit: lying.weight_on_bit,
            torque,
            frictions: lying.frictions.clone(),
            negative_pivots: lying.negative_pivots(),
        }
    }

    /// Its contacts, from the surface down.
    pub fn contacts(&self) -> &[ContactState] {
        &self.contacts
    }

    /// Where the string is at each contact, from the surface down, m.
    pub fn displacements(&self) -> Vec<[f64; 2]> {
        self.contacts.iter().map(|it| it.displacement).collect()
    }

    /// Forces of the walls on the string, from the surface down, N.
    pub fn forces(&self) -> Vec<[f64; 2]> {
        self.contacts.iter().map(|it| it.force).collect()
    }

    /// Whether it stays where it is if it is pushed a little. Exact at rest; in sliding rotation
    /// no answer is known.
    pub fn is_stable(&self) -> bool {
        let slides = self.frictions.iter().any(|friction| *friction != 0.0);
        !slides && self.negative_pivots == [0, 0]
    }

    /// In how many ways it would leave where it is at rest: in the plane of h, and across it. In a
    /// hole that turns sideways only their sum has a meaning.
    pub fn unstable_directions(&self) -> [usize; 2] {
        self.negative_pivots
    }

    /// The torque with which friction at its contacts holds it back, N m.
    pub fn friction_torque(&self) -> f64 {
        let contacts = self.contacts.iter().zip(&self.frictions);
        contacts
            .map(|(it, friction)| friction * it.normal() * it.contact.radius)
            .sum()
    }

    /// Force of the bit on the rock sideways, N: what holds it, the other way round.
    pub fn side_force_at_bit(&self) -> [f64; 2] {
        let at_bit = self.contacts.last();
        let at_bit = at_bit.filter(|it| it.contact.distance_from_bit == 0.0);
        at_bit.map_or([0.0; 2], |it| it.force.map(|force| -force))
    }

    /// Angle of the bit to the axis of the hole, downwards, rad.
    pub fn tilt_of_bit(&self) -> [f64; 2] {
        self.at(0.0).slope
    }

    /// Distance from the bit, m, up to which the string is modelled.
    pub fn top(&self) -> f64 {
        self.beam.distances[0]
    }

    /// The string at a distance from the bit (m), up to [`StaticState::top`]; at a change of
    /// tube, the lower tube.
    pub fn at(&self, distance_from_bit: f64) -> Place {
        let distances = &self.beam.distances;
        let after = distances.partition_point(|it| *it > distance_from_bit);
        let upper = match distances.get(after) {
            Some(it) if *it == distance_from_bit => after,
            _ => after.saturating_sub(1),
        };
        let upper = upper.min(self.beam.elements.len() - 1);
        let part = (distances[upper] - distance_from_bit) / self.beam.elements[upper].length;
        self.within(upper, part.clamp(0.0, 1.0))
    }

    /// The string at the ends of all elements, from the top down: at a change of tube twice.
    pub fn along(&self) -> impl Iterator<Item = Place> {
        let elements = 0..self.beam.elements.len();
        elements.flat_map(|upper| [0.0, 1.0].map(|part| self.within(upper, part)))
    }

    /// Where the string is bent most, up to a distance from the bit (m), and its moment, N m.
    pub fn greatest_moment(&self, to: f64) -> (f64, f64) {
        self.greatest(to, |place| place.moment[0].hypot(place.moment[1]))
    }

    /// Where stress of bending is greatest, up to a distance from the bit (m), and that, Pa.
    pub fn greatest_bending_stress(&self, to: f64) -> (f64, f64) {
        self.greatest(to, |place| place.stress.bending)
    }

    /// Where von Mises stress is greatest, up to a distance from the bit (m), and that, Pa.
    pub fn greatest_von_mises(&self, to: f64) -> (f64, f64) {
        self.greatest(to, |place| place.stress.von_mises)
    }

    /// Where a value is greatest up to a distance from the bit (m), and that.
    fn greatest(&self, to: f64, value: impl Fn(&Place) -> f64) -> (f64, f64) {
        let (mut best, mut at) = (f64::NEG_INFINITY, (0, 0.0));
        for (upper, lower) in self.beam.distances[1..].iter().enumerate() {
            if *lower >= to {
                continue;
            }
            for count in 0..=PARTS {
                let part = count as f64 / PARTS as f64;
                let place = self.within(upper, part);
                if place.distance_from_bit <= to && value(&place) > best {
                    (best, at) = (value(&place), (upper, part));
                }
            }
        }
        let (upper, part) = at;
        let step = 1.0 / PARTS as f64;
        // An end of an element is that of its neighbour, too.
        let mut around = vec![(upper, (part - step).max(0.0), (part + step).min(1.0))];
        if part == 0.0 && upper > 0 {
            around.push((upper - 1, 1.0 - step, 1.0));
        }
        if part == 1.0 && upper + 1 < self.beam.elements.len() {
            around.push((upper + 1, 0.0, step));
        }
        let mut found = (self.within(upper, part).distance_from_bit, best);
        for (upper, low, high) in around {
            let inner = self.peak(upper, (low, high), &value);
            if inner.distance_from_bit <= to && value(&inner) > found.1 {
                found = (inner.distance_from_bit, value(&inner));
            }
        }
        found
    }

    /// Where a value has a peak between two parts of an element, by golden sections.
    fn peak(
        &self,
        upper: usize,
        (mut low, mut high): (f64, f64),
        value: &impl Fn(&Place) -> f64,
    ) -> Place {
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let of = |part: f64| value(&self.within(upper, part));
        for _ in 0..CUTS {
            let (one, other) = (high - golden * (high - low), low + golden * (high - low));
            if of(one) > of(other) {
                high = other;
            } else {
                low = one;
            }
        }
        self.within(upper, 0.5 * (low + high))
    }

    /// At a part of an element, from its upper node.
    fn within(&self, upper: usize, part: f64) -> Place {
        let element = &self.beam.elements[upper];
        let bent = &self.moved[upper];
        let length = element.length;
        let sum = |values: &[f64; 4], weights: [f64; 4]| -> f64 {
            values
                .iter()
                .zip(weights)
                .map(|(value, weight)| value * weight)
                .sum()
        };
        let of_planes = |values: &[[f64; 4]; 2], weights: [f64; 4]| {
            [sum(&values[0], weights), sum(&values[1], weights)]
        };
        let moment = of_planes(&bent.moment, shapes(part, length));
        let [above, below] = element.tension(self.weight_on_bit);
        let tension = above + part * (below - above);
        let amount = moment[0].hypot(moment[1]);
        Place {
            distance_from_bit: self.beam.distances[upper] - part * length,
            displacement: of_planes(&bent.ends, shapes(part, length)),
            slope: of_planes(&bent.ends, slopes(part, length)),
            moment,
            tension,
            stress: Stress::new(&element.tube, tension, amount, self.torque),
            high_side: between(
                self.beam.high_side[upper],
                self.beam.high_side[upper + 1],
                part,
            ),
        }
    }
}

/// An angle a part of the way from one to another, on the shorter way.
fn between(one: f64, other: f64, part: f64) -> f64 {
    let apart = (other - one + PI).rem_euclid(TAU) - PI;
    one + part * apart
}

impl Bent {
    /// From M and M′ at both ends: with the forces that keep an element in place, a couple is the
    /// moment, and a force what it grows by less T u′.
    fn new(element: &Element, ends: [[f64; 4]; 2], weight_on_bit: f64) -> Self {
        let stiffness = element.stiffness(weight_on_bit);
        let [above, below] = element.tension(weight_on_bit);
        let moment = [0, 1].map(|plane: usize| {
            let loads = element.nodal_loads(plane, weight_on_bit);
            let keeping: [f64; 4] = std::array::from_fn(|row| {
                let of_row = (0..4).map(|it| stiffness[row][it] * ends[plane][it]);
                of_row.sum::<f64>() - loads[row]
            });
            [
                -keeping[1],
                keeping[0] + above * ends[plane][1],
                keeping[3],
                below * ends[plane][3] - keeping[2],
            ]
        });
        Self { ends, moment }
    }
}
