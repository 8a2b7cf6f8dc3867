//! Stress in a tube under tension, bending and torque.
//!
//! ```text
//! σ_b = M R/I        τ = T_q R/J        σ_vM = √((|T/A| + σ_b)² + 3 τ²)
//! ```
//!
//! at its outer surface. With the effective tension T the hydrostatic part of the stress drops out,
//! exactly so where the pressure is the same inside and outside.

use crate::drillstring::Tube;

/// Stress at the outer surface of a tube, Pa.
///
/// ```
/// use linear::{Stress, Tube};
///
/// let collar = Tube { length: 9.0, inner_radius: 0.0357, outer_radius: 0.1016 };
/// let stress = Stress::new(&collar, -100e3, 50e3, 0.0);
/// assert!((stress.axial * collar.area() + 100e3).abs() < 1e-6);
/// // Pushed and bent: most on the inside of the bend.
/// assert_eq!(stress.von_mises, stress.bending - stress.axial);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stress {
    /// Of the effective tension alone.
    pub axial: f64,
    /// Of bending. In a string that turns it alternates once a turn, which fatigues it.
    pub bending: f64,
    /// Of torque.
    pub shear: f64,
    /// Von Mises, the greatest around the tube, for the same pressure inside and outside.
    pub von_mises: f64,
}

impl Stress {
    /// Of a tube under an effective tension (N), a bending moment and a torque (N m).
    pub fn new(tube: &Tube, tension: f64, moment: f64, torque: f64) -> Self {
        let axial = tension / tube.area();
        let bending = moment.abs() * tube.outer_radius / tube.second_moment();
        let shear = torque.abs() * tube.outer_radius / tube.polar_moment();
        let along = axial.abs() + bending;
        Self {
            axial,
            bending,
            shear,
            von_mises: match shear {
                0.0 => along,
                _ => along.hypot(3f64.sqrt() * shear),
            },
        }
    }
}
