//! Which forces at several sites press hardest for what they lose, at one rate of whirl.
//!
//! Let H be the receptance at the sites. Forces f of any sizes and phases press with
//! −Re f*Hf and lose −Im f*Hf > 0; H is symmetric, so these are f*Pf and f*Qf with the real
//! symmetric P = −Re H and Q = −Im H, and their greatest ratio is the greatest eigenvalue of
//! the pencil (P, Q). It has a real eigenvector: forces that are all in phase or opposite.
//!
//! Neighbouring sites make Q nearly singular, and rounding then hides some of its directions.
//! That must not hide forces that press. No string presses more than Λ times what it loses
//! (`most`), Λf*Qf ≥ f*Pf, so that for an ε > 0
//!
//! (f*Pf + 2Λε) / (f*Qf + 2ε) ≥ f*Pf / f*Qf,
//!
//! and with P + (2Λ + 1)ε and Q + ε in place of P and Q the ratio is never too small, as long as
//! neither is off by more than ε.

use linear::Complex64;
use numerics::equations::Elimination;
use numerics::products::{norm, product};
use numerics::{Mat, eigenvalues};

/// What P and Q are off by at most, in parts of their norm, with each site in units in which
/// its driving-point receptance is one. The receptances of strings of 100 m to 5 km differ by
/// up to half of this when the strings are cut at other places too.
const ROUNDING: f64 = 3e-11;

/// Forces that press less than the hardest by this part are as good as they are …
const NEAR: f64 = 1e-6;

/// … and the steps of inverse iteration.
const STEPS: usize = 3;

/// The pencil of a receptance.
#[derive(Debug, Clone)]
pub(super) struct Pencil {
    pressing: Mat<f64>,
    losing: Mat<f64>,
    /// ε.
    off: f64,
    /// Λ.
    most: f64,
    /// The greatest ratio; none where it is not found.
    greatest: Option<f64>,
}

impl Pencil {
    /// That of a receptance (row by row, m/N) by which forces press no more than `most` times what
    /// they lose.
    pub fn new(receptance: &[Complex64], most: f64) -> Self {
        let size = receptance.len().isqrt();
        let entry = |row: usize, column: usize| receptance[row * size + column];
        let unit = |site: usize| entry(site, site).norm().sqrt().recip();
        let scaled = |part: fn(Complex64) -> f64| {
            Mat::from_fn(size, size, |row, column| {
                -part(entry(row, column)) * unit(row) * unit(column)
            })
        };
        let (pressing, losing) = (scaled(|it| it.re), scaled(|it| it.im));
        let off = ROUNDING * norm(&pressing).hypot(norm(&losing));
        let mut pencil = Self {
            pressing,
            losing,
            off,
            most,
            greatest: None,
        };
        pencil.greatest = pencil.greatest();
        pencil
    }

    /// By how much more the hardest forces press than lose; negative where none press. As much
    /// as any could where that is not found, because a receptance is no number.
    pub fn ratio(&self) -> f64 {
        (self.greatest).map_or(self.most, |greatest| greatest.min(self.most))
    }

    /// What each site does of the pressing of forces that press as hard, which adds up to one;
    /// all alike where these are not found.
    pub fn shares(&self) -> Vec<f64> {
        let size = self.losing.nrows();
        let alike = Mat::from_fn(size, 1, |_, _| 1.0);
        let works = self.forces().map_or(alike, |forces| {
            let displacements = product(&self.pressing, &forces);
            Mat::from_fn(size, 1, |site, _| {
                forces[(site, 0)] * displacements[(site, 0)]
            })
        });
        let works: Vec<f64> = works.col(0).iter().copied().collect();
        let whole: f64 = works.iter().sum();
        works.into_iter().map(|work| work / whole).collect()
    }

    /// Forces at the sites that press as hard as any, with each site in its unit; none where they are
    /// not found. By inverse iteration, from forces that are not symmetric.
    pub fn forces(&self) -> Option<Mat<f64>> {
        let ratio = self.greatest? * (1.0 + NEAR);
        let (pressing, losing) = (self.raised_pressing(), self.raised_losing());
        let size = losing.nrows();
        let gap = Elimination::new(&Mat::from_fn(size, size, |row, column| {
            ratio * losing[(row, column)] - pressing[(row, column)]
        }));
        let start = Mat::from_fn(size, 1, |site, _| (size + site) as f64);
        let forces = (0..STEPS).fold(start, |forces, _| {
            let next = gap.solve(&product(&losing, &forces));
            let scale = norm(&next).recip();
            Mat::from_fn(size, 1, |site, _| scale * next[(site, 0)])
        });
        norm(&forces).is_finite().then_some(forces)
    }

    /// P + (2Λ + 1)ε.
    fn raised_pressing(&self) -> Mat<f64> {
        raised(&self.pressing, (2.0 * self.most + 1.0) * self.off)
    }

    /// Q + ε.
    fn raised_losing(&self) -> Mat<f64> {
        raised(&self.losing, self.off)
    }

    /// The greatest eigenvalue; none where a matrix is not finite, losses are not positive, or the
    /// eigenvalues are not found.
    fn greatest(&self) -> Option<f64> {
        if !self.off.is_finite() {
            return None;
        }
        // They rise.
        let ratios = eigenvalues::of_pencil(&self.raised_pressing(), &self.raised_losing()).ok()?;
        ratios.last().copied()
    }
}

/// A matrix with more on its diagonal.
fn raised(matrix: &Mat<f64>, by: f64) -> Mat<f64> {
    Mat::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
        matrix[(row, column)] + if row == column { by } else { 0.0 }
    })
}
