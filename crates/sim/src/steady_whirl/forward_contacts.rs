//! Steady forward whirl of a string that an eccentric mass presses against several walls at once.
//!
//! In the frame that turns with the mass its force F is real, and the sites j of a set touch at
//! r_j = ρ_j e^(iφ_j), where the wall yields by N_j = k_c (ρ_j − c_j)^(3/2) and friction holds back
//! what slides, so that
//!
//! r = H_m F − Σ H_j (1 + iμ_j) N_j e^(iφ_j) and F = m_e Ω² d, or in the form of the paper
//! m_e Ω² (d + |r_m|).
//!
//! These are as many equations as unknowns N_j, φ_j and F. The set grows from one site by that which
//! is farthest beyond its clearance: its wall is brought in from where the string is, in steps from
//! which Newton's method finds the next balance. A site whose wall would have to pull leaves. What is
//! found is checked; what is not found may be there all the same, and whether it is stable is another
//! matter.

use linear::Complex64;

use super::forward::{EccentricString, Sample};
use super::newton::root;

/// A wall that is brought in pushes at first with this part of the force of the mass.
const LEAST_FORCE: f64 = 1e-3;

/// The shortest step of a wall that is brought in, in parts of its way.
const SHORTEST: f64 = 1e-3;

/// Limits are kept to this part of them.
const ROUNDING: f64 = 1e-8;

/// Steady forward whirl in contact at one site or several, all of which slide.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ForwardContacts {
    /// Radius at which each site goes round, m.
    pub radii: Vec<f64>,
    /// Its phase ahead of the mass, rad.
    pub phases: Vec<f64>,
    /// Normal force at each, N; 0 where it is clear of its wall.
    pub normal_forces: Vec<f64>,
}

impl<H: Fn(f64) -> Vec<Complex64>> EccentricString<H> {
    /// Forward whirl at a surface speed (rad/s) in contact at one site or several, sliding, all
    /// others clear of their walls; none where no site reaches its wall, or none is found.
    pub fn in_contact(&self, surface_speed: f64) -> Option<ForwardContacts> {
        let here = self.sample(surface_speed);
        let reach =
            |site: &usize| here.between(*site, self.mass.site).norm() / self.walls[*site].clearance;
        let sites = 0..self.walls.len();
        let first = sites.max_by(|one, other| reach(one).total_cmp(&reach(other)))?;
        let alone = self.in_contact_at(first, surface_speed)?;
        let (force, _) = self.forces(&here, first, alone.normal_force);
        let balance = Balance {
            string: self,
            here: &here,
            size: self.mass_force(&here, 0.0),
        };
        let mut state = State {
            force: force.norm() / balance.size,
            touching: vec![Touching {
                site: first,
                root: libm::cbrt(alone.normal_force / balance.size),
                phase: -force.arg(),
                clearance: self.walls[first].clearance,
            }],
        };
        // Each site comes, and may leave.
        for _ in 0..2 * self.walls.len() {
            if state.touching.iter().any(|it| it.root <= 0.0) {
                state.touching.retain(|it| it.root > 0.0);
                state = balance.solved(state)?;
                continue;
            }
            let Some((site, displacement)) = balance.farthest_beyond(&state) else {
                return Some(balance.whirl(&state));
            };
            state = balance.with(state, site, displacement)?;
        }
        None
    }
}

/// The string at a surface speed.
struct Balance<'a, H> {
    string: &'a EccentricString<H>,
    here: &'a Sample,
    /// The force of the mass at its offset, N.
    size: f64,
}

/// Forces that balance, or a guess at some.
#[derive(Debug, Clone)]
struct State {
    /// F in parts of the size.
    force: f64,
    touching: Vec<Touching>,
}

/// A site that touches.
#[derive(Debug, Clone)]
struct Touching {
    site: usize,
    /// Cube root of the normal force in parts of the size.
    root: f64,
    phase: f64,
    /// Where its wall is, m.
    clearance: f64,
}

