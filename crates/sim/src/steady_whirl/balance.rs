//! The balance of a rolling string at one surface speed: Re K(iω) + κ(ω), where
//! κ = k_c (r − c)^(3/2) / r at r = ΩR₀/ω. It is zero where whirl is steady; where it
//! is positive the string rolls at a slower surface speed, where negative at a
//! faster.

use crate::laws::wall::Wall;

/// The side of the wall of that balance.
#[derive(Debug, Clone, Copy)]
pub(super) struct Balance {
    pub surface_speed: f64,
    /// The rate of whirl that touches the wall without a force.
    fastest: f64,
    /// k_c √c, N/m.
    scale: f64,
}

impl Balance {
    pub fn new(wall: &Wall, surface_speed: f64) -> Self {
        Self {
            surface_speed,
            fastest: surface_speed * wall.radius / wall.clearance,
            scale: wall.stiffness * wall.clearance.sqrt(),
        }
    }

    /// κ, N/m: it falls with the rate to nothing at the fastest, and a rigid wall's is
    /// infinite before.
    pub fn inward(&self, rate: f64) -> f64 {
        let part = rate / self.fastest;
        if part >= 1.0 {
            return 0.0;
        }
        self.scale * (1.0 - part).powf(1.5) / part.sqrt()
    }

    /// dκ/dω, which rises to nothing there.
    pub fn inward_slope(&self, rate: f64) -> f64 {
        let part = rate / self.fastest;
        if part >= 1.0 {
            return 0.0;
        }
        -self.scale / self.fastest * (1.0 - part).sqrt() * (0.5 + part) / part.powf(1.5)
    }

    /// Whether it is positive all the way between two rates, where Re K is in a range.
    pub fn is_positive(&self, [least, _]: [f64; 2], [_, high]: [f64; 2]) -> bool {
        // Faster than the fastest rate no string rolls at this speed or a slower one.
        high <= self.fastest && least + self.inward(high) > 0.0
    }

    /// Whether it is negative all the way between two rates, where Re K is in a range.
    pub fn is_negative(&self, [_, greatest]: [f64; 2], [low, _]: [f64; 2]) -> bool {
        greatest + self.inward(low) < 0.0
    }
}
