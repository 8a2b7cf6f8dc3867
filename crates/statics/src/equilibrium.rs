//! Equilibrium of a beam in contact, by Newton's method.
//!
//! At a contact with the string at u = r (cos α, sin α), e_r and e_θ its directions outwards and
//! sideways, the wall answers with
//!
//! ```text
//! F = N (−e_r + m e_θ)         N = k_c (r − c)^1.5, or r = c and N ≥ 0 where it is rigid
//! ```
//!
//! where m is 0 at rest, and −μ where the string slides on it, turning clockwise looking down.
//!
//! *A rigid wall* that is touched holds r = c; sideways the string is free, with the stiffness
//! N/c by which a force towards the middle turns as it moves. Which contacts touch is found by
//! turns: all that pull, and all that are beyond their wall, are changed together (block principal
//! pivoting: J. J. Júdice and F. M. Pires, "A block principal pivoting algorithm for large-scale
//! strictly monotone linear complementarity problems", *Computers & Operations Research* 21, 1994,
//! 587–596), and where their number does not fall three times, the last alone (K. G. Murty, "Note on a
//! Bard-type scheme for solving the complementarity problem", *Opsearch* 11, 1974, 123–130). Every turn is
//! one elimination of a band, for in this way a string that buckles without its contacts is as easy as
//! another.
//!
//! *A Hertzian wall* is begun from the rigid one: `soft_walls.rs`.

mod soft_walls;

use crate::banded::Banded;
use crate::beam::{Beam, FREEDOMS};
use crate::contact::Contact;
use crate::wall::{hertzian, turned};

/// Turns until equilibrium is given up: with soft walls, and with rigid ones alone, where soft walls
/// are still to be tried.
const MOST_TURNS: usize = 300;
const MOST_RIGID_TURNS: usize = 50;

/// How often the number of contacts that change may not fall, until they change one by one.
const PATIENCE: usize = 3;

/// A step below this part of the largest displacement may be rounding.
const SAME_PLACE: f64 = 1e-9;

/// A step below this part of the largest displacement is taken as it is.
const SMALL_STEP: f64 = 1e-5;

/// A step is halved no more often than this.
const MOST_HALVINGS: i32 = 12;

/// No turn moves a string along a rigid wall by more than this part of its clearance.
const LONGEST_SLIDE: f64 = 0.5;

/// A pull below this part of the largest force of a wall is rounding, and so is what is out of
/// balance below this part of the load.
const SAME_FORCE: f64 = 1e-9;

/// What a contact does.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Touch {
    /// The string is held there by what is not a wall, in the middle.
    Held,
    /// It does not touch a rigid wall.
    Off,
    /// It touches a rigid wall in a direction outwards, with a force N in N.
    On { outwards: [f64; 2], normal: f64 },
    /// The wall answers by its stiffness, N/m^1.5.
    Hertzian(f64),
}

/// A beam with its contacts under a weight on bit and friction.
#[derive(Debug, Clone)]
pub(crate) struct Equilibrium<'a> {
    beam: &'a Beam,
    contacts: &'a [Contact],
    pub(crate) weight_on_bit: f64,
    /// Coefficient of friction at each contact; positive where it slides as a string does that turns
    /// clockwise.
    pub(crate) frictions: Vec<f64>,
    /// Displacement and slope along the first axis, then along the second, of each node.
    pub(crate) moved: Vec<f64>,
    touches: Vec<Touch>,
}

/// Which pivots of the last elimination are negative, counted in each plane.
pub(crate) type NegativePivots = [usize; 2];

impl<'a> Equilibrium<'a> {
    /// Lying on all its contacts, to where loads press it.
    pub(crate) fn on_all_contacts(
        beam: &'a Beam,
        contacts: &'a [Contact],
        bit_is_pinned: bool,
        weight_on_bit: f64,
    ) -> Self {
        let mut lying = Self {
            beam,
            contacts,
            weight_on_bit,
            frictions: vec![0.0; contacts.len()],
            moved: vec![0.0; beam.size()],
            touches: vec![Touch::Off; contacts.len()],
        };
        let loads = lying.shared_loads();
        for contact in 0..contacts.len() {
            let is_pinned = bit_is_pinned && lying.first(contact) + FREEDOMS == beam.size();
            let normal = loads[contact][0].hypot(loads[contact][1]);
            lying.touches[contact] = match normal {
                _ if is_pinned => Touch::Held,
                // A string that nothing presses aside is in the middle.
                0.0 => Touch::Off,
                _ => Touch::On {
                    outwards: loads[contact].map(|load| load / normal),
                    normal,
                },
            };
            lying.put_on_wall(contact);
        }
        lying
    }

