//! The ports of a step: where they would be, their loads, and what these are worth to one another.

use super::loads::Load;
use super::neighbours::{Neighbours, Walled};
use crate::line::{Bending, Chain, WallPorts, Within};

/// The loads of all ports that may bear one.
#[derive(Debug)]
pub(crate) struct Coupling<'a> {
    pub(super) within: Within<'a>,
    pub(super) walled: Option<Walled<'a>>,
    pub(super) loads: Vec<Load>,
    /// How many ports bear one.
    acting: usize,
    pub(super) normal_forces: Vec<f64>,
    /// What the others' loads have changed by since a port was solved, as load at it: force, N, at
    /// a wall and torque, N m, elsewhere.
    pub(super) pending: Vec<f64>,
    /// What of that leaves a port without a load as it was solved last, N.
    pub(super) slack: Vec<f64>,
    pub(super) neighbours: Neighbours,
    /// Of the string at its walls, m; zero where it has none.
    pub(super) largest_radius: f64,
    /// Whether of several answers of a wall the nearest to its present one is wanted.
    pub(super) keeps_answers: bool,
    pub(super) row: Row,
}

/// What ports in a row have of a step.
#[derive(Debug)]
pub(super) struct Row {
    /// Speeds, rad/s.
    pub(super) speeds: Vec<f64>,
    /// What drove each port when it was solved last, N m.
    pub(super) solved_for: Vec<f64>,
    /// By how much the torque against a port falls with its speed, N m per rad/s; `None` where it
    /// is held.
    pub(super) falls: Vec<Option<f64>>,
    /// Of a correction, from above: how a port's change depends on the next one's, and its own.
    pub(super) changes: Vec<(f64, f64)>,
}

/// Where ports would be in a step, and how they would turn, if none bore a load.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Free<'a> {
    /// x of all walls and then y, m.
    pub(crate) positions: &'a [f64],
    /// Speeds, rad/s, or, of ports in a row, the torques that drive them, N m.
    pub(crate) turning: &'a [f64],
}

/// The same of one port under the loads of all others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unloaded {
    /// m.
    pub(crate) position: [f64; 2],
    /// rad/s.
    pub(crate) speed: f64,
    /// The speed that it was solved for last, rad/s, where that is known.
    pub(crate) guess: Option<f64>,
    /// Where its own load of now brings it, m, where of several answers the nearest is wanted.
    pub(crate) present: Option<[f64; 2]>,
}

/// A port solved within a step, the loads of the others given.
pub(crate) struct Solved {
    /// N.
    pub(crate) normal_force: f64,
    pub(crate) load: Load,
    /// The force at the port, N, that the loads of others have to change by before it may bear
    /// one; zero where it does.
    pub(crate) slack: f64,
    /// rad/s.
    pub(crate) speed: f64,
    /// By how much the torque against it falls with its speed, N m per rad/s; `None` where it is
    /// held.
    pub(crate) fall: Option<f64>,
}

impl Solved {
    /// Adds to its load what takes back a spring (N/m) that holds the linear string at a position.
    #[inline]
    pub(crate) fn take_back(&mut self, spring: f64, position: [f64; 2]) {
        for (force, position) in self.load.force.iter_mut().zip(position) {
            *force += spring * position;
            self.normal_force = self.normal_force.max(force.abs());
        }
    }
}

