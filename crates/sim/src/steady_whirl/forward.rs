//! Steady forward whirl: an eccentric mass takes the string round with it, in the air or along
//! the wall.
//!
//! The mass m_e is off the centre by d and turns with the string at its speed Ω. With H(iΩ) the
//! receptance of the string that carries it, its force is F = m_e d Ω², and with no wall any site
//! goes round at |H_jm| F. It reaches its clearance c_j where its **reach** m_e d Ω² |H_jm|/c_j equals
//! one. In the form of the paper the string does not carry it, and where the centre goes round by
//! a radius r there its force is m_e (d + r) Ω². Its size follows from that radius, |H_mm| F:
//!
//! F = m_e d Ω² / (1 − m_e Ω² |H_mm|).
//! So a site reaches its clearance c_j where its **reach** m_e Ω² (d |H_jm|/c_j + |H_mm|) equals
//! one; there is no other limit to the radius where m_e Ω² |H_mm| equals one. No resonance can be
//! missed between two speeds: −H maps the quarter plane of [`super::variation`] into the upper half
//! plane as K does, and so do −f*Hf for all forces f. Over a hyperbolic distance D such a function
//! changes by no more than (e^D − 1) times its imaginary part. That of forces at the mass and a
//! site, in the sizes at which their losses are equal, gives for the receptance between them
//!
//! |ΔH_jm| ≤ (e^D − 1) (Im H_jj · Im H_mm)^½.
//!
//! Along the wall the string slides, and friction holds it back: with a normal force N at a site
//! it goes round at r = H_jm F − H_jj (1 + iμ) N, with the phases that make r real.

use linear::Complex64;
use linear::bending_decay::BendingDecay;

use super::is_damped;
use super::variation::Variation;
use crate::excitation::EccentricMass;
use crate::laws::wall::Wall;
use crate::ranges::{SceneError, positive};

/// Over this hyperbolic distance a reach changes by about the same relative amount: a reach nearer
/// to one counts as touching.
const NEAREST: f64 = 1e-3;

/// Normal forces are tried from this part of the force of the mass without a wall …
const LEAST_FORCE: f64 = 1e-9;

/// … to this multiple of it, …
const MOST_FORCE: f64 = 1e6;

/// … at this number of values.
const FORCES: i32 = 3000;

/// A string with an eccentric mass between walls.
#[derive(Debug, Clone)]
pub struct EccentricString<H> {
    /// The walls at its sites.
    pub walls: Vec<Wall>,
    /// The mass, at one of the sites.
    pub mass: EccentricMass,
    /// Whether the receptance is that of the string that carries it; else its force is that of the
    /// paper.
    pub is_carried: bool,
    /// The receptance H at the sites, row by row (m/N), at a rate (rad/s).
    pub receptance: H,
    /// How fast oscillations decay at least, as of [`super::WhirlingSite`].
    pub decay: BendingDecay,
}

/// The lowest speed at which forward whirl touches a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LowestTouch {
    /// Surface speed, rad/s.
    pub surface_speed: f64,
    /// The site that comes nearest there to its wall.
    pub site: usize,
}

/// Steady forward whirl in contact at one site.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ForwardWhirl {
    /// Radius at which each site goes round, m. The balance is of this site in contact alone:
    /// no other one may be beyond its clearance.
    pub radii: Vec<f64>,
    /// Normal force, N.
    pub normal_force: f64,
}

impl<H: Fn(f64) -> Vec<Complex64>> EccentricString<H> {
    /// The radius (m) at which each site goes round at a surface speed (rad/s) if no wall is in
    /// the way; none where nothing else limits it.
    pub fn free_radii(&self, surface_speed: f64) -> Option<Vec<f64>> {
        let here = self.sample(surface_speed);
        let mass = self.mass_force(&here, 0.0);
        let per_radius = self.mass_force(&here, 1.0) - mass;
        let at_mass = here.between(self.mass.site, self.mass.site).norm();
        let left = 1.0 - per_radius * at_mass;
        let radius = |site| mass / left * here.between(site, self.mass.site).norm();
        (left > 0.0).then(|| (0..self.walls.len()).map(radius).collect())
    }

    /// The lowest of the surface speeds between two (rad/s) at which a site touches its wall: it is
    /// certain that none touches at a lower one, and at this one a site does, or would with a
    /// mass 0.2 % greater.
    ///
    /// # Errors
    /// Where the lower speed is not positive, or the string is not damped enough to tell.
    pub fn first_touch(&self, surface_speeds: [f64; 2]) -> Result<Option<LowestTouch>, SceneError> {
        let [slowest, fastest] = surface_speeds;
        positive("surface speed in rad/s", slowest)?;
        if !is_damped(&self.decay, fastest) {
            return Err(SceneError::OutOfRange {
                quantity: "rate in 1/s at which the string's oscillations decay",
                value: self.decay.corner_below(fastest).decay_rate,
                expected: "more than a millionth of the surface speed in rad/s",
            });
        }
        let ends = surface_speeds.map(|speed| self.sample(speed));
        Ok(self.between([&ends[0], &ends[1]]))
    }

