//! Gauss–Seidel iteration: one port after the other, in turns.

use super::loads::largest_torque;
use super::ports::{Coupling, Free, Solved, Unloaded};
use super::{halved, newton, row};
use crate::line::Within;

/// A port is solved again if the others' loads have changed since by what changes its own
/// by more than this fraction of the largest: ten thousand times rounding, and a
/// thousandth of what a wall's law is held to (`laws::contact_residual`).
pub(super) const COUPLING_TOLERANCE: f64 = 1e-12;

/// What has not settled so far in all turns, but so far as this, has: a wall's law is held to no more.
const LAST_TOLERANCE: f64 = 1e-9;

/// Turns after which each is begun with a step of Newton's method.
const PLAIN_TURNS: usize = 30;

/// Turns after which ports that do not settle have to in [`halved`] ones.
pub(super) const MOST_TURNS: usize = 200;

/// The same of ports in a row, whose turns cost little.
const MOST_TURNS_OF_ROW: usize = 10_000;

/// Changes of load that no longer matter.
#[derive(Debug, Clone, Copy)]
struct Matters {
    /// Of a force at a wall, N.
    force: f64,
    /// Of a torque elsewhere, N m.
    torque: f64,
    /// Of what drives a port in a row, N m.
    driving: f64,
}

impl Coupling<'_> {
    /// Solves a step by solving one port after the other, from the loads of the last
    /// step on. Gives whether they settled.
    #[inline(always)]
    pub(crate) fn settle<E>(
        &mut self,
        free: Free,
        mut solve: impl FnMut(usize, Unloaded) -> Result<Solved, E>,
    ) -> Result<bool, E> {
        if let (Within::All(_), 1) = (self.within, self.pending.len()) {
            // There are no others to agree with.
            let solved = solve(0, self.unloaded(0, free))?;
            self.set_load(0, solved.load);
            return Ok(true);
        }
        self.pending.fill(f64::INFINITY);
        self.neighbours.begin_step(&self.loads);
        let driving = self.largest_driving(free);
        let most_turns = match self.within {
            Within::All(_) => MOST_TURNS,
            Within::Chain(_) => MOST_TURNS_OF_ROW,
        };
        for turn in 0..most_turns {
            let matters = self.matters(COUPLING_TOLERANCE, driving);
            match self.within {
                Within::All(torsion) if turn >= PLAIN_TURNS && self.any_is_open(free, &matters) => {
                    newton::step(self, torsion, free, &mut solve);
                }
                Within::Chain(chain) if self.any_is_open(free, &matters) => {
                    row::correct(self, chain, free, turn);
                }
                _ => {}
            }
            let mut have_settled = true;
            for port in 0..self.pending.len() {
                if self.is_open(port, free, &matters) {
                    self.solve_port(port, free, &mut solve)?;
                    have_settled = false;
                }
            }
            if have_settled {
                // The others get the latest loads of those that touch.
                for port in 0..self.pending.len() {
                    if self.pending[port] > self.matters_at(port, &matters) {
                        self.solve_port(port, free, &mut solve)?;
                    }
                }
                return Ok(true);
            }
        }
        let matters = self.matters(LAST_TOLERANCE, driving);
        match self.within {
            Within::All(torsion) if self.any_is_open(free, &matters) => {
                halved::settle(self, torsion, free, &mut solve)
            }
            _ => Ok(!self.any_is_open(free, &matters)),
        }
    }

    /// A turn of all ports, after which their loads are what their laws answer to the others'. Gives
    /// whether these no longer matter to one another.
    #[cold]
    pub(super) fn turn_all<E>(
        &mut self,
        free: Free,
        solve: &mut impl FnMut(usize, Unloaded) -> Result<Solved, E>,
    ) -> Result<bool, E> {
        for port in 0..self.pending.len() {
            self.solve_port(port, free, solve)?;
        }
        let matters = self.matters(COUPLING_TOLERANCE, 0.0);
        Ok(!self.any_is_open(free, &matters))
    }

    /// What no longer matters to this part of the largest of each; the largest torque that drives
    /// ports in a row is given, N m. A force at a wall is found to a part of itself, and so the torque
    /// of its friction to a part of what the force would turn with: of a string that is hardly driven
    /// yet, as where it begins to turn from rest, torques are no more than what rounding leaves of that.
    fn matters(&self, tolerance: f64, driving: f64) -> Matters {
        let largest = self.normal_forces.iter().copied().fold(0.0, f64::max);
        let at_walls = self.largest_radius * largest;
        let torques = match self.has_walls_only() {
            // No port is asked for it.
            true => 0.0,
            false => largest_torque(&self.loads),
        };
        Matters {
            force: tolerance * largest,
            torque: tolerance * torques.max(at_walls),
            driving: tolerance * driving.max(at_walls),
        }
    }

    /// The largest torque that drives ports in a row, N m.
    fn largest_driving(&self, free: Free) -> f64 {
        match self.within {
            Within::All(_) => 0.0,
            Within::Chain(_) => {
                let torques = free.turning.iter();
                torques.fold(0.0, |most: f64, torque| most.max(torque.abs()))
            }
        }
    }

    #[inline(always)]
    fn matters_at(&self, port: usize, matters: &Matters) -> f64 {
        match self.has_wall(port) {
            true => matters.force,
            false => matters.torque,
        }
    }

    /// Whether some port has to be solved again.
    #[inline(always)]
    fn any_is_open(&self, free: Free, matters: &Matters) -> bool {
        let mut ports = 0..self.pending.len();
        ports.any(|port| self.is_open(port, free, matters))
    }

    /// Whether a port has to be solved again.
    #[inline(always)]
    fn is_open(&self, port: usize, free: Free, matters: &Matters) -> bool {
        let pending = self.pending[port];
        let by_load = pending > self.matters_at(port, matters) && pending > self.slack[port];
        by_load || self.is_driven_anew(port, free, matters.driving)
    }

    /// Whether what drives a port in a row has changed since it was solved.
    #[inline(always)]
    fn is_driven_anew(&self, port: usize, free: Free, matters: f64) -> bool {
        match self.within {
            Within::All(_) => false,
            Within::Chain(chain) => {
                let change = self.driven(chain, port, free) - self.row.solved_for[port];
                change.abs() > matters
            }
        }
    }

    #[inline(always)]
    fn solve_port<E>(
        &mut self,
        port: usize,
        free: Free,
        solve: &mut impl FnMut(usize, Unloaded) -> Result<Solved, E>,
    ) -> Result<(), E> {
        let solved = solve(port, self.unloaded(port, free))?;
        self.normal_forces[port] = solved.normal_force;
        self.slack[port] = solved.slack;
        self.replace(port, solved.load);
        if let Within::Chain(chain) = self.within {
            self.row.solved_for[port] = self.driven(chain, port, free);
            self.row.speeds[port] = solved.speed;
            self.row.falls[port] = solved.fall;
        }
        Ok(())
    }
}
