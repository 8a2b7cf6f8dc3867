//! A string that stretches. EA u″ = ρA ü + c_a u̇ is the equation of torsion (Eq. 1) with EA for GJ
//! and ρA for ρJ, so everything that this crate answers of a string that twists it answers of one
//! that stretches, by the same waves, lattice and elements: forces (N) for torques, speeds along
//! the string (m/s) for rotation speeds, an impedance A √(Eρ) for J √(Gρ). [`Axial::rod`] gives
//! that string.
//!
//! ```
//! use linear::axial::Axial;
//! use linear::estimates::{torsional_impedance, torsional_stiffness};
//! use linear::{Drillstring, Material, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 2000.0, inner_radius: 0.054, outer_radius: 0.0635 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
//! let rod = Axial { youngs_modulus: 210e9, damping: 0.0, hoist: None }.rod(&string)?;
//! // Force per length that it is stretched by, EA/L, and per speed of an end, A √(Eρ).
//! assert!((torsional_stiffness(&rod) / (210e9 * pipe.area() / 2000.0) - 1.0).abs() < 1e-12);
//! assert_eq!(torsional_impedance(&rod, &pipe).round(), 142_292.0);
//! # Ok::<(), linear::DrillstringError>(())
//! ```

use crate::drillstring::{Drillstring, positive};
use crate::error::DrillstringError;
use crate::top_drive::TopDrive;

/// What axial motion needs to know of a string, beyond what torsion does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axial {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Distributed axial damping c_a, N s/m per metre of string.
    pub damping: f64,
    /// What the string hangs from; where there is none, its upper end moves as prescribed.
    pub hoist: Option<Hoist>,
}

/// What the upper end of a string hangs from, as it answers the string's motion. A force F on the
/// string is that of a set speed F/c, where no spring holds it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hoist {
    /// What moves with the upper end, kg.
    pub mass: f64,
    /// Force per speed that it opposes, c, N s/m.
    pub damping: f64,
    /// Force per displacement that it opposes, N/m; zero where a force is set.
    pub stiffness: f64,
}

impl Axial {
    /// The string as a rod that stretches. Its top drive is the hoist: a mass for its inertia, c
    /// for the proportional gain, and the stiffness for the integral gain.
    ///
    /// # Errors
    /// Where a constant is not what a real string can have.
    pub fn rod(&self, string: &Drillstring) -> Result<Drillstring, DrillstringError> {
        positive("Young's modulus", self.youngs_modulus)?;
        if !(self.damping.is_finite() && self.damping >= 0.0) {
            return Err(DrillstringError::NegativeAxialDamping {
                value: self.damping,
            });
        }
        let hoist = self.hoist.map(Hoist::as_drive).transpose()?;
        Ok(string.stretching(self.youngs_modulus, self.damping, hoist))
    }
}

impl Hoist {
    fn as_drive(self) -> Result<TopDrive, DrillstringError> {
        let numbers = [
            ("mass", self.mass),
            ("damping", self.damping),
            ("stiffness", self.stiffness),
        ];
        for (quantity, value) in numbers {
            if !(value.is_finite() && value >= 0.0) {
                return Err(DrillstringError::Hoist { quantity, value });
            }
        }
        if self.damping + self.stiffness == 0.0 {
            return Err(DrillstringError::NothingHolds);
        }
        Ok(TopDrive {
            inertia: self.mass,
            proportional_gain: self.damping,
            integral_gain: self.stiffness,
            delay: 0.0,
            late_inertia: 0.0,
        })
    }
}
