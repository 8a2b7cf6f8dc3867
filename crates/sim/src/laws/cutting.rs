//! A bit whose blades cut what the blades before have left: torque and weight follow from the depth
//! of cut, and this from where the bit was one blade earlier.
//!
//! With U the depth of the bit and S(θ) that of the rock which the last blade left at the angle θ,
//! a blade cuts δ = U − S(φ − α) deep. The rock holds against that
//!
//! T = k_t δ⁺ + β W_f,  W = k_a δ⁺ + W_f,  k_t = ½ ε a² n,  k_a = ζ ε a n,  β = ½ μγ a,
//!
//! with the parameters of the rock law of E. Detournay, T. Richard and M. Shepherd ([`CuttingLaw`]),
//! so that steady drilling is that law, weight and torque an answer instead of given. The wear
//! flats carry all they can, W_m, while the bit goes down, nothing while it rises, and as much as
//! holds it where it rests. Off bottom nothing acts. Regenerative cutting is that of T. Richard, C.
//! Germay and E. Detournay, "A simplified model to explore the root cause of stick-slip vibrations
//! in drilling systems with drag bits", *Journal of Sound and Vibration* 305 (2007) 432–456, with
//! two repairs: what is left is the deepest cut so far, S ← max(U, S(φ − α)), as no rock grows back
//! under a bit that bounces; and relief bounds the advance per angle, so that a bit that stands
//! still does not sink in.
//!
//! Steady drilling is the law of the rock:
//!
//! ```
//! use sim::laws::rock::CuttingLaw;
//! use sim::{Blades, Cutting, FlatContact, Rock};
//!
//! let Rock::Law(rock) = Rock::sandstone() else { unreachable!() };
//! let bit = Cutting {
//!     rock,
//!     contact: FlatContact::Grows,
//!     blades: Blades::Even(6),
//!     relief: 15f64.to_radians().tan(),
//! };
//! let depth_of_cut = bit.steady_depth_of_cut(60e3);
//! let [torque, weight] = bit.steady(depth_of_cut);
//! assert!((weight / 60e3 - 1.0).abs() < 1e-12);
//! assert!((torque / Rock::sandstone().torque_dynamic(60e3)? - 1.0).abs() < 1e-12);
//! // Six blades a turn, and a bit that turns twice a second.
//! let rate = bit.steady_rate(60e3, 2.0 * std::f64::consts::TAU);
//! assert!((rate / (12.0 * depth_of_cut) - 1.0).abs() < 1e-12);
//! # Ok::<(), sim::laws::rock::RockError>(())
//! ```
//!
//! A step (speeds held over it, the law met where they are) leaves two load lines, ω = ω_h − A_t T
//! and v = v_h − A_a W. At a given ω one v meets W(v), which grows: the axial part is a law for
//! itself. What is left is one equation in ω, continuous and piecewise linear.

mod advance;
mod face;
mod forces;
mod step;
#[cfg(test)]
mod tests;

pub use face::Face;

use super::rock::CuttingLaw;
use crate::ranges::{SceneError, positive};
pub use advance::AxialLine;
use advance::Grip;
pub use face::MOST_PROFILES;
pub(crate) use forces::CuttingForces;
pub use step::{BitPlace, CutStep};

/// A bit that cuts.
#[derive(Debug, Clone, PartialEq)]
pub struct Cutting {
    /// The rock, and the bit's radius and wear.
    pub rock: CuttingLaw,
    /// When the wear flats carry weight.
    pub contact: FlatContact,
    /// The blades.
    pub blades: Blades,
    /// λ/a: tangent of the angle of relief behind the cutters, by which they sink at most; infinite
    /// where nothing bounds that.
    pub relief: f64,
}

/// When the wear flats carry weight.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FlatContact {
    /// In proportion to the depth of cut, by the contact growth of the rock, up to their strength.
    Grows,
    /// All at once.
    AtOnce,
}

/// The blades of a bit.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Blades {
    /// A number of them, evenly spaced.
    Even(usize),
    /// The angle from each to the next, rad; 2π together.
    Uneven(Vec<f64>),
}

