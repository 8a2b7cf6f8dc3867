//! The string in bending reduced to its sites (Eqs. 50–58): forces in,
//! displacements out, no external moments.
//!
//! The tip of a cantilever yields with 3EI/L³ where it moves slowly:
//!
//! ```
//! use linear::waves::lateral::BendingNetwork;
//! use linear::{Bending, Drillstring, Material, Section, Sites, SurfaceSupport, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 3, parts: vec![pipe] }], 0.0)?;
//! let bending = Bending { youngs_modulus: 210e9, damping: 0.0, compression: 0.0 };
//! let network = BendingNetwork::new(&string, bending, SurfaceSupport::Clamped, &Sites::bit())?;
//! let [stiffness, _] = network.dynamic_stiffness(0, 1e-4);
//! let expected = 3.0 * 210e9 * pipe.second_moment() / 30f64.powi(3);
//! assert!((stiffness / expected - 1.0).abs() < 1e-4);
//! # Ok::<(), linear::DrillstringError>(())
//! ```

use num_complex::Complex64;

use super::bending::{Resistance, endless, uniform};
use crate::assembly::bending::{Beam, at_sites, moments, reduce};
use crate::assembly::chain::hanging;
use crate::assembly::matrix::ResponseMatrix;
use crate::assembly::number::Number;
use crate::bending::{Bending, SurfaceSupport};
use crate::channel::Channel;
use crate::distributed_loss::{Interpolated, LossAlong};
use crate::drillstring::{Drillstring, Tube};
use crate::error::DrillstringError;
use crate::sites::{AtSite, Sites, SitesAndPlaces};
use crate::spans::SurroundedSpan;
use crate::surroundings::Surroundings;

/// A string cut at its sites once, to be evaluated at many frequencies.
#[derive(Debug, Clone)]
pub struct BendingNetwork<'a> {
    string: &'a Drillstring,
    bending: Bending,
    support: SurfaceSupport,
    spans: Vec<SurroundedSpan>,
    /// Spring and mass at each site besides the string.
    at_sites: Vec<AtSite>,
    loss: LossAlong<Interpolated>,
}

impl<'a> BendingNetwork<'a> {
    /// Cuts the string at the sites.
    ///
    /// # Errors
    /// Where these are not places of this string, or it cannot bend as `bending`
    /// says.
    pub fn new(
        string: &'a Drillstring,
        bending: Bending,
        support: SurfaceSupport,
        sites: &Sites,
    ) -> Result<Self, DrillstringError> {
        bending.check()?;
        let spans = string.surrounded_spans(Channel::Bending, sites)?;
        Ok(Self {
            string,
            bending,
            support,
            loss: LossAlong::exact(string, Channel::Bending, &spans),
            spans,
            at_sites: sites.loads(),
        })
    }

    /// The string below the uppermost of the sites, which holds it without displacement and lets it
    /// turn, cut at the others.
    ///
    /// # Errors
    /// As [`BendingNetwork::new`].
    pub fn below_uppermost(
        string: &'a Drillstring,
        bending: Bending,
        sites: &Sites,
    ) -> Result<Self, DrillstringError> {
        let mut below = Self::new(string, bending, SurfaceSupport::Pinned, sites)?;
        below.spans.remove(0);
        below.at_sites.remove(0);
        Ok(below)
    }

    /// The receptance at an angular frequency (rad/s, not zero).
    pub fn at_rate(&self, rate: f64) -> ResponseMatrix {
        self.receptance(Complex64::new(0.0, rate))
    }

    /// Dynamic stiffness at one site, the others free, at an angular frequency (rad/s,
    /// not zero): real and imaginary part of the force per displacement there, N/m.
    pub fn dynamic_stiffness(&self, site: usize, rate: f64) -> [f64; 2] {
        let stiffness = self.at_rate(rate)[(site, site)].inv();
        [stiffness.re, stiffness.im]
    }

