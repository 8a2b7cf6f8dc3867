//! How far discrete driving-point responses are from being positive-real.
//!
//! A site in contact closes a feedback loop whose gain may be infinite (a
//! sticking bit). It is stable for every gain only if the response of the taps
//! has a positive real part at every frequency, not only at those the taps
//! were made from (Section 2.4, Fig. 3).

use faer::{Mat, Side, c64};
use realfft::RealFftPlanner;

use crate::error::BuildError;

/// Below this margin a response is counted as unstable in sticking. Rounding
/// and the cut tail of a response stay well within it.
pub const STABLE_MARGIN: f64 = -1e-4;

/// The transform is this many times longer than the taps, so that their
/// spectrum is seen between its own samples too.
const REFINEMENT: usize = 8;

/// Where a response is furthest from being positive-real.
#[derive(Debug, Clone, PartialEq)]
pub struct WorstPoint {
    /// The positive-real margin (see [`positive_real_margin`]).
    pub margin: f64,
    /// The frequency at which it is found, rad per step, from 0 to π.
    pub angle: f64,
    /// In what proportion the inputs act there, a unit vector.
    pub direction: Vec<f64>,
}

/// The smallest real part over a fine frequency grid, relative to the largest
/// instantaneous response A(0): for several inputs the smallest eigenvalue of
/// the Hermitian part. `taps(output, input)` gives the response between two of
/// `inputs` driving points.
///
/// # Errors
/// Where the taps are not finite.
pub fn positive_real_margin<'a>(
    inputs: usize,
    taps: impl Fn(usize, usize) -> &'a [f64],
) -> Result<f64, BuildError> {
    worst_point(inputs, taps).map(|worst| worst.margin)
}

/// The margin with the place where it is found: what a load must be tuned to
/// that draws energy from the string.
///
/// # Errors
/// Where the taps are not finite.
pub fn worst_point<'a>(
    inputs: usize,
    taps: impl Fn(usize, usize) -> &'a [f64],
) -> Result<WorstPoint, BuildError> {
    let instant = (0..inputs).map(|input| taps(input, input)[0]);
    let scale = instant.fold(0.0, f64::max);
    let length = REFINEMENT * taps(0, 0).len().next_power_of_two();
    let spectra: Vec<Vec<c64>> = (0..inputs * inputs)
        .map(|pair| spectrum(taps(pair / inputs, pair % inputs), length))
        .collect();
    let hermitian_part = |frequency: usize| {
        Mat::from_fn(inputs, inputs, |row, column| {
            let [one, other] = [row * inputs + column, column * inputs + row];
            0.5 * (spectra[one][frequency] + spectra[other][frequency].conj())
        })
    };
    let (mut smallest, mut place) = (f64::INFINITY, 0);
    for frequency in 0..=length / 2 {
        let real_part = if inputs == 1 {
            spectra[0][frequency].re
        } else {
            smallest_eigenvalue(&hermitian_part(frequency))?
        };
        if real_part < smallest {
            (smallest, place) = (real_part, frequency);
        }
    }
    Ok(WorstPoint {
        margin: smallest / scale,
        angle: std::f64::consts::TAU * place as f64 / length as f64,
        direction: worst_direction(&hermitian_part(place))?,
    })
}

fn smallest_eigenvalue(hermitian: &Mat<c64>) -> Result<f64, BuildError> {
    let eigenvalues = hermitian
        .self_adjoint_eigenvalues(Side::Lower)
        .map_err(|_| BuildError::NotFinite { method: "taps" })?;
    Ok(eigenvalues[0])
}

/// The eigenvector of the smallest eigenvalue. Reciprocity makes the Hermitian
/// part real, and so the eigenvector, but for a factor.
fn worst_direction(hermitian: &Mat<c64>) -> Result<Vec<f64>, BuildError> {
    let decomposition = hermitian
        .self_adjoint_eigen(Side::Lower)
        .map_err(|_| BuildError::NotFinite { method: "taps" })?;
    let vector = decomposition.U().col(0);
    let largest = (vector.iter().copied())
        .max_by(|one, other| one.norm().total_cmp(&other.norm()))
        .unwrap_or(c64::new(1.0, 0.0));
    let turned: Vec<f64> = (vector.iter().map(|entry| (entry / largest).re)).collect();
    let length = turned.iter().map(|x| x * x).sum::<f64>().sqrt();
    Ok(turned.iter().map(|x| x / length).collect())
}

fn spectrum(taps: &[f64], length: usize) -> Vec<c64> {
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(length);
    let mut padded = transform.make_input_vec();
    padded[..taps.len()].copy_from_slice(taps);
    let mut spectrum = transform.make_output_vec();
    transform
        .process(&mut padded, &mut spectrum)
        .expect("both buffers were made by the plan");
    spectrum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_passive_first_order_lag_has_a_positive_margin_and_a_delay_has_not() {
        let lag: Vec<f64> = (0..64).map(|n| 0.5f64.powi(n)).collect();
        let margin = positive_real_margin(1, |_, _| &lag).unwrap();
        // Re 1/(1 − ζ/2) on the unit circle is smallest at ζ = −1: 2/3.
        assert!((margin - 2.0 / 3.0).abs() < 1e-9);
        let delayed = [1.0, 0.0, 0.0, 2.0];
        assert!((positive_real_margin(1, |_, _| &delayed).unwrap() + 1.0).abs() < 1e-9);
    }

    #[test]
    fn coupling_stronger_than_the_driving_points_is_not_passive() {
        let (own, cross) = ([1.0], [2.0]);
        let margin =
            positive_real_margin(2, |i, j| if i == j { &own[..] } else { &cross[..] }).unwrap();
        assert!((margin + 1.0).abs() < 1e-12);
    }
}
