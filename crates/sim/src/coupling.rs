//! All sites of a step at once: those that feel one another within it are solved in
//! turn, each with the others' latest loads, until what has changed of these no longer
//! matters.

use crate::site::Load;
use crate::system::System;

/// Sites are solved in turn until no force would change by more than this fraction of
/// the largest.
const COUPLING_TOLERANCE: f64 = 1e-12;

/// Turns after which sites that do not settle are given up.
const MOST_TURNS: usize = 200;

/// The loads of all sites that may bear one.
#[derive(Debug)]
pub(crate) struct Coupling {
    loads: Vec<Load>,
    /// How much they have changed in the last turn: force and torque.
    changes: Vec<(f64, f64)>,
}

impl Coupling {
    pub(crate) fn new(count: usize) -> Self {
        Self {
            loads: vec![Load::default(); count],
            changes: vec![(0.0, 0.0); count],
        }
    }

    /// The loads of the step solved last.
    pub(crate) fn loads(&self) -> &[Load] {
        &self.loads
    }

    /// Forgets what acted in the last step.
    pub(crate) fn clear(&mut self) {
        self.loads.fill(Load::default());
    }

    /// The torque on the one site that bears a load.
    pub(crate) fn set_torque(&mut self, index: usize, torque: f64) {
        self.loads[index].torque = torque;
    }

    /// Solves a step by solving one site after the other, from the loads of the last
    /// step on: `solve` gives the load of a site and its normal force, N. Gives whether
    /// they settled; `radius` is that of the string at a site.
    #[inline]
    pub(crate) fn settle<E>(
        &mut self,
        system: &System,
        radius: impl Fn(usize) -> f64,
        mut solve: impl FnMut(usize, &[Load]) -> Result<(Load, f64), E>,
    ) -> Result<bool, E> {
        for _ in 0..MOST_TURNS {
            let mut largest: f64 = 0.0;
            for index in 0..self.loads.len() {
                let (load, normal_force) = solve(index, &self.loads)?;
                let before = std::mem::replace(&mut self.loads[index], load);
                self.changes[index] = (
                    (load.force[0] - before.force[0]).abs()
                        + (load.force[1] - before.force[1]).abs(),
                    (load.torque - before.torque).abs(),
                );
                largest = largest.max(normal_force);
            }
            let is_alone = self.loads.len() == 1;
            if is_alone || self.largest_effect(system, &radius) <= COUPLING_TOLERANCE * largest {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The most that the last changes of the loads change the force at any other
    /// site, N.
    fn largest_effect(&self, system: &System, radius: impl Fn(usize) -> f64) -> f64 {
        let torques = &system.from_torques;
        let mut largest: f64 = 0.0;
        for site in 0..self.loads.len() {
            for (other, (force, torque)) in self.changes.iter().enumerate() {
                if other == site {
                    continue;
                }
                // A site gives way by its own response, or turns by it.
                let turned = torques.instant(site, other).abs() * torque;
                largest = largest.max(turned / (torques.instant(site, site) * radius(site)));
                if let Some(forces) = &system.from_forces {
                    let pushed = forces.instant(site, other).abs() * force;
                    largest = largest.max(pushed / forces.instant(site, site));
                }
            }
        }
        largest
    }
}
