//! Convolution quadrature with the two-stage Radau IIA method (Ch. Lubich and
//! A. Ostermann, *Mathematics of Computation* 60, 1993, 105–131): of third order,
//! and passive as BDF2 is.
//!
//! Every tap is a matrix between the two stages of a step, at c₁ = ⅓ and c₂ = 1
//! of its length. The taps are the coefficients of K(Δ(ζ) f_s) with
//! Δ(ζ) = (A + ζ/(1 − ζ) 1 bᵀ)⁻¹, K taken of a matrix by its eigenvalues. A
//! simulation would have to meet every contact at two coupled stages; the
//! stepper does not, and this filter serves to compare linear responses.
//!
//! What integrates, 1/s, turns a step of one into a ramp:
//!
//! ```
//! use linear::filters::radau;
//!
//! let taps = radau::taps(10.0, 64, &|s| 1.0 / s);
//! // From both stages of a step to its end: after n whole steps the ramp is at n/10.
//! let at_end = |steps: usize| -> f64 { taps[2..].iter().flat_map(|it| &it[..steps]).sum() };
//! assert!((at_end(1) - 0.1).abs() < 1e-9);
//! assert!((at_end(30) - 3.0).abs() < 1e-9);
//! ```

use num_complex::Complex64;

use super::quadrature::{Sampling, buffers, circle};
use super::sample;
use crate::assembly::block::Block;
use crate::assembly::lanes::Lanes;
use crate::assembly::nodes::Relation;
use crate::assembly::number::Number;

/// Where the stages lie, in parts of a step.
pub const STAGES: [f64; 2] = [1.0 / 3.0, 1.0];

/// The coefficients A of Radau IIA; the last row is b.
const A: [[f64; 2]; 2] = [[5.0 / 12.0, -1.0 / 12.0], [0.75, 0.25]];

/// The first `count` taps of one channel from `response` at s (rad/s):
/// `taps[2 * output + input][step]` between the stages.
pub fn taps(
    sampling_frequency: f64,
    count: usize,
    response: &(impl Fn(Complex64) -> Complex64 + Sync),
) -> [Vec<f64>; 4] {
    let buffers = buffers(count, 4, Sampling::Close);
    let circle = circle(buffers.samples, Sampling::Close);
    let on_circle = |index: usize| circle.point(index);
    let between_stages = |zeta: Lanes, channels: &mut [Lanes]| {
        let matrix = generating_matrix(zeta);
        let ([[a, b], [c, d]], [one, other]) = (matrix, eigenvalues(matrix));
        // Sylvester's formula: K(Δ) = p + q Δ.
        let [k_one, k_other] =
            [one, other].map(|eigenvalue| (eigenvalue * sampling_frequency).each(response));
        let q = (k_one - k_other) * (one - other).inverse();
        let p = k_one - q * one;
        channels.copy_from_slice(&[p + q * a, q * b, q * c, p + q * d]);
    };
    let channels = sample(buffers, &on_circle, &between_stages, &|spectrum| {
        circle.coefficients(spectrum, count)
    });
    let mut channels = channels.into_iter();
    std::array::from_fn(|_| channels.next().unwrap_or_default())
}

/// The generating function bᵀ K(Δ(ζ) f_s) 1 of what is held over each step and answered
/// by the mean over it, as the eigenvalues of Δ(ζ), at which K is taken, with the weights
/// of these.
pub(super) fn held<T: Number>(zeta: T) -> [(T, T); 2] {
    let matrix = generating_matrix(zeta);
    let ([[a, b], [c, d]], [one, other]) = (matrix, eigenvalues(matrix));
    let [_, [first, last]] = A;
    let of_held = (a + b) * first + (c + d) * last;
    let apart = (one - other).inverse();
    [
        (one, (of_held - other) * apart),
        (other, (one - of_held) * apart),
    ]
}

fn eigenvalues<T: Number>([[a, b], [c, d]]: [[T; 2]; 2]) -> [T; 2] {
    let (mean, determinant) = ((a + d) * 0.5, a * d - b * c);
    let root = (mean * mean - determinant).root();
    [mean + root, mean - root]
}

/// Δ(ζ).
fn generating_matrix<T: Number>(zeta: T) -> [[T; 2]; 2] {
    let carried = zeta * (-zeta + 1.0).inverse();
    let [first, last] = A;
    let entry = |row: [f64; 2], column: usize| carried * last[column] + row[column];
    let (a, b) = (entry(first, 0), entry(first, 1));
    let (c, d) = (entry(last, 0), entry(last, 1));
    Block([[a, b], [c, d]]).inverse().0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// K(s) = 1/s integrates: a quadratic to its cubic exactly at the ends of
    /// steps, for the method is of third order.
    #[test]
    fn a_quadratic_is_integrated_exactly() {
        let (frequency, steps) = (10.0, 64);
        let taps = taps(frequency, steps, &|s: Complex64| s.inv());
        for step in 0..steps {
            let mut sum = 0.0;
            for input in 0..=step {
                for (stage, place) in STAGES.iter().enumerate() {
                    let time = (input as f64 + place) / frequency;
                    sum += taps[2 + stage][step - input] * time * time;
                }
            }
            let end = (step + 1) as f64 / frequency;
            assert!((sum - end.powi(3) / 3.0).abs() < 1e-7, "{step}: {sum}");
        }
    }

    /// Weighted by b, Δ has a positive Hermitian part wherever |ζ| < 1: so has
    /// K(Δ) for a positive-real K.
    #[test]
    fn the_generating_matrix_is_passive() {
        for index in 0..400 {
            let zeta = Complex64::from_polar(0.999, f64::from(index) * 0.0157);
            let [[a, b], [c, d]] = generating_matrix(zeta);
            let [_, [b1, b2]] = A;
            let off = 0.5 * (b * b1 + (c * b2).conj());
            let determinant = (a * b1).re * (d * b2).re - off.norm_sqr();
            assert!((a * b1).re > 0.0 && determinant > -1e-9, "{zeta}");
        }
    }
}
