//! The borehole wall (Section 4.1, Eqs. 33–38 and 70–71): Hertzian or rigid, with
//! Coulomb friction that slides or rolls. How a step of it is solved is in `press`.

use crate::ranges::{SceneError, not_negative, positive};

/// A place on the borehole wall, and the string there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wall {
    /// Clearance c between string and wall, m.
    pub clearance: f64,
    /// Hertzian stiffness k_c, N/m^(3/2); infinite for a rigid wall.
    pub stiffness: f64,
    /// Coefficient of friction μ.
    pub friction: f64,
    /// Radius R₀ of the string, which friction turns, m.
    pub radius: f64,
}

impl Wall {
    pub(super) fn check_numbers(&self) -> Result<(), SceneError> {
        positive("clearance of a wall in m", self.clearance)?;
        not_negative("friction of a wall", self.friction)?;
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
