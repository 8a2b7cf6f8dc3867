//! What one case contains.

use crate::duration::Timing;
use crate::laws::bit::BitTorque;

/// One case, from rest: the surface starts to turn at t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scene {
    /// Surface rotation speed Ω from t = 0 on, rad/s.
    pub surface_speed: f64,
    /// Torque at the bit; `None` leaves it free.
    pub bit: Option<BitTorque>,
    /// Time simulated and closing window.
    pub timing: Timing,
}
