//! Sites that slide along their walls in steady backward whirl: the balance of their forces, and
//! its solution.
//!
//! At a rate ω the sites of a set touch, at radii ρ and phases φ. With K the dynamic stiffness of
//! that set and r = ρ e^(iφ), the force e^(−iφ_j) (Kr)_j that a site of the string needs is −N_j
//! along its radius and μN_j along its path; the wall yields by N_j = k_c (ρ_j − c_j)^(3/2), and the
//! site slides slower than it would roll, ωρ_j ≤ ΩR_j. One phase is arbitrary, so that with μ there
//! are as many unknowns as equations. Newton's method solves them.

use linear::Complex64;
use numerics::{Mat, equations};

use super::MOST_FRICTION;
use super::newton::root;
use crate::laws::wall::Wall;

/// At first a wall pushes with this part at least of the force of its size.
const LEAST_FORCE: f64 = 0.01;

/// Limits are kept to this part of them.
const ROUNDING: f64 = 1e-8;

/// The string at a rate.
pub(super) struct Rate<'a> {
    pub walls: &'a [Wall],
    pub surface_speed: f64,
    pub rate: f64,
    pub receptance: Vec<Complex64>,
}

impl Rate<'_> {
    fn receptance(&self, to: usize, from: usize) -> Complex64 {
        self.receptance[to * self.walls.len() + from]
    }

    /// The radius at which a site would roll.
    fn rolling_radius(&self, site: usize) -> f64 {
        self.surface_speed * self.walls[site].radius / self.rate
    }
}

/// A whirl, or a guess at one.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub rate: f64,
    pub friction: f64,
    /// Cube roots of the normal forces in parts of their sizes.
    roots: Vec<f64>,
    pub phases: Vec<f64>,
    /// What follows from the roots.
    pub touching: Vec<Touching>,
}

/// What a wall does at a site.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touching {
    pub normal_force: f64,
    pub radius: f64,
}

/// The sites that touch at a rate.
pub(super) struct Contacts<'a> {
    here: &'a Rate<'a>,
    set: &'a [usize],
    stiffness: Mat<Complex64>,
    /// The force with which the string resists at each clearance, N.
    sizes: Vec<f64>,
}

impl<'a> Contacts<'a> {
    /// None where a site would turn faster at its clearance than it rolls.
    pub fn new(here: &'a Rate<'a>, set: &'a [usize]) -> Option<Self> {
        let slides = |site: &usize| here.rolling_radius(*site) >= here.walls[*site].clearance;
        if !set.iter().all(slides) {
            return None;
        }
        let count = set.len();
        let receptance = Mat::from_fn(count, count, |to, from| here.receptance(set[to], set[from]));
        let unit = Mat::<Complex64>::identity(count, count);
        let stiffness = equations::solve_complex(&receptance, &unit);
        let size =
            |index: usize| stiffness[(index, index)].norm() * here.walls[set[index]].clearance;
        Some(Self {
            here,
            set,
            sizes: (0..count).map(size).collect(),
            stiffness,
        })
    }

    /// The sites at their clearances, in phase and opposite.
    pub fn starts(&self) -> impl Iterator<Item = State> {
        let count = self.set.len();
        (0..1_usize << (count - 1)).map(move |opposite| {
            // The first is in phase with itself.
            let phase = |index: usize| f64::from((opposite << 1 >> index & 1) as u8);
            let mut start = State {
                rate: self.here.rate,
                friction: 1.0,
                roots: vec![0.0; count],
                phases: (0..count)
                    .map(|index| phase(index) * std::f64::consts::PI)
                    .collect(),
                touching: Vec::new(),
            };
            start.touching = self.touching(&start);
            let needed = self.needed(&start);
            let whole: Complex64 = needed.iter().sum();
            if whole.re < 0.0 {
                start.friction = (-whole.im / whole.re).min(MOST_FRICTION);
            }
            let parts = needed.iter().zip(&self.sizes);
            start.roots = parts
                .map(|(force, size)| libm::cbrt((-force.re / size).max(LEAST_FORCE)))
                .collect();
            start
        })
    }