    /// The load of each contact, as far as the middles between it and its neighbours, N.
    fn shared_loads(&self) -> Vec<[f64; 2]> {
        let mut loads = vec![[0.0; 2]; self.contacts.len()];
        let nodes = &self.beam.contact_nodes;
        for (upper, element) in self.beam.elements.iter().enumerate() {
            let middle = 0.5 * (self.beam.distances[upper] + self.beam.distances[upper + 1]);
            let after = nodes.partition_point(|node| *node <= upper);
            let distance = |contact: usize| (self.beam.distances[nodes[contact]] - middle).abs();
            let near = [after.checked_sub(1), Some(after)].into_iter().flatten();
            let near = near.filter(|contact| *contact < nodes.len());
            let Some(nearest) = near.min_by(|a, b| distance(*a).total_cmp(&distance(*b))) else {
                continue;
            };
            for plane in 0..2 {
                let [upper, _, lower, _] = element.nodal_loads(plane, self.weight_on_bit);
                loads[nearest][plane] += upper + lower;
            }
        }
        loads
    }

    /// The first unknown of the node of a contact.
    fn first(&self, contact: usize) -> usize {
        FREEDOMS * self.beam.contact_nodes[contact]
    }

    /// Where the string is at a contact, m.
    pub(crate) fn place(&self, contact: usize) -> [f64; 2] {
        let first = self.first(contact);
        [self.moved[first], self.moved[first + 2]]
    }

    fn set_place(&mut self, contact: usize, place: [f64; 2]) {
        let first = self.first(contact);
        [self.moved[first], self.moved[first + 2]] = place;
    }

    fn put_on_wall(&mut self, contact: usize) {
        if let Touch::On { outwards, .. } = self.touches[contact] {
            let clearance = self.contacts[contact].clearance;
            self.set_place(contact, outwards.map(|it| clearance * it));
        }
    }

    /// Forces that keep the beam where it is, without those of Hertzian walls: at each unknown.
    fn keeping(&self) -> Vec<f64> {
        let mut forces = vec![0.0; self.beam.size()];
        for (upper, element) in self.beam.elements.iter().enumerate() {
            let stiffness = element.stiffness(self.weight_on_bit);
            for plane in 0..2 {
                let loads = element.nodal_loads(plane, self.weight_on_bit);
                let unknown = |it: usize| FREEDOMS * (upper + it / 2) + 2 * plane + it % 2;
                for row in 0..4 {
                    let of_row = (0..4).map(|it| stiffness[row][it] * self.moved[unknown(it)]);
                    forces[unknown(row)] += of_row.sum::<f64>() - loads[row];
                }
            }
        }
        forces
    }

    /// Force of the wall on the string at each contact, N, along both axes.
    pub(crate) fn forces(&self) -> Vec<[f64; 2]> {
        let keeping = self.keeping();
        let force = |contact: usize| match self.touches[contact] {
            Touch::Off => [0.0; 2],
            Touch::Held | Touch::On { .. } => {
                let first = self.first(contact);
                [keeping[first], keeping[first + 2]]
            }
            Touch::Hertzian(stiffness) => hertzian(
                self.contacts[contact].clearance,
                stiffness,
                self.place(contact),
            )
            .force(self.slip(contact)),
        };
        (0..self.contacts.len()).map(force).collect()
    }

    /// m of the front page.
    fn slip(&self, contact: usize) -> f64 {
        -self.frictions[contact]
    }

