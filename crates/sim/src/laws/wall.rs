//! The borehole wall (Section 4.1, Eqs. 33–38 and 70–71): Hertzian or rigid, with
//! Coulomb friction that slides or rolls. How a step of it is solved is in `press`.
//!
//! Friction may fall with the speed v at which the surfaces slide, from μ_s to μ_d:
//! μ_d + (μ_s − μ_d) e^(−(v/v_s)²) (`friction_curve.rs`).
//!
//! A wall without friction takes back what it yields to, F_N = k_c (r − c)^(3/2):
//!
//! ```
//! use sim::laws::contact::{Approach, Spin, Touch};
//! use sim::{Sampling, Wall, WallLaw};
//!
//! let wall = Wall {
//!     clearance: 0.02,
//!     stiffness: 1e9,
//!     friction: 0.0,
//!     dynamic_ratio: 1.0,
//!     stribeck_speed: 0.0,
//!     radius: 0.1,
//! };
//! let approach = |distance: f64| Approach {
//!     free_position: [distance, 0.0],
//!     previous_position: [0.02, 0.0],
//!     previous_sliding_speed: None,
//!     last_force: [0.0; 2],
//!     present_position: None,
//!     compliance: 1e-7,
//!     spin: Spin { free_speed: 6.0, compliance: 1e-3, resistance: None },
//!     sampling: Sampling::new(1000.0, 0.0),
//! };
//! assert_eq!(wall.meet(&approach(0.0199))?.touch, Touch::Free);
//! let contact = wall.meet(&approach(0.021))?;
//! let [radius, _] = contact.position;
//! assert!((contact.normal_force / (1e9 * (radius - 0.02).powf(1.5)) - 1.0).abs() < 1e-6);
//! assert!((radius + 1e-7 * contact.normal_force - 0.021).abs() < 1e-9);
//! # Ok::<(), sim::laws::contact::ContactError>(())
//! ```

use super::friction_curve::{FrictionCurve, Shape};
use crate::ranges::{SceneError, not_negative, part, positive};

/// A place on the borehole wall, and the string there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wall {
    /// Clearance c between string and wall, m.
    pub clearance: f64,
    /// Hertzian stiffness k_c, N/m^(3/2); infinite for a rigid wall.
    pub stiffness: f64,
    /// Coefficient of friction μ; the static one, μ_s, where it falls.
    pub friction: f64,
    /// μ_d/μ_s: what is left of friction where the surfaces slide fast; 1 where it does not
    /// fall.
    pub dynamic_ratio: f64,
    /// v_s, m/s: the Stribeck speed, at which e⁻¹ of what μ_s is more than μ_d is left; zero
    /// where friction falls with the first slip.
    pub stribeck_speed: f64,
    /// Radius R₀ of the string, which friction turns, m.
    pub radius: f64,
}

impl Wall {
    /// Whether friction depends on the sliding speed.
    #[inline]
    pub(crate) fn falls(&self) -> bool {
        (0.0..1.0).contains(&self.dynamic_ratio)
    }

    /// μ_d.
    pub(super) fn dynamic_friction(&self) -> f64 {
        self.dynamic_ratio * self.friction
    }

    /// The most friction there is, in parts of the normal force, against surfaces that slide at
    /// a speed (m/s); that of rolling where it is not positive.
    pub fn friction_at(&self, speed: f64) -> f64 {
        if speed <= 0.0 {
            return self.friction;
        }
        self.curve().at(speed)
    }

    /// Whether surfaces slide at a speed (m/s) beyond that at which friction falls most.
    pub(super) fn is_fast(&self, speed: f64) -> bool {
        self.curve().is_fast(speed)
    }

    fn curve(&self) -> FrictionCurve {
        FrictionCurve {
            at_rest: self.friction,
            when_fast: self.dynamic_friction(),
            decay_speed: self.stribeck_speed,
            shape: Shape::Gaussian,
        }
    }

    pub(super) fn check_numbers(&self) -> Result<(), SceneError> {
        positive("clearance of a wall in m", self.clearance)?;
        not_negative("friction of a wall", self.friction)?;
        not_negative("Stribeck speed of a wall in m/s", self.stribeck_speed)?;
        part(
            "dynamic friction of a wall over the static one",
            self.dynamic_ratio,
        )?;
        not_negative("radius of the string at a wall in m", self.radius)?;
        if self.stiffness > 0.0 {
            return Ok(());
        }
        Err(SceneError::OutOfRange {
            quantity: "stiffness of a wall in N/m^1.5",
            value: self.stiffness,
            expected: "positive, or infinite for a rigid wall",
        })
    }
}
