//! Contact with a wall: what a step brings to a site, and what a law answers.
//!
//! A user-defined wall, rigid and without friction:
//!
//! ```
//! use sim::laws::contact::{Approach, Contact, ContactError, Spin, Touch};
//! use sim::{Sampling, WallLaw};
//!
//! struct Rigid(f64);
//!
//! impl WallLaw for Rigid {
//!     fn clearance(&self) -> f64 {
//!         self.0
//!     }
//!
//!     fn radius(&self) -> f64 {
//!         0.1
//!     }
//!
//!     fn meet(&self, approach: &Approach) -> Result<Contact, ContactError> {
//!         let [x, y] = approach.free_position;
//!         let distance = x.hypot(y);
//!         if distance <= self.0 {
//!             return Contact::free([x, y]);
//!         }
//!         let force = (distance - self.0) / approach.compliance;
//!         Ok(Contact {
//!             touch: Touch::Sliding,
//!             position: [x, y].map(|it| it * self.0 / distance),
//!             force: [x, y].map(|it| -it * force / distance),
//!             normal_force: force,
//!             ..Contact::NONE
//!         })
//!     }
//! }
//!
//! let approach = |free_position: [f64; 2]| Approach {
//!     free_position,
//!     previous_position: [0.0; 2],
//!     previous_sliding_speed: None,
//!     last_force: [0.0; 2],
//!     present_position: None,
//!     compliance: 1e-7,
//!     spin: Spin { free_speed: 6.0, compliance: 1e-3, resistance: None },
//!     sampling: Sampling::new(1000.0, 0.0),
//! };
//! assert!(!Rigid(0.05).meet(&approach([0.03, 0.03]))?.touches());
//! let contact = Rigid(0.05).meet(&approach([0.036, 0.048]))?;
//! assert!((contact.normal_force - 0.01 / 1e-7).abs() < 1e-6);
//! assert!((contact.position[0] - 0.03).abs() < 1e-12);
//! # Ok::<(), ContactError>(())
//! ```

use std::fmt::Debug;

use thiserror::Error;

use crate::ranges::SceneError;
use crate::sampling::Sampling;

/// What one step brings to a site, before contact.
#[derive(Debug, Clone, Copy)]
pub struct Approach<'a> {
    /// Displacement p_h without contact, m.
    pub free_position: [f64; 2],
    /// Position from which the site comes, at the end of the step before, m.
    pub previous_position: [f64; 2],
    /// Speed at which the surfaces slid in the step before, m/s, positive where the string's
    /// moved along e_θ; zero where it rolled, `None` where it did not touch.
    pub previous_sliding_speed: Option<f64>,
    /// Force of the wall as it was found last, in this step or the one before, N: a search may begin there.
    pub last_force: [f64; 2],
    /// Position under the force that it has so far, m, where sites are solved in turns: of several
    /// solutions the nearest to that is taken. `None`: the nearest to the previous position.
    pub present_position: Option<[f64; 2]>,
    /// h₀: displacement per force within the step, m/N.
    pub compliance: f64,
    /// How the site turns.
    pub spin: Spin<'a>,
    /// When in the step the law is met: at its end, or in its middle, by when the site has
    /// gone half of the way.
    pub sampling: Sampling,
}

/// How a site turns under the torque of friction within a step.
#[derive(Debug, Clone, Copy)]
pub struct Spin<'a> {
    /// Rotation speed without contact, rad/s.
    pub free_speed: f64,
    /// g₀: rotation speed per torque within the step, rad/s per N m.
    pub compliance: f64,
    /// What else resists, where the site is the bit and cuts: both laws then hold in
    /// one step (Eq. 36).
    pub resistance: Option<Resistance<'a>>,
}

/// A torque law at a site, as a wall there meets it.
#[derive(Clone, Copy)]
pub struct Resistance<'a> {
    /// From the speed, rad/s, that the site would have without the law to that with it.
    pub speed: &'a dyn Fn(f64) -> f64,
    /// What the speed may jump by, rad/s, for there it takes no value between.
    pub jump: f64,
}

impl Debug for Resistance<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Resistance")
            .field("jump", &self.jump)
            .finish_non_exhaustive()
    }
}

