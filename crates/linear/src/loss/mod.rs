//! What takes energy from a string: its distributed damping, the viscosity of the mud in and
//! around it, and its material and joints. One description of all, evaluated at any complex
//! frequency, is owned by the string; a method that steps in time takes its poles.
//!
//! Torque per length and speed is c(s) = c_t + what mud takes, and the shear modulus G m(s):
//! γ² = s(c + sρJ)/(GJ m) takes the place of Eq. 2. Every part is that of something passive, so
//! that every response stays positive-real, and m(0) = 1 leaves statics as they are.
//!
//! Mud in the bore and in the annulus holds a fast vibration back by the square root of its frequency,
//! and both by 2πR³ √(ρμs) as if their walls were plane:
//!
//! ```
//! use linear::{Complex64, Drillstring, Hole, HoleSection, Material, Mud, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.054, outer_radius: 0.0635 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
//! let sections = vec![HoleSection { length: 1000.0, radius: 0.108 }];
//! let mud = Mud { density: 1200.0, viscosity: 0.03 };
//! let string = string.in_hole(Hole { sections, mud })?.with_loss_factor(1e-3)?;
//! let s = Complex64::new(0.0, 1e6);
//! let drag = string.loss().against_turning([0.054, 0.0635], Some(0.108), s);
//! let layers = (s * 1200.0 * 0.03).sqrt() * std::f64::consts::TAU;
//! let plane = layers * (0.054f64.powi(3) + 0.0635f64.powi(3));
//! assert!((drag / plane - 1.0).norm() < 1e-2);
//! // A material without loss is as stiff at rest, and turns by its loss factor elsewhere.
//! assert_eq!(string.loss().stiffening(Complex64::ZERO), Complex64::ONE);
//! let angle = string.loss().stiffening(Complex64::new(0.0, 100.0)).arg();
//! assert!((angle / 1e-3 - 1.0).abs() < 0.07);
//! # Ok::<(), linear::DrillstringError>(())
//! ```

mod bessel;
mod fit;
pub(crate) mod mud;
mod narrow;
#[cfg(test)]
mod reference;
mod relaxation;

use num_complex::Complex64;

use crate::surroundings::Mud;
pub use fit::Fit;
pub(crate) use fit::TERMS as MOST_OF_DRAG;
use mud::Annulus;
pub use relaxation::{Relaxation, sum};

/// What takes energy from a string.
#[derive(Debug, Clone, PartialEq)]
pub struct Loss {
    torsional_damping: f64,
    mud: Option<Mud>,
    loss_factor: f64,
    material: Vec<Relaxation>,
}

impl Loss {
    /// Of constant damping in torsion, c_t in N m s/rad per metre of string, alone.
    pub(crate) fn constant(torsional_damping: f64) -> Self {
        Self {
            torsional_damping,
            mud: None,
            loss_factor: 0.0,
            material: Vec::new(),
        }
    }

    /// The same with another constant damping, of the motion that the string is asked about.
    pub(crate) fn with_constant(self, torsional_damping: f64) -> Self {
        Self {
            torsional_damping,
            ..self
        }
    }

    /// The same with mud, which takes energy where it is viscous.
    pub(crate) fn with_mud(self, mud: Mud) -> Self {
        Self {
            mud: Some(mud).filter(|mud| mud.viscosity > 0.0),
            ..self
        }
    }

    /// The same with a material of a loss factor.
    pub(crate) fn with_loss_factor(self, loss_factor: f64) -> Self {
        let material = match loss_factor {
            0.0 => Vec::new(),
            factor => relaxation::ladder(factor),
        };
        Self {
            loss_factor,
            material,
            ..self
        }
    }

    /// Distributed torsional damping c_t (Eq. 1), N m s/rad per metre of string.
    pub fn torsional_damping(&self) -> f64 {
        self.torsional_damping
    }

    /// The loss factor η of the material with its joints: over 2π, the part of its energy that
    /// is lost in a cycle.
    pub fn loss_factor(&self) -> f64 {
        self.loss_factor
    }

    /// The mud, where it is viscous.
    pub fn viscous_mud(&self) -> Option<Mud> {
        self.mud
    }

    /// Whether it depends on frequency.
    pub fn has_memory(&self) -> bool {
        self.mud.is_some() || !self.material.is_empty()
    }

    /// Whether a string that vibrates in torsion loses energy until it stops.
    pub fn damps_torsion(&self) -> bool {
        self.torsional_damping > 0.0 || self.has_memory()
    }

    /// Torque per length and speed of rotation, c(s), N m s/rad per m, on a tube of these radii
    /// (internal and external, m) in a hole of a radius (m), at the Laplace variable `s` (rad/s, off
    /// the negative real axis).
    pub fn against_turning(&self, radii: [f64; 2], hole: Option<f64>, s: Complex64) -> Complex64 {
        let mud = self.annulus(radii, hole);
        mud.map_or(Complex64::ZERO, |mud| mud.against_turning(s)) + self.torsional_damping
    }

    /// Force per length and speed, N s/m per m, by which mud holds back a tube of these radii that
    /// moves across a hole of a radius (m), at the Laplace variable `s` (rad/s, off the negative real
    /// axis): the inertia of the mud around it is part of that, while the mud inside is mass.
    pub fn against_moving(&self, radii: [f64; 2], hole: Option<f64>, s: Complex64) -> Complex64 {
        let mud = self.annulus(radii, hole);
        mud.map_or(Complex64::ZERO, |mud| mud.against_moving(s))
    }

    /// The same of a tube that slides along its axis; what a closed end would push along the hole is
    /// left out.
    pub fn against_sliding(&self, radii: [f64; 2], hole: Option<f64>, s: Complex64) -> Complex64 {
        let mud = self.annulus(radii, hole);
        mud.map_or(Complex64::ZERO, |mud| mud.against_sliding(s))
    }

    /// What the moduli of the material are multiplied by, m(s), at the Laplace variable `s` (rad/s).
    pub fn stiffening(&self, s: Complex64) -> Complex64 {
        sum(&self.material, s) + 1.0
    }

    /// The relaxations of m(s) − 1, from the slowest on; none of a material without loss.
    pub fn relaxations(&self) -> &[Relaxation] {
        &self.material
    }

    /// The viscous mud in and around a tube of these radii, m, if it is in any.
    pub(crate) fn annulus(&self, [inner, outer]: [f64; 2], hole: Option<f64>) -> Option<Annulus> {
        let (mud, hole) = self.mud.zip(hole)?;
        Some(Annulus {
            viscosity: mud.viscosity,
            density: mud.density,
            inner,
            outer,
            hole,
        })
    }
}
