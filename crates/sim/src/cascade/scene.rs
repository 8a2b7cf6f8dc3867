//! A case of a string with torques at its nodes.

use crate::laws::bit::BitTorque;
use crate::laws::pipe::{OnLines, PipeFriction, PipeMotion};
use crate::laws::torque::{LoadLine, TorqueLaw, TorqueStep};
use crate::ranges::{SceneError, finite, not_negative};
use crate::scene::Timing;

/// What acts at a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NodeTorque {
    /// Nothing.
    None,
    /// The rock, at the bit.
    Bit(BitTorque),
    /// The borehole, along the pipe.
    Pipe(PipeFriction),
}

/// What acts at a node whose load lines have a slope.
#[derive(Debug, Clone, Copy)]
pub(super) enum NodeLaw {
    None,
    Bit(BitTorque),
    Pipe(OnLines),
}

impl NodeLaw {
    /// Meets the load line, what the node was doing before given, and a guess of its speed.
    #[inline]
    pub(super) fn meet(
        &self,
        before: &PipeMotion,
        line: LoadLine,
        guess: f64,
    ) -> TorqueStep<PipeMotion> {
        match self {
            Self::None => TorqueStep {
                torque: 0.0,
                speed: line.free_speed,
                state: PipeMotion::default(),
            },
            Self::Bit(law) => {
                let TorqueStep {
                    torque,
                    speed,
                    state: motion,
                } = law.meet(&before.motion, line);
                TorqueStep {
                    torque,
                    speed,
                    state: PipeMotion {
                        motion,
                        speed: speed.abs(),
                    },
                }
            }
            Self::Pipe(law) => law.meet(before, line.free_speed, guess.abs()),
        }
    }

    /// By how much the torque against the node falls with its speed, where it turns, N m per
    /// rad/s; of the bit's as if it stayed.
    pub(super) fn fall(&self, speed: f64) -> f64 {
        match self {
            Self::None | Self::Bit(_) => 0.0,
            Self::Pipe(law) => law.fall(speed.abs()),
        }
    }

    /// Whether a node may be held.
    pub(super) fn holds(&self) -> bool {
        !matches!(self, Self::None)
    }
}

impl NodeTorque {
    /// With load lines of a compliance, rad/s per N m.
    pub(super) fn on_lines(self, compliance: f64) -> NodeLaw {
        match self {
            Self::None => NodeLaw::None,
            Self::Bit(law) => NodeLaw::Bit(law),
            Self::Pipe(law) => NodeLaw::Pipe(law.on_lines(compliance)),
        }
    }

    fn check(&self) -> Result<(), SceneError> {
        match self {
            Self::None => Ok(()),
            Self::Bit(law) => law.check(),
            Self::Pipe(law) => law.check(),
        }
    }
}

/// One case, from rest: the surface starts to turn at t = 0, as its system says.
#[derive(Debug, Clone, PartialEq)]
pub struct CascadeScene {
    /// Surface rotation speed Ω that the profile is a part of, rad/s.
    pub surface_speed: f64,
    /// The torque at each node, from the surface down.
    pub torques: Vec<NodeTorque>,
    /// Time simulated and closing window.
    pub timing: Timing,
}

impl CascadeScene {
    /// Checks that every number is in its range.
    pub(super) fn check(&self) -> Result<(), SceneError> {
        finite("surface speed in rad/s", self.surface_speed)?;
        not_negative("time simulated in s", self.timing.duration)?;
        not_negative("closing window in s", self.timing.closing_window)?;
        self.torques.iter().try_for_each(NodeTorque::check)
    }
}
