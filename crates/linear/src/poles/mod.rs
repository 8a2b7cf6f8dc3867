//! Bending of a string by poles that all its sites share, for strings that touch their hole at many.
//!
//! Finite elements with the states of all that fades, projected onto few shapes, are as passive as the
//! elements: where q are coordinates in which the energy is ½qᵀq, q̇ = (J − R) q + B f with J skew and R not
//! negative, and the speeds of the sites are Bᵀq. Each eigenvalue of J − R is a pole, which forces that are
//! held over a step excite exactly as they do in the whole string. What is stepped is a number for each
//! pole, where responses between N sites are N² series of taps.
//!
//! ```
//! use linear::{Bending, BendingPoles, Budget, ChannelRequest, Drillstring, Material, Method, Request};
//! use linear::{PolePlan, Section, Sites, SurfaceSupport, Tube, responses};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 4, parts: vec![pipe] }], 0.02)?;
//! let bending = Bending { youngs_modulus: 210e9, damping: 100.0, compression: 0.0 };
//! let bends = (&bending, SurfaceSupport::Clamped);
//! let sites = Sites::new(&string, &[15.0, 0.0])?;
//! let poles: BendingPoles = PolePlan::new(&string, bends, &sites, 200.0)?.build(&Budget::unlimited())?;
//! assert!(poles.margin() > -1e-9);
//!
//! let request = Request {
//!     channels: vec![ChannelRequest::Bending { bending, support: SurfaceSupport::Clamped }],
//!     sampling_frequency: 200.0,
//!     longest_time: 1.0,
//!     sites,
//! };
//! let held = responses(&string, &Method::Held, &request)?;
//! let expected = held.bending().and_then(|it| it.taps_between(1, 1)).unwrap_or_default();
//! let largest = expected.iter().fold(0.0f64, |most, tap| most.max(tap.abs()));
//! let found = poles.taps(1, 1, expected.len());
//! assert!(found.iter().zip(expected).all(|(one, other)| (one - other).abs() < 5e-3 * largest));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod elements;
mod passive;
mod plan;
mod projection;
mod rates;
mod shapes;

pub use plan::PolePlan;

use num_complex::Complex64;
use numerics::{Mat, eigenvalues};

use crate::budget::{COMPLEX, REAL};
use crate::error::BuildError;

/// A string that bends, in steps over which forces are held: the displacement of each site as the mean of
/// those at both ends of a step. What is left of earlier steps is the real part of a sum over poles, each of
/// which is multiplied by a number in a step.
#[derive(Debug, Clone)]
pub struct BendingPoles {
    sites: usize,
    /// What each pole is multiplied by in a step.
    turns: Vec<Complex64>,
    /// Displacement of a site by a pole, m, `[site × poles + pole]`.
    shapes: Vec<Complex64>,
    /// What a force at a site adds to a pole, 1/N, `[site × poles + pole]`.
    inputs: Vec<Complex64>,
    /// A(0), m/N, `[output × sites + input]`.
    instants: Vec<f64>,
    margin: f64,
    sampling_frequency: f64,
}

impl BendingPoles {
    /// Bytes of a number of poles of a number of sites.
    fn bytes(sites: f64, poles: f64) -> f64 {
        COMPLEX * poles * (2.0 * sites + 1.0) + REAL * sites * sites
    }

    /// The same with A(0), row by row, as others have it: what modes above those of the poles add to it, as far
    /// as it is what springs add, which is passive.
    fn nearer_to(mut self, held: &Mat<f64>) -> Result<Self, BuildError> {
        let sites = self.sites;
        let missing = Mat::from_fn(sites, sites, |row, column| {
            held[(row, column)] - 0.5 * (self.instant(row, column) + self.instant(column, row))
        });
        let (values, vectors) = eigenvalues::of_symmetric_with_vectors(&missing)?;
        for (value, vector) in values.iter().zip(vectors.col_iter()) {
            if *value <= 0.0 {
                continue;
            }
            for (pair, instant) in self.instants.iter_mut().enumerate() {
                *instant += value * vector[pair / sites] * vector[pair % sites];
            }
        }
        Ok(self)
    }

    /// Steps a second, Hz.
    pub fn sampling_frequency(&self) -> f64 {
        self.sampling_frequency
    }

    /// Number of sites.
    pub fn sites(&self) -> usize {
        self.sites
    }

    /// Numbers that the poles are multiplied by in a step; of two poles that are conjugate, one.
    pub fn turns(&self) -> &[Complex64] {
        &self.turns
    }

    /// Displacement, m, of a site by each pole.
    pub fn shapes(&self, site: usize) -> &[Complex64] {
        &self.shapes[site * self.turns.len()..][..self.turns.len()]
    }

    /// What a force, N, at a site adds to each pole, 1/N.
    pub fn inputs(&self, site: usize) -> &[Complex64] {
        &self.inputs[site * self.turns.len()..][..self.turns.len()]
    }

    /// Displacement of a site within the step of a unit force at another, m/N: the first tap between them.
    pub fn instant(&self, output: usize, input: usize) -> f64 {
        self.instants[output * self.sites + input]
    }

    /// The positive-real margin of the speeds ([`crate::passivity`]), at the angles of all poles and between
    /// them.
    pub fn margin(&self) -> f64 {
        self.margin
    }

    /// The first taps from one site to another, m/N.
    pub fn taps(&self, output: usize, input: usize, count: usize) -> Vec<f64> {
        let mut state = self.inputs(input).to_vec();
        let shapes = self.shapes(output);
        let later = std::iter::repeat_with(|| {
            let moved = std::iter::zip(shapes, &state);
            let tap: f64 = moved.map(|(shape, state)| (shape * state).re).sum();
            for (state, turn) in state.iter_mut().zip(&self.turns) {
                *state *= turn;
            }
            tap
        });
        let all = std::iter::once(self.instant(output, input)).chain(later);
        all.take(count).collect()
    }
}

#[cfg(test)]
mod tests;
