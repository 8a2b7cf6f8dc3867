//! A torque at the bit: what a step leaves open, and what a law answers (Eqs. 16, 18).

use std::fmt::Debug;

use crate::ranges::SceneError;

/// What a step leaves open (Eq. 16): the bit's speed is
/// `free_speed + compliance × torque`, and a law says which torque.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadLine {
    /// Time of the step, s.
    pub time: f64,
    /// Speed without a torque in this step, rad/s.
    pub free_speed: f64,
    /// A(0): speed per torque within the step, rad/s per N m.
    pub compliance: f64,
}

/// The torque on the bit in one step, the speed it leaves, and what the law remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorqueStep<S> {
    /// Torque on the bit, positive in the direction of positive rotation, N m.
    pub torque: f64,
    /// Rotation speed of the bit, rad/s.
    pub speed: f64,
    /// The state after the step.
    pub state: S,
}

/// A law of the torque on the bit. A function of the load line that remembers nothing is
/// one too, and answers with the torque.
pub trait TorqueLaw {
    /// What it remembers from step to step, at rest by default.
    type State: Clone + Default + Debug;

    /// Meets the load line, the state before the step given. A step may be tried several
    /// times until contacts agree.
    fn meet(&self, before: &Self::State, line: LoadLine) -> TorqueStep<Self::State>;

    /// What it remembers of a bit that has been turning at a speed (rad/s), or at rest.
    fn turning_at(&self, _speed: f64) -> Self::State {
        Self::State::default()
    }

    /// How far the torque falls at most where the bit slips, N m: no speed between is
    /// one that it has.
    fn largest_drop(&self) -> f64 {
        0.0
    }

    /// Whether its numbers are such that it can be.
    ///
    /// # Errors
    /// Which is not.
    fn check(&self) -> Result<(), SceneError> {
        Ok(())
    }
}

impl<F: Fn(LoadLine) -> f64> TorqueLaw for F {
    type State = ();

    fn meet(&self, (): &(), line: LoadLine) -> TorqueStep<()> {
        let torque = self(line);
        TorqueStep {
            torque,
            speed: line.free_speed + line.compliance * torque,
            state: (),
        }
    }
}
