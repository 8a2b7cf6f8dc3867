//! Where the string may touch its hole, and what answers there.

use crate::error::{StaticsError, not_negative, positive};

/// A place where the string may touch its hole, all around.
///
/// ```
/// use statics::Contact;
///
/// // The blades of a stabiliser 1/16 in under gauge, in soft rock.
/// let blades = Contact {
///     distance_from_bit: 15.625,
///     clearance: 1.5875e-3,
///     radius: 0.15399,
///     stiffness: Some(1e9),
/// };
/// assert!(blades.clearance < blades.radius);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Distance from the bit, m.
    pub distance_from_bit: f64,
    /// How far the string can move from the middle of its hole until it touches, m.
    pub clearance: f64,
    /// Radius with which it touches, m: friction there has this lever.
    pub radius: f64,
    /// Hertzian stiffness k_c of the wall, N/m^1.5: pressed in by d it answers with k_c d^1.5. None
    /// of a rigid wall.
    pub stiffness: Option<f64>,
}

impl Contact {
    pub(crate) fn check(&self, length: f64) -> Result<(), StaticsError> {
        let distance = self.distance_from_bit;
        if !(distance >= 0.0 && distance <= length) {
            return Err(StaticsError::OffString { distance, length });
        }
        positive("a clearance in m", self.clearance)?;
        not_negative("a radius in m", self.radius)?;
        match self.stiffness {
            Some(stiffness) => positive("a stiffness in N/m^1.5", stiffness),
            None => Ok(()),
        }
    }
}
