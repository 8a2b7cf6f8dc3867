//! What one case contains.

use crate::duration::Timing;
use crate::excitation::{EccentricMass, Impulse};
use crate::laws::bit::BitTorque;
use crate::laws::wall::Wall;

/// One case, from rest: the surface starts to turn at t = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Surface rotation speed Ω from t = 0 on, rad/s.
    pub surface_speed: f64,
    /// Torque at the bit; `None` leaves it free.
    pub bit: Option<BitTorque>,
    /// Lateral motion, where it is modelled.
    pub lateral: Option<Lateral>,
    /// Time simulated and closing window.
    pub timing: Timing,
}

/// The lateral part of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Lateral {
    /// The borehole wall at each site, from the surface down.
    pub walls: Vec<Wall>,
    /// Disturbances.
    pub impulses: Vec<Impulse>,
    /// Eccentric masses.
    pub eccentric_masses: Vec<EccentricMass>,
}
