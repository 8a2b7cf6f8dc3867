//! The line of torsion: from torques at its ports, and a surface that turns, to speeds.

use super::chain::Chain;
use super::channel::{Past, Torsion};
use super::pieces::{Pieces, PiecesPast, SurfaceStep};
use crate::convolution::Kernel;
use crate::surface::SurfaceResponse;

/// The line of torsion as all cases share it.
#[derive(Debug, Clone)]
pub(crate) enum TorsionLine {
    /// Responses of the whole string, or elements that are stepped.
    Whole(Whole),
    /// The string in pieces between its ports.
    Pieces(Pieces),
}

/// A string whose ports feel one another by responses of its whole.
#[derive(Debug, Clone)]
pub(crate) struct Whole {
    /// The sites that a torque may act on.
    pub(crate) loaded: Vec<usize>,
    /// From torques to speeds, between these.
    pub(crate) from_torques: Torsion,
    /// Response of each site to a surface whose final speed is 1 rad/s.
    pub(crate) surface: Vec<SurfaceResponse>,
    /// From a torque at the bit to the speeds of the sites without torques, which are only
    /// observed.
    pub(crate) to_others: Vec<(usize, Kernel)>,
}

/// How ports turn within a step under the torques of this step.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Within<'a> {
    /// Each port feels every torque.
    All(&'a Torsion),
    /// Each feels its own torque and the speeds of its neighbours.
    Chain(&'a Chain),
}

/// The torques of a case so far, and what they left in the string.
#[derive(Debug)]
pub(crate) enum TorsionPast<'a> {
    Whole(&'a Whole, Past<'a, 1, 1>),
    Pieces(PiecesPast<'a>),
}

impl TorsionLine {
    /// The sites that a torque may act on, by number of the port.
    pub(crate) fn loaded(&self) -> &[usize] {
        match self {
            Self::Whole(whole) => &whole.loaded,
            Self::Pieces(pieces) => &pieces.ports,
        }
    }

    /// How its ports feel the torques of a step.
    pub(crate) fn within(&self) -> Within<'_> {
        match self {
            Self::Whole(whole) => Within::All(&whole.from_torques),
            Self::Pieces(pieces) => Within::Chain(&pieces.chain),
        }
    }

    /// The same where responses of the whole string are known.
    pub(crate) fn whole(&self) -> Option<&Whole> {
        match self {
            Self::Whole(whole) => Some(whole),
            Self::Pieces(_) => None,
        }
    }

    /// Steps until the surface stays within a fraction of its final speed, as far as the
    /// lowest site feels it.
    pub(crate) fn steady_from(&self, part: f64) -> usize {
        match self {
            Self::Whole(whole) => (whole.surface.last()).map_or(0, |it| it.is_steady_from(part)),
            Self::Pieces(pieces) => pieces.steady_from(part),
        }
    }

    /// The empty past of a case of a number of steps.
    pub(crate) fn past(&self, steps: usize) -> TorsionPast<'_> {
        match self {
            Self::Whole(whole) => TorsionPast::Whole(whole, whole.from_torques.past(steps)),
            Self::Pieces(pieces) => TorsionPast::Pieces(PiecesPast::empty(pieces, steps)),
        }
    }
}

impl Within<'_> {
    /// Number of ports.
    pub(crate) fn ports(&self) -> usize {
        match self {
            Self::All(torsion) => torsion.sites(),
            Self::Chain(chain) => chain.own.len(),
        }
    }

    /// Speed of a port per torque on it within the step while all that it feels stays, rad/s per
    /// N m.
    #[inline]
    pub(crate) fn compliance(&self, port: usize) -> f64 {
        match self {
            Self::All(torsion) => torsion.instant(port, port),
            Self::Chain(chain) => 1.0 / chain.own[port],
        }
    }

    /// Adds what a torque (N m) on a port does within a step to how all ports turn freely: their
    /// speeds, rad/s, or, where they are in a row, the torques that drive them, N m.
    #[inline]
    pub(crate) fn turn_by(&self, port: usize, torque: f64, free: &mut [f64]) {
        match self {
            Self::All(torsion) => {
                for (index, free) in free.iter_mut().enumerate() {
                    *free += torsion.instant(index, port) * torque;
                }
            }
            Self::Chain(_) => free[port] += torque,
        }
    }
}

impl TorsionPast<'_> {
    /// Writes what the ports do in a step without the torques of it: their speeds, rad/s, or, where
    /// they are in a row, the torques that drive them, N m. `surface_speed` is that of a scene that
    /// begins at rest, rad/s; one that begins with a steady motion has none, and what is written is
    /// what differs from that.
    #[inline(always)]
    pub(crate) fn write_free(&mut self, step: usize, surface_speed: Option<f64>, free: &mut [f64]) {
        match self {
            Self::Whole(whole, past) => {
                past.write_past(free);
                if let Some(surface_speed) = surface_speed {
                    for (speed, site) in free.iter_mut().zip(&whole.loaded) {
                        *speed += surface_speed * whole.surface[*site].at(step);
                    }
                }
            }
            Self::Pieces(past) => past.write_driving(step, surface_speed, free),
        }
    }

    /// Ends a step with the torques on all ports, N m, of a scene that began with a steady motion
    /// what differs from those of that, and their speeds and those in the steady motion, rad/s.
    #[inline(always)]
    pub(crate) fn end_step(
        &mut self,
        step: usize,
        torques: &[f64],
        (speeds, steady): (&[f64], Option<&[f64]>),
    ) {
        match self {
            Self::Whole(_, past) => past.add(torques),
            Self::Pieces(past) => past.send_waves(step, |port| {
                speeds[port] - steady.map_or(0.0, |steady| steady[port])
            }),
        }
    }

    /// What turns the surface in the step that ended last, where the line knows.
    pub(crate) fn surface(&self) -> Option<SurfaceStep> {
        match self {
            Self::Whole(..) => None,
            Self::Pieces(past) => Some(past.surface),
        }
    }

    /// All torques on a port so far, N m; none of pieces, which remember waves.
    pub(crate) fn torques(&self, port: usize) -> &[f64] {
        match self {
            Self::Whole(_, past) => past.loads(0, port),
            Self::Pieces(_) => &[],
        }
    }

    /// Passes a block in which no torque acts.
    pub(crate) fn push_quiet_block(&mut self) {
        if let Self::Whole(_, past) = self {
            past.push_quiet_block();
        }
    }
}
