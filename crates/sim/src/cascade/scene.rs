//! A case of a string with torques at its nodes.

use crate::laws::bit::BitTorque;
use crate::laws::pipe::{PipeFriction, PipeMotion};
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

impl NodeTorque {
    /// Meets the load line, what the node was doing before given.
    #[inline]
    pub(super) fn meet(&self, before: &PipeMotion, line: LoadLine) -> TorqueStep<PipeMotion> {
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
                let is_fast = false;
                TorqueStep {
                    torque,
                    speed,
                    state: PipeMotion { motion, is_fast },
                }
            }
            Self::Pipe(law) => law.meet(before, line),
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