    /// Forward whirl at a surface speed (rad/s) in contact at one site alone, sliding: of what
    /// balances the forces, that with the least normal force; none where the site does not reach
    /// its wall, or no force does that is a million times that of the mass at its offset. The
    /// force is sampled, 200 times in each tenfold, so that two balances closer than that are
    /// missed.
    pub fn in_contact_at(&self, site: usize, surface_speed: f64) -> Option<ForwardWhirl> {
        let here = self.sample(surface_speed);
        let excess = |normal_force: f64| self.excess(&here, site, normal_force);
        let scale = self.mass_force(&here, 0.0);
        let force = |step: i32| {
            let part = f64::from(step) / f64::from(FORCES);
            scale * LEAST_FORCE * (MOST_FORCE / LEAST_FORCE).powf(part)
        };
        if excess(0.0) >= 0.0 {
            return None;
        }
        let above = (0..=FORCES).find(|step| excess(force(*step)) >= 0.0)?;
        let [mut low, mut high] = [
            if above == 0 { 0.0 } else { force(above - 1) },
            force(above),
        ];
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            *(if excess(middle) < 0.0 {
                &mut low
            } else {
                &mut high
            }) = middle;
        }
        let displacements = self.displacements(&here, site, high);
        Some(ForwardWhirl {
            radii: displacements.iter().map(|it| it.norm()).collect(),
            normal_force: high,
        })
    }

    pub(super) fn sample(&self, rate: f64) -> Sample {
        Sample {
            rate,
            sites: self.walls.len(),
            receptance: (self.receptance)(rate),
        }
    }

    /// The force of the mass where the string goes round at a radius (m), N.
    pub(super) fn mass_force(&self, here: &Sample, radius: f64) -> f64 {
        let arm = self.mass.offset + if self.is_carried { 0.0 } else { radius };
        self.mass.mass * here.rate * here.rate * arm
    }

    /// The site with the greatest reach up to a hyperbolic distance from a rate, at speeds up to
    /// one, and no less than that reach.
    fn reach(&self, here: &Sample, distance: f64, surface_speed: f64) -> (usize, f64) {
        let mass = self.mass.site;
        let growth = distance.exp_m1();
        let most = |site: usize| {
            let losses = here.between(site, site).im * here.between(mass, mass).im;
            here.between(site, mass).norm() + growth * losses.max(0.0).sqrt()
        };
        let scale = self.mass.mass * surface_speed * surface_speed;
        let reach = |site: usize| {
            let in_clearances = self.mass.offset / self.walls[site].clearance * most(site);
            let by_radius = if self.is_carried { 0.0 } else { most(mass) };
            (site, scale * (in_clearances + by_radius))
        };
        let reaches = (0..self.walls.len()).map(reach);
        // What is no number counts as the greatest.
        let greatest = reaches.max_by(|one, other| one.1.abs().total_cmp(&other.1.abs()));
        greatest.unwrap_or((mass, scale * most(mass)))
    }

    fn touch(&self, here: &Sample) -> LowestTouch {
        LowestTouch {
            surface_speed: here.rate,
            site: self.reach(here, 0.0, here.rate).0,
        }
    }

    /// The first touch from the lower of two speeds on, up to the higher one.
    fn between(&self, [low, high]: [&Sample; 2]) -> Option<LowestTouch> {
        let variation = Variation::above(&self.decay, low.rate);
        let middle = 0.5 * (low.rate + high.rate);
        let [below, above] = [low, high].map(|end| variation.distance(end.rate, middle));
        let reaches = [
            self.reach(low, below, middle).1,
            self.reach(high, above, high.rate).1,
        ];
        if reaches.iter().all(|reach| *reach < 1.0) {
            return None;
        }
        if below + above < NEAREST || self.reach(low, 0.0, low.rate).1 >= 1.0 {
            return Some(self.touch(low));
        }
        let middle = self.sample(middle);
        (self.between([low, &middle])).or_else(|| self.between([&middle, high]))
    }

    /// Displacements where a site is in contact with a normal force (N): its own is real.
    fn displacements(&self, here: &Sample, site: usize, normal_force: f64) -> Vec<Complex64> {
        let (force, wall) = self.forces(here, site, normal_force);
        (0..self.walls.len())
            .map(|it| here.between(it, self.mass.site) * force - here.between(it, site) * wall)
            .collect()
    }

    /// What the mass must bring to bear for a normal force, and what the wall does.
    pub(super) fn forces(
        &self,
        here: &Sample,
        site: usize,
        normal_force: f64,
    ) -> (Complex64, Complex64) {
        let wall = &self.walls[site];
        let radius = wall.clearance + (normal_force / wall.stiffness).powf(2.0 / 3.0);
        let friction = wall.friction_at(here.rate * (wall.radius + radius));
        let by_wall = normal_force * Complex64::new(1.0, friction);
        let needed = radius + here.between(site, site) * by_wall;
        (needed / here.between(site, self.mass.site), by_wall)
    }

    /// By how much that is more than the mass has, N.
    fn excess(&self, here: &Sample, site: usize, normal_force: f64) -> f64 {
        let mass = self.mass.site;
        let (force, by_wall) = self.forces(here, site, normal_force);
        let at_mass = here.between(mass, mass) * force - here.between(mass, site) * by_wall;
        force.norm() - self.mass_force(here, at_mass.norm())
    }
}

/// The receptance at a rate.
pub(super) struct Sample {
    pub rate: f64,
    sites: usize,
    receptance: Vec<Complex64>,
}

impl Sample {
    pub fn between(&self, one: usize, other: usize) -> Complex64 {
        self.receptance[one * self.sites + other]
    }
}