    fn touching(&self, state: &State) -> Vec<Touching> {
        let touching = |index: usize| {
            let (wall, root) = (&self.here.walls[self.set[index]], state.roots[index]);
            let depth = (self.sizes[index] / wall.stiffness).powf(2.0 / 3.0) * root.powi(2);
            Touching {
                normal_force: self.sizes[index] * root.powi(3),
                radius: wall.clearance + depth,
            }
        };
        (0..self.set.len()).map(touching).collect()
    }

    /// The forces that the string needs, along the radius and along the path.
    fn needed(&self, state: &State) -> Vec<Complex64> {
        let sites = state.touching.iter().zip(&state.phases);
        let displacements: Vec<Complex64> = sites
            .map(|(site, phase)| Complex64::from_polar(site.radius, *phase))
            .collect();
        let force = |row: usize| -> Complex64 {
            let parts = displacements.iter().enumerate();
            let whole: Complex64 = parts.map(|(it, r)| self.stiffness[(row, it)] * r).sum();
            whole * Complex64::cis(-state.phases[row])
        };
        (0..self.set.len()).map(force).collect()
    }

    /// What the walls leave of the forces that the string needs, in parts of their sizes: along
    /// the radius and along the path of each site.
    fn left(&self, mut state: State) -> Vec<f64> {
        state.touching = self.touching(&state);
        let needed = self.needed(&state).into_iter().enumerate();
        needed
            .flat_map(|(index, needed)| {
                let normal_force = state.touching[index].normal_force;
                let left = needed + normal_force * Complex64::new(1.0, -state.friction);
                [left.re, left.im].map(|part| part / self.sizes[index])
            })
            .collect()
    }

    /// The whirl to which Newton's method converges from a start, if any.
    pub fn solved(&self, start: State) -> Option<State> {
        let mut state = State {
            rate: self.here.rate,
            ..start
        };
        let place = unknowns(&mut state).map(|unknown| *unknown).collect();
        let at = |place: &[f64]| {
            let mut state = state.clone();
            (unknowns(&mut state).zip(place)).for_each(|(unknown, value)| *unknown = *value);
            state
        };
        let found = root(place, |place| self.left(at(place)))?;
        let mut state = at(&found);
        state.touching = self.touching(&state);
        self.is_whirl(&state).then_some(state)
    }

    /// Whether what balances is a whirl: all of the set press, and slide no faster than they would
    /// roll, and the others are clear.
    fn is_whirl(&self, state: &State) -> bool {
        let within = |value: f64, limit: f64| value <= limit * (1.0 + ROUNDING);
        let slides = |(index, site): (usize, &usize)| {
            let Touching {
                normal_force,
                radius,
            } = state.touching[index];
            normal_force > 0.0 && within(radius, self.here.rolling_radius(*site))
        };
        let is_clear = |site: usize| {
            let by = |(index, from): (usize, &usize)| {
                let normal_force = state.touching[index].normal_force;
                let force = normal_force * Complex64::new(-1.0, state.friction);
                self.here.receptance(site, *from) * force * Complex64::cis(state.phases[index])
            };
            let displacement: Complex64 = self.set.iter().enumerate().map(by).sum();
            within(displacement.norm(), self.here.walls[site].clearance)
        };
        let mut others = (0..self.here.walls.len()).filter(|site| !self.set.contains(site));
        state.friction > 0.0 && self.set.iter().enumerate().all(slides) && others.all(is_clear)
    }
}

/// The phases but the first, the roots, and the friction.
fn unknowns(state: &mut State) -> impl Iterator<Item = &mut f64> {
    let phases = state.phases.iter_mut().skip(1);
    phases.chain(&mut state.roots).chain([&mut state.friction])
}