    /// The step to where a tangent would be in equilibrium, and which of its pivots are negative.
    /// Elements are stiffer at their nodes by these parts, in each plane.
    fn step(&self, stiffened: [f64; 2]) -> (Vec<f64>, NegativePivots) {
        let size = self.beam.size();
        let mut matrix = Banded::zeros(size);
        for (upper, element) in self.beam.elements.iter().enumerate() {
            let stiffness = element.stiffness(self.weight_on_bit);
            for plane in 0..2 {
                let unknown = |it: usize| FREEDOMS * (upper + it / 2) + 2 * plane + it % 2;
                for row in 0..4 {
                    for column in 0..4 {
                        matrix.add(unknown(row), unknown(column), stiffness[row][column]);
                    }
                    let more = stiffened[plane] * stiffness[row][row];
                    matrix.add(unknown(row), unknown(row), more);
                }
            }
        }
        let mut right: Vec<f64> = self.keeping().iter().map(|it| -it).collect();
        for contact in 0..self.contacts.len() {
            let (first, slip) = (self.first(contact), self.slip(contact));
            let (one, other) = (first, first + 2);
            match self.touches[contact] {
                Touch::Off => {}
                Touch::Held => {
                    for unknown in [one, other] {
                        matrix.hold(unknown, -self.moved[unknown], &mut right);
                    }
                }
                Touch::On { outwards, normal } => {
                    matrix.turn(one, other, outwards);
                    [right[one], right[other]] = turned([right[one], right[other]], outwards);
                    matrix.add_row(slip, one, other);
                    right[other] += slip * right[one];
                    let clearance = self.contacts[contact].clearance;
                    let sideways = normal.max(0.0) * (1.0 + slip * slip) / clearance;
                    matrix.add(other, other, sideways);
                    let [x, y] = self.place(contact);
                    matrix.hold(one, clearance - x.hypot(y), &mut right);
                }
                Touch::Hertzian(stiffness) => {
                    let wall = hertzian(
                        self.contacts[contact].clearance,
                        stiffness,
                        self.place(contact),
                    );
                    let ([fx, fy], tangent) = (wall.force(slip), wall.tangent(slip));
                    right[one] += fx;
                    right[other] += fy;
                    let places = [one, other];
                    for row in 0..2 {
                        for column in 0..2 {
                            matrix.add(places[row], places[column], tangent[row][column]);
                        }
                    }
                }
            }
        }
        let upper_end = self.upper_end();
        for &unknown in self.beam.held_above {
            matrix.hold(
                unknown,
                upper_end[unknown] - self.moved[unknown],
                &mut right,
            );
        }
        let negative = matrix.solve(&mut right);
        for contact in 0..self.contacts.len() {
            if let Touch::On {
                outwards: [cos, sin],
                ..
            } = self.touches[contact]
            {
                let first = self.first(contact);
                [right[first], right[first + 2]] =
                    turned([right[first], right[first + 2]], [cos, -sin]);
            }
        }
        let in_plane = |plane: usize| {
            let pivots = negative.iter().enumerate();
            pivots
                .filter(|(it, is_negative)| **is_negative && (it % FREEDOMS) / 2 == plane)
                .count()
        };
        (right, [in_plane(0), in_plane(1)])
    }

    /// Displacement and slope of the uppermost node in both planes, where they are given: it slides as the
    /// highest contact does.
    fn upper_end(&self) -> [f64; FREEDOMS] {
        let aside = self.beam.aside_above;
        if aside == 0.0 {
            return [0.0; FREEDOMS];
        }
        let element = &self.beam.elements[0];
        let [x, y] = [0, 1].map(|plane| {
            let [upper, _, lower, _] = element.nodal_loads(plane, self.weight_on_bit);
            upper + lower
        });
        let size = x.hypot(y);
        if size == 0.0 {
            return [0.0; FREEDOMS];
        }
        let (sin, cos) = self.slip(0).atan().sin_cos();
        let [x, y] = turned([x / size, y / size], [cos, -sin]);
        [aside * x, 0.0, aside * y, 0.0]
    }

    /// Which pivots are negative where the string is now: without any, it is stable.
    pub(crate) fn negative_pivots(&self) -> NegativePivots {
        self.step([0.0; 2]).1
    }