impl<'a> Coupling<'a> {
    /// Of the loads of a string whose ports feel one another like this; those at `walls` bend,
    /// too, and have these radii, m, or none where the scene has no walls.
    pub(crate) fn new(
        within: Within<'a>,
        bending: Option<&'a Bending>,
        (walls, radii): (&'a WallPorts, &[f64]),
    ) -> Self {
        let count = within.ports();
        let bending = bending.filter(|_| !radii.is_empty());
        let walled = bending.map(|bending| Walled { bending, walls });
        let in_row = match within {
            Within::All(_) => 0,
            Within::Chain(chain) => chain.own.len(),
        };
        Self {
            neighbours: Neighbours::new(within, walled.as_ref(), radii),
            within,
            walled,
            largest_radius: radii.iter().copied().fold(0.0, f64::max),
            keeps_answers: false,
            loads: vec![Load::default(); count],
            acting: 0,
            normal_forces: vec![0.0; count],
            pending: vec![0.0; count],
            slack: vec![0.0; count],
            row: Row {
                speeds: vec![0.0; in_row],
                solved_for: vec![0.0; in_row],
                falls: vec![None; in_row],
                changes: vec![(0.0, 0.0); in_row],
            },
        }
    }

    /// The loads of the step solved last.
    pub(crate) fn loads(&self) -> &[Load] {
        &self.loads
    }

    /// Forgets what acted in the last step.
    pub(crate) fn clear(&mut self) {
        self.loads.fill(Load::default());
        self.acting = 0;
    }

    /// Gives ports in a row the speeds that a case begins with, rad/s.
    pub(crate) fn begin_at(&mut self, speeds: &[f64]) {
        if let Within::Chain(_) = self.within {
            self.row.speeds.copy_from_slice(speeds);
        }
    }

    /// The torque on the one port that bears a load.
    #[inline]
    pub(crate) fn set_torque(&mut self, port: usize, torque: f64) {
        let force = [0.0; 2];
        self.set_load(port, Load { force, torque });
    }

    /// Displacement per force between two ports within a step, m/N; none where either does not
    /// bend.
    #[inline]
    pub(super) fn bends(&self, port: usize, other: usize) -> f64 {
        let compliance = |walled: &Walled| {
            let (wall, other) = (walled.walls.at(port)?, walled.walls.at(other)?);
            Some(walled.bending.instant(wall, other))
        };
        self.walled.as_ref().and_then(compliance).unwrap_or(0.0)
    }

    /// Whether every port has a wall.
    pub(super) fn has_walls_only(&self) -> bool {
        (self.walled.as_ref()).is_some_and(|walled| walled.walls.is_every_port())
    }

    /// Whether a port has a wall.
    #[inline]
    pub(super) fn has_wall(&self, port: usize) -> bool {
        (self.walled.as_ref()).is_some_and(|walled| walled.walls.at(port).is_some())
    }

    /// Where the loads of all others bring a port.
    #[inline(always)]
    pub(super) fn unloaded(&self, port: usize, free: Free) -> Unloaded {
        let mut moved = self.neighbours.by_far(port);
        let wall = (self.walled.as_ref()).and_then(|it| Some((it.walls, it.walls.at(port)?)));
        if let Some((walls, wall)) = wall {
            for (axis, position) in moved.position.iter_mut().enumerate() {
                *position += free.positions[axis * walls.len() + wall];
            }
        }
        let guess = match self.within {
            Within::All(_) => {
                moved.speed += free.turning[port];
                None
            }
            Within::Chain(chain) => {
                moved.speed = self.driven(chain, port, free) / chain.own[port];
                Some(self.row.speeds[port])
            }
        };
        if self.acting > 0 {
            moved.by(self.neighbours.near(port), &self.loads);
        }
        Unloaded {
            position: moved.position,
            speed: moved.speed,
            guess,
            present: self.present(port, moved.position),
        }
    }

    /// Where its load of now brings a port that would be at a position without, m, where that matters.
    #[inline]
    fn present(&self, port: usize, position: [f64; 2]) -> Option<[f64; 2]> {
        let force = self.loads[port].force;
        let matters = self.keeps_answers && force != [0.0; 2];
        matters.then(|| {
            let gives = self.bends(port, port);
            [0, 1].map(|axis| position[axis] + gives * force[axis])
        })
    }

    /// What drives a port in a row under the speeds of its neighbours, N m.
    #[inline]
    pub(super) fn driven(&self, chain: &Chain, port: usize, free: Free) -> f64 {
        free.turning[port] - chain.taken_by_neighbours(port, &self.row.speeds)
    }

    /// Gives a port a load, and what it was before.
    #[inline]
    pub(super) fn set_load(&mut self, port: usize, load: Load) -> Load {
        let before = std::mem::replace(&mut self.loads[port], load);
        let [did, does] = [before, load].map(|load| usize::from(load != Load::default()));
        self.acting = self.acting + does - did;
        before
    }

    /// The load of a port that has been solved, and what it changes for the others.
    #[inline(always)]
    pub(super) fn replace(&mut self, port: usize, load: Load) {
        let before = self.set_load(port, load);
        if load != before {
            self.pass_on(port, before, load);
        }
        self.pending[port] = 0.0;
    }

    /// Adds what the change of a load is worth to what is pending at the ports near by.
    #[inline(always)]
    fn pass_on(&mut self, port: usize, before: Load, load: Load) {
        let [x, y] = [0, 1].map(|axis| (load.force[axis] - before.force[axis]).abs());
        let torque = (load.torque - before.torque).abs();
        for near in self.neighbours.near(port) {
            let pending = &mut self.pending[near.port];
            *pending += near.worth_of_force * (x + y);
            *pending += near.worth_of_torque * torque;
        }
    }
}
