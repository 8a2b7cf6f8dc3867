//! A string that lies on the low side of its hole, as it does at rest. The linear string knows
//! only differences, so a case is stepped from there: what moves it is by how much the forces at
//! its walls differ from those that hold it,
//!
//! ```text
//! u(k) = u_s + Σ A(k − n) (F(n) − F_s) .
//! ```
//!
//! The laws of the walls are met by all of F, so that nothing moves that is not pushed. It may also
//! turn steadily there, sliding on its walls, whose friction then tilts their forces and holds it
//! back: what turns it is by how much these torques differ.
//!
//! A string at rest on two rigid walls, which bear 300 N each:
//!
//! ```
//! use sim::Lying;
//!
//! let lying = Lying {
//!     positions: vec![[-0.02, 0.0]; 2],
//!     forces: vec![[300.0, 0.0]; 2],
//!     torques: vec![0.0; 2],
//!     low_side: vec![std::f64::consts::PI; 2],
//! };
//! assert_eq!(lying.forces.len(), 2);
//! ```

use crate::ranges::{SceneError, finite};

/// How a string lies in its hole at rest, at each site that has a wall, from the surface down.
#[derive(Debug, Clone, PartialEq)]
pub struct Lying {
    /// Where it is, m from the middle of the hole.
    pub positions: Vec<[f64; 2]>,
    /// The force of the wall on it there, N: what its law gives at that position.
    pub forces: Vec<[f64; 2]>,
    /// The torque of the wall's friction on it there, N m; zero of a string that does not turn, or
    /// that friction meets as the case begins.
    pub torques: Vec<f64>,
    /// The direction in which its weight pulls, rad from the x axis.
    pub low_side: Vec<f64>,
}

impl Lying {
    /// Checks that it is a string at this number of walls.
    pub(crate) fn check(&self, walls: usize) -> Result<(), SceneError> {
        let counts = [self.positions.len(), self.forces.len(), self.low_side.len()];
        if let Some(&found) = counts.iter().find(|&&count| count != walls) {
            return Err(SceneError::LyingAtOtherWalls { found, walls });
        }
        for position in self.positions.iter().flatten() {
            finite("position of a string at rest in m", *position)?;
        }
        for force in self.forces.iter().flatten() {
            finite("force of a wall on a string at rest in N", *force)?;
        }
        for torque in &self.torques {
            finite("torque of a wall on a string that slides in N m", *torque)?;
        }
        let mut directions = self.low_side.iter();
        directions.try_for_each(|it| finite("direction of the low side in rad", *it))
    }
}