    /// Puts the string into equilibrium with rigid walls; whether it is found. Where turns do not
    /// end, or end where the string would not stay, soft walls are made ever stiffer: what they touch
    /// in the end is what rigid ones do.
    pub(crate) fn settle_rigid(&mut self) -> bool {
        let start = self.clone();
        let is_found = self.settle(false);
        let stays = is_found && (!self.has_energy() || self.negative_pivots()[0] == 0);
        if stays {
            return true;
        }
        let found = std::mem::replace(self, start.clone());
        if self.settle_by_soft_walls() {
            return true;
        }
        // Nothing may be found on softened walls later.
        *self = if is_found { found } else { start };
        is_found
    }

    /// Puts a string that lies on rigid walls into equilibrium with those that have a stiffness;
    /// whether it is found.
    pub(crate) fn settle_hertzian(&mut self) -> bool {
        let mut has_springs = false;
        for contact in 0..self.contacts.len() {
            let Some(stiffness) = self.contacts[contact].stiffness else {
                continue;
            };
            has_springs = true;
            if !matches!(self.touches[contact], Touch::Hertzian(_)) {
                self.soften_wall(contact, stiffness);
            }
        }
        !has_springs || self.settle(true)
    }

    /// Turn by turn into equilibrium.
    fn settle(&mut self, has_springs: bool) -> bool {
        let (mut fewest, mut patience) = (usize::MAX, PATIENCE);
        let mut last_balance = f64::INFINITY;
        let mut stiffened = [0.0; 2];
        let most_turns = match has_springs {
            true => MOST_TURNS,
            false => MOST_RIGID_TURNS,
        };
        let loads = self.shared_loads().into_iter().flatten();
        let load = loads.map(f64::abs).sum::<f64>();
        for _ in 0..most_turns {
            let step = match has_springs {
                true => self.step_downhill(&mut stiffened),
                false => self.step([0.0; 2]).0,
            };
            let length = largest(&step);
            if !length.is_finite() {
                return false;
            }
            self.take(&step, has_springs);
            let changes = self.changes();
            if changes.is_empty() {
                let balance = self.out_of_balance();
                let is_rounding =
                    length <= SAME_PLACE * largest(&self.moved) && balance >= 0.5 * last_balance;
                if balance <= SAME_FORCE * load || is_rounding {
                    return true;
                }
                last_balance = balance;
                continue;
            }
            last_balance = f64::INFINITY;
            let count = changes.len();
            let together = if count < fewest {
                (fewest, patience) = (count, PATIENCE);
                true
            } else {
                patience = patience.saturating_sub(1);
                patience > 0
            };
            let changed = if together { 0 } else { count - 1 };
            for (contact, touch) in &changes[changed..] {
                self.touches[*contact] = *touch;
                self.put_on_wall(*contact);
            }
        }
        false
    }

    /// Takes a step, or, with springs, as much of it as lessens the [merit](Self::merit).
    fn take(&mut self, step: &[f64], has_springs: bool) {
        let (from, touches) = (self.moved.clone(), self.touches.clone());
        // Rounding is no reason to halve a step.
        let is_judged = has_springs && largest(step) > SMALL_STEP * largest(&from);
        let before = if is_judged { self.merit() } else { 0.0 };
        for halvings in 0..=MOST_HALVINGS {
            let part = 0.5_f64.powi(halvings);
            for ((moved, from), step) in self.moved.iter_mut().zip(&from).zip(step) {
                *moved = from + part * step;
            }
            self.touches.clone_from(&touches);
            self.update_normals();
            self.keep_on_walls(&from);
            if !is_judged || self.merit() <= before {
                return;
            }
        }
    }

