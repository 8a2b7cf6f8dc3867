//! The sites of a step: where they would be, their loads, and what these are worth to one another.

use super::loads::Loads;
use crate::channel::{Bending, Torsion};
use crate::site::Load;

/// The loads of all sites that may bear one.
#[derive(Debug)]
pub(crate) struct Coupling<'a> {
    pub(super) torsion: &'a Torsion,
    pub(super) bending: Option<&'a Bending>,
    pub(super) loads: Loads,
    pub(super) normal_forces: Vec<f64>,
    /// What the others' loads have changed by since a site was solved, as force at it, N.
    pub(super) pending: Vec<f64>,
    /// What of that leaves a site without a load as it was solved last, N.
    pub(super) slack: Vec<f64>,
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

/// A site solved within a step, the loads of the others given. Its two numbers stand apart: side by
/// side they are written one by one and read as a pair, for which the processor waits.
pub(crate) struct Solved {
    /// N.
    pub(crate) normal_force: f64,
    pub(crate) load: Load,
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

    /// Where the loads of all others bring a site.
    #[inline]
    pub(super) fn unloaded(&self, site: usize, free: Free) -> Unloaded {
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
    pub(super) fn replace(&mut self, site: usize, load: Load) {
        let before = self.loads.replace(site, load);
        let [x, y] = [0, 1].map(|axis| (load.force[axis] - before.force[axis]).abs());
        let torque = (load.torque - before.torque).abs();
        if x + y + torque != 0.0 {
            let shares = self.shares.chunks_exact(self.pending.len()).nth(site);
            for (pending, share) in (self.pending.iter_mut()).zip(shares.into_iter().flatten()) {
                *pending += share.of_force * (x + y);
                *pending += share.of_torque * torque;
            }
        }
        self.pending[site] = 0.0;
    }
}