impl Approach<'_> {
    /// Where the site is at the end of the step, if it is at a position when the law is
    /// met, m.
    pub fn end_of_step(&self, position: [f64; 2]) -> [f64; 2] {
        (self.sampling).end_of_step(position, self.previous_position)
    }

    /// The force, N, that a site without a load may be pushed by before it reaches its wall.
    pub(crate) fn slack(&self, clearance: f64) -> f64 {
        let [x, y] = self.free_position;
        ((clearance - (x * x + y * y).sqrt()) / self.compliance).max(0.0)
    }
}

impl Spin<'_> {
    /// Rotation speed (rad/s) under a torque of friction (N m).
    #[inline]
    pub fn under(&self, torque: f64) -> f64 {
        let speed = self.free_speed + self.compliance * torque;
        match &self.resistance {
            None => speed,
            Some(resistance) => (resistance.speed)(speed),
        }
    }
}

/// A law of the wall at a site, which remembers nothing but what [`Approach`] says of the step
/// before. What is not given below has an answer by default that is right for every law.
pub trait WallLaw {
    /// How far the string's centre may be from the middle without contact, m.
    fn clearance(&self) -> f64;

    /// Radius R₀ of the string there, which friction turns, m.
    fn radius(&self) -> f64;

    /// Solves one step at one site.
    ///
    /// # Errors
    /// Where there is no answer in finite numbers.
    fn meet(&self, approach: &Approach) -> Result<Contact, ContactError>;

    /// The largest ratio of friction to normal force in rolling, where that alone decides whether
    /// rolling continues: whirl that has settled in rolling with less lasts, and a case may end
    /// early. `None` where something else decides, too.
    fn rolling_limit(&self) -> Option<f64> {
        None
    }

    /// Whether friction on what slides does not depend on its speed: whirl that has settled in
    /// sliding then lasts, where friction that falls may shake it ever more.
    fn slides_evenly(&self) -> bool {
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

/// How the surfaces meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Touch {
    /// Not at all.
    Free,
    /// Sliding.
    Sliding,
    /// Rolling without sliding.
    Rolling,
}

/// The answer of the wall in one step.
///
/// In this order, as numbers of two pairs that stand next to one another would be read as one, for which
/// the processor waits until both are in memory.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Contact {
    /// Position of the string's centre, m.
    pub position: [f64; 2],
    /// Normal force F_N ≥ 0, N.
    pub normal_force: f64,
    /// Force of the wall on the string, N.
    pub force: [f64; 2],
    /// Friction over normal force, α, positive along e_θ.
    pub friction_ratio: f64,
    /// Torque of friction on the string, N m.
    pub torque: f64,
    /// Speed at which the surfaces slide, m/s, for a law that asks for that of the step before.
    pub sliding_speed: f64,
    /// How the surfaces meet.
    pub touch: Touch,
    /// Whether other friction ratios would have solved the step too, and not what the site did
    /// before but how far it turns decided.
    pub ambiguous: bool,
}

impl Contact {
    /// At rest in the middle.
    pub const NONE: Contact = Contact {
        touch: Touch::Free,
        position: [0.0; 2],
        force: [0.0; 2],
        normal_force: 0.0,
        friction_ratio: 0.0,
        torque: 0.0,
        sliding_speed: 0.0,
        ambiguous: false,
    };
}

impl Contact {
    /// Whether it touches the wall.
    pub fn touches(&self) -> bool {
        self.touch != Touch::Free
    }

    /// A site at a position that does not reach the wall.
    ///
    /// # Errors
    /// Where the position is not finite.
    pub fn free(position: [f64; 2]) -> Result<Self, ContactError> {
        let [x, y] = position;
        if x * x + y * y == f64::INFINITY {
            return Err(ContactError::NotFinite);
        }
        Ok(Self {
            position,
            ..Self::NONE
        })
    }
}

/// A step in contact without an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ContactError {
    /// The position or the speed of the string would not be finite, or its square would not.
    #[error("the motion is not finite")]
    NotFinite,
    /// What was found does not obey the laws of contact to rounding: the wall or
    /// the responses are not what those of a string can be.
    #[error("no force of the wall solves the step")]
    Unsolved,
}
