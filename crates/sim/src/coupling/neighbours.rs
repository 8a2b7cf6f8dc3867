//! What ports feel of one another within a step: of those near by the loads as they are now, of those far
//! away the loads as they were when it began.

use super::loads::Load;
use crate::line::{Bending, WallPorts, Within};

/// A port is near where either's load within a step moves the other by more than this part of what it moves
/// itself by. What loads far away are late by is then less than a tenth of what a wall's law is held to
/// (`laws::contact_residual`), however they change in a step.
const NEAR: f64 = 3e-11;

/// Of so few ports all are near: there is nothing to save.
const FEW: usize = 8;

/// What a port feels of another within a step, and what its own load is worth there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbour {
    /// Its number.
    pub(super) port: usize,
    /// Displacement per force on it, m/N.
    pub(super) bends: f64,
    /// Speed per torque on it, rad/s per N m; zero where ports feel the speeds of neighbours instead.
    pub(super) turns: f64,
    /// Load on it that a force here is worth: it gives way by its own response, or turns by it.
    pub(super) worth_of_force: f64,
    /// The same of a torque here.
    pub(super) worth_of_torque: f64,
}

/// How the ports that have walls bend.
#[derive(Debug)]
pub(super) struct Walled<'a> {
    pub(super) bending: &'a Bending,
    pub(super) walls: &'a WallPorts,
}

/// How loads move a port.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Moved {
    /// m.
    pub(super) position: [f64; 2],
    /// rad/s.
    pub(super) speed: f64,
}

impl Moved {
    /// By the loads of some ports.
    #[inline(always)]
    pub(super) fn by(&mut self, neighbours: &[Neighbour], loads: &[Load]) {
        for neighbour in neighbours {
            let load = &loads[neighbour.port];
            for (position, force) in self.position.iter_mut().zip(load.force) {
                *position += neighbour.bends * force;
            }
            self.speed += neighbour.turns * load.torque;
        }
    }
}

/// The neighbours of all ports.
#[derive(Debug)]
pub(super) struct Neighbours {
    near: ByPort,
    far: ByPort,
    /// How each port is moved by those far away; nothing where all are near.
    by_far: Vec<Moved>,
}

/// Neighbours, port by port in rising order.
#[derive(Debug, Default)]
struct ByPort {
    all: Vec<Neighbour>,
    /// Where those of each port end.
    ends: Vec<usize>,
}

impl ByPort {
    #[inline(always)]
    fn of(&self, port: usize) -> &[Neighbour] {
        let begin = if port == 0 { 0 } else { self.ends[port - 1] };
        &self.all[begin..self.ends[port]]
    }
}

impl Neighbours {
    /// Of ports that turn one another like this and of which some have walls, where the string has
    /// these radii, m.
    pub(super) fn new(within: Within, walled: Option<&Walled>, radii: &[f64]) -> Self {
        let near_from = if within.ports() > FEW { NEAR } else { 0.0 };
        Self::near_from(near_from, within, walled, radii)
    }

    /// The same, those near that feel one another by more than a part.
    pub(super) fn near_from(
        part: f64,
        within: Within,
        walled: Option<&Walled>,
        radii: &[f64],
    ) -> Self {
        let count = within.ports();
        let wall_at = |port: usize| walled.and_then(|it| Some((it.bending, it.walls.at(port)?)));
        let bends = |port: usize, other: usize| {
            let pair = wall_at(port).zip(wall_at(other));
            pair.map_or(0.0, |((bending, wall), (_, other))| {
                bending.instant(wall, other)
            })
        };
        let turns = |port: usize, other: usize| match within {
            Within::All(torsion) => torsion.instant(port, other),
            Within::Chain(_) => 0.0,
        };
        let felt: Vec<usize> = match within {
            Within::All(_) => (0..count).collect(),
            Within::Chain(_) => walled.map_or(Vec::new(), |it| it.walls.ports().to_vec()),
        };
        let (mut near, mut far) = (ByPort::default(), ByPort::default());
        for port in 0..count {
            for &other in felt.iter().filter(|other| **other != port) {
                // How far a load here moves the other, and one there this, in parts of what they do themselves.
                let pairs = [(other, port), (port, other)];
                let bent = pairs.map(|(output, input)| {
                    let pair = wall_at(output).zip(wall_at(input));
                    pair.map_or(0.0, |((bending, wall), (_, other))| {
                        bending.share(wall, other)
                    })
                });
                let turned = pairs.map(|(output, input)| match within {
                    Within::All(torsion) => torsion.share(output, input),
                    Within::Chain(_) => 0.0,
                });
                let worth_of_torque = match wall_at(other) {
                    _ if turned[0] == 0.0 => 0.0,
                    Some((_, wall)) => turned[0] / radii[wall],
                    None => turned[0],
                };
                let neighbour = Neighbour {
                    port: other,
                    bends: bends(port, other),
                    turns: turns(port, other),
                    worth_of_force: bent[0],
                    worth_of_torque,
                };
                let most = bent.into_iter().chain(turned).fold(0.0, f64::max);
                if most > part {
                    near.all.push(neighbour);
                } else if most > 0.0 {
                    far.all.push(neighbour);
                }
            }
            near.ends.push(near.all.len());
            far.ends.push(far.all.len());
        }
        let by_far = match far.all.is_empty() {
            true => Vec::new(),
            false => vec![Moved::default(); count],
        };
        Self { near, far, by_far }
    }

    /// A step begins, with the loads of the last.
    #[inline]
    pub(super) fn begin_step(&mut self, loads: &[Load]) {
        for (port, moved) in self.by_far.iter_mut().enumerate() {
            *moved = Moved::default();
            moved.by(self.far.of(port), loads);
        }
    }

    /// Those near a port.
    #[inline(always)]
    pub(super) fn near(&self, port: usize) -> &[Neighbour] {
        self.near.of(port)
    }

    /// How a port is moved by those far away.
    #[inline(always)]
    pub(super) fn by_far(&self, port: usize) -> Moved {
        self.by_far.get(port).copied().unwrap_or_default()
    }
}
