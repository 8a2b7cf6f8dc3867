//! A torque at the bit: what a step leaves open, and what a law answers (Eqs. 16, 18).
//!
//! A function of the load line is a law: this one is viscous, T = −b ω.
//!
//! ```
//! use sim::{LoadLine, TorqueLaw};
//!
//! let (viscous, compliance) = (30.0, 0.01);
//! let law = |line: LoadLine| -viscous * line.free_speed / (1.0 + viscous * line.compliance);
//! let step = law.meet(&(), LoadLine { time: 0.0, free_speed: 6.5, compliance });
//! assert!((step.speed - 5.0).abs() < 1e-12);
//! assert!((step.torque + viscous * step.speed).abs() < 1e-9);
//! ```

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

/// What a torque leaves of a free speed by rounding, in parts of it.
const ROUNDING: f64 = 1e-14;

impl LoadLine {
    /// The speed that a torque (N m) leaves, rad/s; zero where it takes all of it but for rounding.
    pub fn speed_under(&self, torque: f64) -> f64 {
        let speed = self.free_speed + self.compliance * torque;
        match speed.abs() <= ROUNDING * self.free_speed.abs() {
            true => 0.0,
            false => speed,
        }
    }
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

/// How a bit, or a piece of pipe, turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BitMotion {
    /// Held by the rock, as at the first instant.
    #[default]
    Stuck,
    /// Turning with the surface (positive) speed.
    Forward,
    /// Turning against it.
    Backward,
}

impl BitMotion {
    /// That of a speed, rad/s.
    pub fn of(speed: f64) -> Self {
        match speed {
            0.0 => Self::Stuck,
            _ if speed > 0.0 => Self::Forward,
            _ => Self::Backward,
        }
    }
}

/// A law of the torque on the bit. A function of the load line that remembers nothing is
/// one too, and answers with the torque.
///
/// All but [`TorqueLaw::meet`] have answers by default, which are right for every law: cases are
/// then stepped from their start to their end. A law that says more of itself has cases that
/// begin at the first slip and end early, with the same labels.
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

    /// How the bit turned in a step: regimes follow from when it is stuck. By default it is where
    /// its speed is zero. Of a law in which nothing ever stands quite still, such as friction that
    /// is smoothed about zero, no case would be stick-slip: it says below which speed the bit
    /// counts as stuck.
    fn motion(&self, step: &TorqueStep<Self::State>) -> BitMotion {
        BitMotion::of(step.speed)
    }

    /// T_s, N m: a bit that has been at rest since the beginning stays at rest as long as no more
    /// is needed for that, and no longer. Until the string has wound up to it nothing has to be
    /// stepped. `None` where that is not all that decides.
    fn holds(&self) -> Option<f64> {
        None
    }

    /// Whether a bit that turns one way meets the same torque at any speed: what a bit does that
    /// never stops again is then known.
    fn is_constant_in_slip(&self) -> bool {
        false
    }

    /// Whether the torque follows from the motion alone, and from no more of that than the last
    /// cycle of stick-slip: not from the time. Motion that repeats itself then continues to, and a
    /// case may end early.
    fn is_autonomous(&self) -> bool {
        false
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
            speed: line.speed_under(torque),
            state: (),
        }
    }
}
