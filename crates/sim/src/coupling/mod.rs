//! All sites of a step at once: those that feel one another within it are solved in
//! turn, each with the others' latest loads, until what has changed of these no longer
//! matters. Sites that these cannot bring to their walls wait until the others have settled.
//!
//! Where walls do not rub, a turn of all sites is a descent in each of them of a convex energy
//! (h₀ of all sites is positive definite), and so converges from anywhere; the closer the
//! sites, the slower. Friction has no energy. So where some turns do not do, each is begun with
//! a step of Newton's method on all loads together.

mod loads;
mod newton;
#[cfg(test)]
mod tests;

use crate::channel::{Bending, Torsion};
use crate::site::Load;
use loads::Loads;

/// A site is solved again if the others' loads have changed since by what changes its own
/// force by more than this fraction of the largest: ten thousand times rounding, and a
/// thousandth of what a wall's law is held to (`laws::obeyed`).
const COUPLING_TOLERANCE: f64 = 1e-12;

/// Turns after which each is begun with a step of Newton's method.
const PLAIN_TURNS: usize = 30;

/// Turns after which sites that do not settle are given up.
const MOST_TURNS: usize = 200;

/// The loads of all sites that may bear one.
#[derive(Debug)]
pub(crate) struct Coupling<'a> {
    torsion: &'a Torsion,
    bending: Option<&'a Bending>,
    loads: Loads,
    normal_forces: Vec<f64>,
    /// What the others' loads have changed by since a site was solved, as force at it, N.
    pending: Vec<f64>,
    /// What of that leaves a site without a load as it was solved last, N.
    slack: Vec<f64>,
    /// What the load of a site is worth at every other, site by site; nothing without walls.
    shares: Vec<Share>,
}

/// Where sites would be in a step, and how fast they would turn, if none bore a load.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Free<'a> {
    /// x of all sites and then y, m.
    pub(crate) positions: &'a [f64],
    /// rad/s.
    pub(crate) speeds: &'a [f64],
}

/// The same of one site under the loads of all others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unloaded {
    /// m.
    pub(crate) position: [f64; 2],
    /// rad/s.
    pub(crate) speed: f64,
}

/// A site solved within a step, the loads of the others given.
pub(crate) struct Solved {
    pub(crate) load: Load,
    /// N.
    pub(crate) normal_force: f64,
    /// The force at the site, N, that the loads of others have to change by before it may bear
    /// one; zero where it does.
    pub(crate) slack: f64,
}

/// The force at a site that a load at another is worth. A site gives way by its own response,
/// or turns by it.
#[derive(Debug, Clone, Copy)]
struct Share {
    /// Of a force.
    of_force: f64,
    /// Of a torque, 1/m.
    of_torque: f64,
}

impl<'a> Coupling<'a> {
    /// Of the loads of a string, at whose walls it has these radii, m; it may have none.
    pub(crate) fn new(torsion: &'a Torsion, bending: Option<&'a Bending>, radii: &[f64]) -> Self {
        let count = torsion.sites();
        let share = |site: usize, radius: f64, other: usize| {
            let turned = torsion.share(site, other);
            Share {
                of_force: bending.map_or(0.0, |bending| bending.share(site, other)),
                of_torque: if turned == 0.0 { 0.0 } else { turned / radius },
            }
        };
        let of_load = |loaded| {
            let sites = radii.iter().enumerate();
            sites.map(move |(site, &radius)| share(site, radius, loaded))
        };
        Self {
            torsion,
            bending,
            loads: Loads::none(count),
            normal_forces: vec![0.0; count],
            pending: vec![0.0; count],
            slack: vec![0.0; count],
            shares: (0..count).flat_map(of_load).collect(),
        }
    }

    /// The loads of the step solved last.
    pub(crate) fn loads(&self) -> &[Load] {
        &self.loads.all
    }

    /// Forgets what acted in the last step.
    pub(crate) fn clear(&mut self) {
        self.loads.clear();
    }

    /// The torque on the one site that bears a load.
    pub(crate) fn set_torque(&mut self, index: usize, torque: f64) {
        let load = Load {
            torque,
            ..self.loads.all[index]
        };
        self.loads.replace(index, load);
    }

    /// Solves a step by solving one site after the other, from the loads of the last
    /// step on. Gives whether they settled.
    #[inline]
    pub(crate) fn settle<E>(
        &mut self,
        free: Free,
        mut solve: impl FnMut(usize, Unloaded) -> Result<Solved, E>,
    ) -> Result<bool, E> {
        self.pending.fill(f64::INFINITY);
        for turn in 0..MOST_TURNS {
            let largest = self.normal_forces.iter().copied().fold(0.0, f64::max);
            let matters = COUPLING_TOLERANCE * largest;
            if !self.is_open(matters) {
                // The others are told what has become of those that touch.
                for site in 0..self.pending.len() {
                    if self.pending[site] > matters {
                        self.solve_site(site, free, &mut solve)?;
                    }
                }
                return Ok(true);
            }
            if turn >= PLAIN_TURNS {
                newton::step(self, free, &mut solve);
            }
            for site in 0..self.pending.len() {
                if self.pending[site] > self.slack[site].max(matters) {
                    self.solve_site(site, free, &mut solve)?;
                }
            }
        }
        Ok(false)
    }

    /// Whether some site has to be solved again.
    fn is_open(&self, matters: f64) -> bool {
        let mut sites = self.pending.iter().zip(&self.slack);
        sites.any(|(pending, slack)| *pending > slack.max(matters))
    }

    #[inline]
    fn solve_site<E>(
        &mut self,
        site: usize,
        free: Free,
        solve: &mut impl FnMut(usize, Unloaded) -> Result<Solved, E>,
    ) -> Result<(), E> {
        let solved = solve(site, self.unloaded(site, free))?;
        self.normal_forces[site] = solved.normal_force;
        self.slack[site] = solved.slack;
        self.replace(site, solved.load);
        Ok(())
    }

    /// Where the loads of all others bring a site.
    #[inline]
    fn unloaded(&self, site: usize, free: Free) -> Unloaded {
        let sites = self.pending.len();
        let mut position = [0, 1].map(|axis| free.positions[axis * sites + site]);
        let mut speed = free.speeds[site];
        for (other, load) in self.loads.besides(site) {
            if let Some(bending) = self.bending {
                let compliance = bending.instant(site, other);
                for (position, force) in position.iter_mut().zip(load.force) {
                    *position += compliance * force;
                }
            }
            speed += self.torsion.instant(site, other) * load.torque;
        }
        Unloaded { position, speed }
    }

    /// The load of a site that has been solved, and what it changes for the others.
    #[inline]
    fn replace(&mut self, site: usize, load: Load) {
        let before = self.loads.replace(site, load);
        let [x, y] = [0, 1].map(|axis| (load.force[axis] - before.force[axis]).abs());
        let torque = (load.torque - before.torque).abs();
        self.pending[site] = 0.0;
        if x + y + torque == 0.0 {
            return;
        }
        let shares = self.shares.chunks_exact(self.pending.len()).nth(site);
        for (pending, share) in (self.pending.iter_mut()).zip(shares.into_iter().flatten()) {
            *pending += share.of_force * (x + y);
            *pending += share.of_torque * torque;
        }
        self.pending[site] = 0.0;
    }
}
