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

use std::ops::Range;

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
    /// Where displacements are seen besides, m from the bit.
    places: Vec<f64>,
    /// What each pole is multiplied by in a step.
    turns: Vec<Complex64>,
    /// Displacement of a site, or a place after these, by a pole, m, `[output × poles + pole]`.
    shapes: Vec<Complex64>,
    /// What a force at a site adds to a pole, 1/N, `[site × poles + pole]`.
    inputs: Vec<Complex64>,
    /// A(0), m/N, `[output × sites + input]`.
    instants: Vec<f64>,
    margin: f64,
    sampling_frequency: f64,
}

impl BendingPoles {
    /// Bytes of a number of poles of a number of outputs, some of which are sites.
    fn bytes((outputs, sites): (f64, f64), poles: f64) -> f64 {
        COMPLEX * poles * (outputs + sites + 1.0) + REAL * outputs * sites
    }

    /// The same, whose outputs besides the sites are at these places, m from the bit.
    fn seen_at(self, places: &[f64]) -> Self {
        let places = places.to_vec();
        Self { places, ..self }
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
            for (pair, instant) in self.instants[..sites * sites].iter_mut().enumerate() {
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

    /// Places, m from the bit, whose displacements are seen besides ([`PolePlan::seen_at`]).
    pub fn places(&self) -> &[f64] {
        &self.places
    }

    /// Displacement, m, of a site by each pole; after the sites, of a place.
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

    /// The first taps from a site to another, or to a place after the sites, m/N.
    pub fn taps(&self, output: usize, input: usize, count: usize) -> Vec<f64> {
        self.taps_from(input, output..output + 1, count).remove(0)
    }

    /// The same from one site to several outputs.
    pub(crate) fn taps_from(
        &self,
        input: usize,
        outputs: Range<usize>,
        count: usize,
    ) -> Vec<Vec<f64>> {
        let shapes: Vec<_> = outputs.clone().map(|it| self.shapes(it)).collect();
        let instants = outputs.map(|output| self.instant(output, input));
        self.turned(self.inputs(input), &shapes, instants, count)
    }

    /// The same to one output from all sites.
    pub(crate) fn taps_to(&self, output: usize, count: usize) -> Vec<Vec<f64>> {
        let inputs: Vec<_> = (0..self.sites).map(|site| self.inputs(site)).collect();
        let instants = (0..self.sites).map(|site| self.instant(output, site));
        self.turned(self.shapes(output), &inputs, instants, count)
    }

    /// Taps of several series at once, each of which begins with its instant: then the real part of the sum
    /// over all poles of a row of its own times what they all have in common, which turns from tap to tap.
    fn turned(
        &self,
        common: &[Complex64],
        rows: &[&[Complex64]],
        instants: impl Iterator<Item = f64>,
        count: usize,
    ) -> Vec<Vec<f64>> {
        let by_pole = |part: fn(&Complex64) -> f64| -> Vec<f64> {
            let of_pole = |pole: usize| rows.iter().map(move |row| part(&row[pole]));
            (0..self.turns.len()).flat_map(of_pole).collect()
        };
        let (real, imaginary) = (by_pole(|it| it.re), by_pole(|it| it.im));
        let mut common = common.to_vec();
        let mut taps: Vec<Vec<f64>> = instants.map(|instant| vec![instant]).collect();
        let mut sums = vec![0.0; rows.len()];
        for _ in 1..count {
            sums.fill(0.0);
            let width = rows.len().max(1);
            let rows = real.chunks_exact(width).zip(imaginary.chunks_exact(width));
            for ((common, turn), (real, imaginary)) in common.iter_mut().zip(&self.turns).zip(rows)
            {
                for (sum, (real, imaginary)) in sums.iter_mut().zip(real.iter().zip(imaginary)) {
                    *sum += real * common.re - imaginary * common.im;
                }
                *common *= turn;
            }
            for (taps, sum) in taps.iter_mut().zip(&sums) {
                taps.push(*sum);
            }
        }
        taps.iter_mut().for_each(|taps| taps.truncate(count));
        taps
    }
}

#[cfg(test)]
mod tests;
