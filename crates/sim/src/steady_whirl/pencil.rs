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

use faer::{Mat, Side};
use linear::Complex64;

/// What P and Q are off by at most, in parts of their norm, with each site in units in which
/// its driving-point receptance is one. The receptances of strings of 100 m to 5 km differ by
/// up to half of this when the strings are cut at other places too.
const ROUNDING: f64 = 3e-11;

/// Forces that press hardest for what they lose.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Hardest {
    /// By how much more they press than lose; negative where none press.
    pub ratio: f64,
    /// What each site does of the pressing, which adds up to one.
    pub shares: Vec<f64>,
}

/// The hardest by a receptance (row by row, m/N) that presses no more than `most` times what it
/// loses; as hard as that, at all sites alike, where a receptance is no number.
pub(super) fn hardest(receptance: &[Complex64], most: f64) -> Hardest {
    forces(receptance, most).unwrap_or_else(|| {
        let sites = receptance.len().isqrt();
        Hardest {
            ratio: most,
            shares: vec![1.0 / sites as f64; sites],
        }
    })
}

/// None where a matrix is not finite, or its eigenvalues are not found.
fn forces(receptance: &[Complex64], most: f64) -> Option<Hardest> {
    let size = receptance.len().isqrt();
    let entry = |row: usize, column: usize| receptance[row * size + column];
    let unit = |site: usize| entry(site, site).norm().sqrt().recip();
    let scaled = |part: fn(Complex64) -> f64| {
        Mat::from_fn(size, size, |row, column| {
            -part(entry(row, column)) * unit(row) * unit(column)
        })
    };
    let (pressing, losing) = (scaled(|it| it.re), scaled(|it| it.im));
    let off = ROUNDING * pressing.norm_l2().hypot(losing.norm_l2());
    if !off.is_finite() {
        return None;
    }
    let losses = losing.self_adjoint_eigen(Side::Lower).ok()?;
    // Forces that lose one each.
    let basis = Mat::from_fn(size, size, |row, column| {
        let loss = losses.S()[column].max(0.0) + off;
        losses.U()[(row, column)] / loss.sqrt()
    });
    let more = (2.0 * most + 1.0) * off;
    let raised = Mat::from_fn(size, size, |row, column| {
        let diagonal = if row == column { more } else { 0.0 };
        pressing[(row, column)] + diagonal
    });
    let pressings = (basis.transpose() * raised * &basis)
        .self_adjoint_eigen(Side::Lower)
        .ok()?;
    // They rise.
    let greatest = size - 1;
    let forces = &basis * pressings.U().col(greatest);
    let displacements = &pressing * &forces;
    let works: Vec<f64> = (0..size)
        .map(|site| forces[site] * displacements[site])
        .collect();
    let whole: f64 = works.iter().sum();
    Some(Hardest {
        ratio: pressings.S()[greatest].min(most),
        shares: works.into_iter().map(|work| work / whole).collect(),
    })
}