    /// What slid along a rigid wall is put back on it.
    fn keep_on_walls(&mut self, from: &[f64]) {
        for contact in 0..self.contacts.len() {
            let Touch::On {
                outwards: [cos, sin],
                normal,
            } = self.touches[contact]
            else {
                continue;
            };
            let (first, clearance) = (self.first(contact), self.contacts[contact].clearance);
            let moved = [first, first + 2].map(|it| self.moved[it] - from[it]);
            let [_, aside] = turned(moved, [cos, sin]);
            let angle = if clearance > 0.0 {
                aside / clearance
            } else {
                0.0
            };
            let (turned_by, outwards) = angle.clamp(-LONGEST_SLIDE, LONGEST_SLIDE).sin_cos();
            let outwards = turned([outwards, turned_by], [cos, -sin]);
            self.touches[contact] = Touch::On { outwards, normal };
            self.put_on_wall(contact);
        }
    }

    /// Forces out of balance, where no rigid wall answers them: the root of their squares, N.
    fn out_of_balance(&self) -> f64 {
        let mut forces = self.keeping();
        for contact in 0..self.contacts.len() {
            let (first, slip) = (self.first(contact), self.slip(contact));
            let places = [first, first + 2];
            match self.touches[contact] {
                Touch::Off => {}
                Touch::Held => places.iter().for_each(|it| forces[*it] = 0.0),
                Touch::On { outwards, .. } => {
                    let [out, aside] = turned(places.map(|it| forces[it]), outwards);
                    forces[first] = 0.0;
                    forces[first + 2] = aside + slip * out;
                }
                Touch::Hertzian(stiffness) => {
                    let clearance = self.contacts[contact].clearance;
                    let wall = hertzian(clearance, stiffness, self.place(contact));
                    for (place, force) in places.into_iter().zip(wall.force(slip)) {
                        forces[place] -= force;
                    }
                }
            }
        }
        let held = self.beam.held_above.iter();
        held.for_each(|it| forces[*it] = 0.0);
        forces.iter().map(|it| it * it).sum::<f64>().sqrt()
    }

    /// Brings the forces of rigid walls up to date.
    fn update_normals(&mut self) {
        let keeping = self.keeping();
        for contact in 0..self.contacts.len() {
            let first = self.first(contact);
            if let Touch::On { outwards, normal } = &mut self.touches[contact] {
                let [out, _] = turned([keeping[first], keeping[first + 2]], *outwards);
                *normal = -out;
            }
        }
    }

    /// Which contacts with rigid walls change, and how.
    fn changes(&self) -> Vec<(usize, Touch)> {
        let normals = self.touches.iter().map(|touch| match touch {
            Touch::On { normal, .. } => normal.abs(),
            _ => 0.0,
        });
        let pull = -SAME_FORCE * normals.fold(0.0, f64::max);
        let change = |contact: usize| match self.touches[contact] {
            Touch::Held | Touch::Hertzian(_) => None,
            Touch::Off => {
                let place = self.place(contact);
                let reached = place[0].hypot(place[1]);
                let outwards = place.map(|it| it / reached);
                let is_beyond = reached > self.contacts[contact].clearance * (1.0 + SAME_PLACE);
                is_beyond.then_some(Touch::On {
                    outwards,
                    normal: 0.0,
                })
            }
            Touch::On { normal, .. } => (normal < pull).then_some(Touch::Off),
        };
        (0..self.contacts.len())
            .filter_map(|contact| Some((contact, change(contact)?)))
            .collect()
    }

    /// Whether a contact touches.
    pub(crate) fn touches(&self, contact: usize) -> bool {
        match self.touches[contact] {
            Touch::Held | Touch::On { .. } => true,
            Touch::Off => false,
            Touch::Hertzian(_) => {
                let [x, y] = self.place(contact);
                x.hypot(y) > self.contacts[contact].clearance
            }
        }
    }

    /// All contacts let go.
    pub(crate) fn let_go(&mut self) {
        for touch in &mut self.touches {
            if *touch != Touch::Held {
                *touch = Touch::Off;
            }
        }
    }

    /// All contacts held where they are.
    pub(crate) fn hold_all(&mut self) {
        self.touches.fill(Touch::Held);
    }
}

/// The largest amount among displacements; infinite where one is not finite.
fn largest(moved: &[f64]) -> f64 {
    match moved.iter().all(|it| it.is_finite()) {
        true => moved
            .iter()
            .step_by(2)
            .fold(0.0, |most, it| most.max(it.abs())),
        false => f64::INFINITY,
    }
}