impl Cutting {
    /// Checks that there is such a bit.
    pub(crate) fn check(&self) -> Result<(), SceneError> {
        let rock = &self.rock;
        positive("radius of the bit in m", rock.bit_radius)?;
        positive("specific energy of the rock in Pa", rock.specific_energy)?;
        positive("cutting ratio of the rock", rock.cutting_ratio)?;
        positive("contact growth of the rock", rock.contact_growth)?;
        if self.relief != f64::INFINITY {
            positive("tangent of the relief angle", self.relief)?;
        }
        crate::ranges::not_negative("friction of the wear flats", rock.friction)?;
        crate::ranges::not_negative("contact strength in Pa", rock.contact_strength)?;
        crate::ranges::not_negative("wear flat in m", rock.wear_flat)?;
        match &self.blades {
            Blades::Even(0) => Err(SceneError::NoBlades),
            Blades::Even(_) => Ok(()),
            Blades::Uneven(angles) => {
                let turn: f64 = angles.iter().sum();
                let is_turn = (turn / std::f64::consts::TAU - 1.0).abs() < 1e-6;
                let is_few = angles.len() <= MOST_PROFILES;
                match is_turn && is_few && angles.iter().all(|angle| *angle > 0.0) {
                    true => Ok(()),
                    false => Err(SceneError::BladeAngles),
                }
            }
        }
    }

    /// Number of blades.
    pub fn blades(&self) -> usize {
        match &self.blades {
            Blades::Even(count) => *count,
            Blades::Uneven(angles) => angles.len(),
        }
    }

    /// Angles from each blade to the one before, rad: one for all where they are even.
    pub fn blade_angles(&self) -> Vec<f64> {
        match &self.blades {
            Blades::Even(count) => vec![std::f64::consts::TAU / *count as f64],
            Blades::Uneven(angles) => angles.clone(),
        }
    }

    /// k_t, k_a (N m and N per m of depth of cut of all blades).
    fn stiffnesses(&self) -> [f64; 2] {
        let (rock, blades) = (&self.rock, self.blades() as f64);
        let cut = rock.specific_energy * rock.bit_radius * blades;
        [0.5 * cut * rock.bit_radius, rock.cutting_ratio * cut]
    }

    /// k_c, N/m, and the most that the flats carry, N.
    fn flats(&self) -> [f64; 2] {
        let rock = &self.rock;
        let strength = rock.bit_radius * rock.contact_strength;
        let growth = match self.contact {
            FlatContact::Grows => strength * rock.contact_growth * self.blades() as f64,
            FlatContact::AtOnce => f64::INFINITY,
        };
        [growth, strength * rock.wear_flat]
    }

    /// β, m.
    fn flat_radius(&self) -> f64 {
        0.5 * self.rock.friction * self.rock.bit_radius
    }

    /// Torque (N m) and weight (N) of steady drilling at a depth of cut of each blade, m.
    pub fn steady(&self, depth_of_cut: f64) -> [f64; 2] {
        let ([torque, weight], [growth, most]) = (self.stiffnesses(), self.flats());
        let flat = (growth * depth_of_cut).min(most);
        [
            torque * depth_of_cut + self.flat_radius() * flat,
            weight * depth_of_cut + flat,
        ]
    }

    /// The depth of cut of each blade (m) at which steady drilling takes a weight, N; zero where the
    /// flats carry it all.
    pub fn steady_depth_of_cut(&self, weight: f64) -> f64 {
        let ([_, stiffness], [growth, most]) = (self.stiffnesses(), self.flats());
        let first = weight / (stiffness + growth);
        match growth * first <= most {
            true => first,
            false => ((weight - most) / stiffness).max(0.0),
        }
    }

    /// Rate of penetration of steady drilling under a weight (N) at a speed (rad/s), m/s.
    pub fn steady_rate(&self, weight: f64, speed: f64) -> f64 {
        let advance = self.steady_depth_of_cut(weight) * self.blades() as f64;
        advance / std::f64::consts::TAU * speed
    }

    /// Torque and weight per depth of cut (N m/m, N/m), of all blades, as small motion about a
    /// steady depth of cut (m) feels them: with the flats while what they carry grows.
    pub fn steady_stiffnesses(&self, depth_of_cut: f64) -> [f64; 2] {
        let ([torque, weight], [growth, most]) = (self.stiffnesses(), self.flats());
        match growth * depth_of_cut < most {
            true => [torque + self.flat_radius() * growth, weight + growth],
            false => [torque, weight],
        }
    }

    pub(crate) fn forces(&self) -> CuttingForces {
        let ([torque, weight], [growth, most]) = (self.stiffnesses(), self.flats());
        CuttingForces {
            torque,
            flat_radius: self.flat_radius(),
            relief: self.relief * self.rock.bit_radius,
            grip: Grip {
                weight,
                growth,
                most,
            },
            angles: self.blade_angles(),
        }
    }

    /// The face of a bit that starts: the rock flat, or, in steady drilling, by its advance per angle
    /// (m/rad).
    pub(crate) fn face(&self, advance: f64) -> Face {
        Face::new(self.blade_angles(), advance)
    }
}