impl<H: Fn(f64) -> Vec<Complex64>> Balance<'_, H> {
    fn radius(&self, touching: &Touching) -> f64 {
        let stiffness = self.string.walls[touching.site].stiffness;
        touching.clearance + (self.size / stiffness).powf(2.0 / 3.0) * touching.root.powi(2)
    }

    fn normal_force(&self, touching: &Touching) -> f64 {
        self.size * touching.root.powi(3)
    }

    /// What a wall does, N.
    fn by_wall(&self, touching: &Touching) -> Complex64 {
        let wall = &self.string.walls[touching.site];
        let friction = wall.friction_at(self.here.rate * (wall.radius + self.radius(touching)));
        let force = self.normal_force(touching) * Complex64::new(1.0, friction);
        -force * Complex64::cis(touching.phase)
    }

    /// The displacement of a site by all forces, m.
    fn displacement(&self, state: &State, site: usize) -> Complex64 {
        let by_mass = self.here.between(site, self.string.mass.site) * self.size * state.force;
        let walls = state.touching.iter();
        let by_walls = walls.map(|it| self.here.between(site, it.site) * self.by_wall(it));
        by_mass + by_walls.sum::<Complex64>()
    }

    /// What is left of each equation.
    fn left(&self, state: &State) -> Vec<f64> {
        let of_site = |touching: &Touching| {
            let there = Complex64::from_polar(self.radius(touching), touching.phase);
            let left = self.displacement(state, touching.site) - there;
            [left.re, left.im].map(|part| part / touching.clearance)
        };
        let radius = self.displacement(state, self.string.mass.site).norm();
        let of_mass = state.force - self.string.mass_force(self.here, radius) / self.size;
        let mut left: Vec<f64> = state.touching.iter().flat_map(of_site).collect();
        left.push(of_mass);
        left
    }

    /// The balance of these sites to which Newton's method converges.
    fn solved(&self, start: State) -> Option<State> {
        let place = |state: &State| {
            let sites = state.touching.iter().flat_map(|it| [it.root, it.phase]);
            sites.chain([state.force]).collect::<Vec<_>>()
        };
        let at = |place: &[f64]| {
            let mut state = start.clone();
            for (touching, values) in state.touching.iter_mut().zip(place.chunks(2)) {
                (touching.root, touching.phase) = (values[0], values[1]);
            }
            state.force = place[place.len() - 1];
            state
        };
        let found = root(place(&start), |place| self.left(&at(place)))?;
        Some(at(&found))
    }

    /// The balance with one more site, whose wall comes in from where the site is.
    fn with(&self, state: State, site: usize, displacement: Complex64) -> Option<State> {
        let (from, to) = (displacement.norm(), self.string.walls[site].clearance);
        let mut state = state;
        state.touching.push(Touching {
            site,
            root: libm::cbrt(LEAST_FORCE),
            phase: displacement.arg(),
            clearance: from,
        });
        let (mut done, mut step) = (0.0, 1.0_f64);
        while done < 1.0 {
            let next = (done + step).min(1.0);
            let mut moved = state.clone();
            if let Some(last) = moved.touching.last_mut() {
                last.clearance = from + next * (to - from);
            }
            match self.solved(moved) {
                Some(found) => (state, done, step) = (found, next, 2.0 * step),
                None if step > SHORTEST => step *= 0.5,
                None => return None,
            }
        }
        Some(state)
    }

    /// Of the sites that do not touch, that which is farthest beyond its clearance.
    fn farthest_beyond(&self, state: &State) -> Option<(usize, Complex64)> {
        let touches = |site: &usize| state.touching.iter().any(|it| it.site == *site);
        let others = (0..self.string.walls.len()).filter(|site| !touches(site));
        let beyond =
            |(site, it): &(usize, Complex64)| it.norm() / self.string.walls[*site].clearance;
        others
            .map(|site| (site, self.displacement(state, site)))
            .filter(|other| beyond(other) > 1.0 + ROUNDING)
            .max_by(|one, other| beyond(one).total_cmp(&beyond(other)))
    }

    fn whirl(&self, state: &State) -> ForwardContacts {
        let sites = 0..self.string.walls.len();
        let force = |site: usize| {
            let mut touching = state.touching.iter();
            let touching = touching.find(|it| it.site == site);
            touching.map_or(0.0, |it| self.normal_force(it))
        };
        let displacements: Vec<Complex64> = (sites.clone())
            .map(|site| self.displacement(state, site))
            .collect();
        ForwardContacts {
            radii: displacements.iter().map(|it| it.norm()).collect(),
            phases: displacements.iter().map(|it| it.arg()).collect(),
            normal_forces: sites.map(force).collect(),
        }
    }
}