    /// Displacement at each site (row) per unit force at each site (column) at
    /// the Laplace variable `s` (rad/s, not zero): D⁽ᵇ⁾ of Eq. 57, m/N.
    pub fn receptance<T: Number>(&self, s: T) -> ResponseMatrix<T> {
        let at_sites = at_sites(&self.at_sites, s * s);
        reduce(self.pieces(s), &at_sites, self.support)
    }

    /// Bending moment at each of some places (row) per unit force at each site (column), N m/N, of a
    /// string cut at both, at the Laplace variable `s` (rad/s, not zero).
    pub(crate) fn moments<T: Number>(&self, s: T, cut: &SitesAndPlaces) -> Vec<T> {
        let at_sites = at_sites(&self.at_sites, s * s);
        moments(self.pieces(s), &at_sites, self.support, cut)
    }

    fn pieces<T: Number>(&self, s: T) -> impl Iterator<Item = Option<Beam<T>>> {
        let loss = self.loss.at(|| s);
        let tube = move |around: Surroundings, tube: &Tube| {
            let bending = self.bending.under(around.tension);
            let foundation = match loss.drag_on(tube, around.hole_radius) {
                None => {
                    let mass = self.string.mass_sideways(tube, around.hole_radius);
                    s * (s * mass + bending.damping)
                }
                // Its inertia is part of its drag.
                Some(mud) => {
                    let mass = self.string.mass_with_bore(tube);
                    s * (s * mass + mud + bending.damping)
                }
            };
            let resistance = Resistance {
                foundation,
                stiffening: loss.stiffening(),
            };
            endless(&bending, tube, resistance)
                .unwrap_or_else(|| uniform(&bending, tube, resistance))
        };
        hanging(&self.spans, tube)
    }
}

#[cfg(test)]
mod tests {
    use numerics::{Mat, equations};

    use super::*;
    use crate::validation::academic;

    /// Springs and masses of stiffness K on receptances D without them leave (1 + D K)⁻¹ D.
    #[test]
    fn sites_with_springs_and_masses_answer_as_those_without_and_these_do() {
        let string = academic::string();
        let bending = Bending {
            youngs_modulus: 210e9,
            damping: 200.0,
            compression: 5e4,
        };
        let sites = Sites::new(&string, &[120.0, 33.0, 0.0]).unwrap();
        let springs = [2e4, 0.0, 3e5];
        let masses = [0.0, 300.0, 80.0];
        let held = sites.clone().held_by(springs.to_vec()).unwrap();
        let held = held.carrying(masses.to_vec()).unwrap();
        for support in [
            SurfaceSupport::Free,
            SurfaceSupport::Pinned,
            SurfaceSupport::Clamped,
        ] {
            let network =
                |sites: &Sites| BendingNetwork::new(&string, bending, support, sites).unwrap();
            for rate in [0.3, 5.0, 90.0] {
                let s = Complex64::new(1.0, rate);
                let (found, free) = (network(&held).receptance(s), network(&sites).receptance(s));
                let left = Mat::from_fn(3, 3, |row, column| {
                    let own = if row == column { 1.0 } else { 0.0 };
                    free[(row, column)] * (s * s * masses[column] + springs[column]) + own
                });
                let right = Mat::from_fn(3, 3, |row, column| free[(row, column)]);
                let expected = equations::solve_complex(&left, &right);
                for row in 0..3 {
                    for column in 0..3 {
                        let apart = found[(row, column)] - expected[(row, column)];
                        let size = expected[(column, column)].norm();
                        assert!(
                            apart.norm() < 1e-9 * size,
                            "{support:?} {rate} {row} {column}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn springs_and_masses_of_other_sites_or_below_zero_are_refused() {
        let held = |springs: &[f64]| Sites::bit().held_by(springs.to_vec());
        let carrying = |masses: &[f64]| Sites::bit().carrying(masses.to_vec());
        assert!(held(&[1e5]).is_ok() && carrying(&[1e3]).is_ok());
        for numbers in [&[][..], &[1.0, 2.0], &[-1.0], &[f64::NAN], &[f64::INFINITY]] {
            assert!(
                held(numbers).is_err() && carrying(numbers).is_err(),
                "{numbers:?}"
            );
        }
    }
}
