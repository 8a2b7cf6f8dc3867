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
    let instant = (0..inputs).map(|input| taps(input, input)[0]);
    let scale = instant.fold(0.0, f64::max);
    let length = REFINEMENT * taps(0, 0).len().next_power_of_two();
    let spectra: Vec<Vec<c64>> = (0..inputs * inputs)
        .map(|pair| spectrum(taps(pair / inputs, pair % inputs), length))
        .collect();
    let mut smallest = f64::INFINITY;
    for frequency in 0..=length / 2 {
        let response = Mat::from_fn(inputs, inputs, |output, input| {
            spectra[output * inputs + input][frequency]
        });
        smallest = smallest.min(smallest_real_part(&response)?);
    }
    Ok(smallest / scale)
}

/// Smallest eigenvalue of the Hermitian part; a single input has one value.
fn smallest_real_part(response: &Mat<c64>) -> Result<f64, BuildError> {
    if response.nrows() == 1 {
        return Ok(response[(0, 0)].re);
    }
    let hermitian = Mat::from_fn(response.nrows(), response.ncols(), |row, column| {
        0.5 * (response[(row, column)] + response[(column, row)].conj())
    });
    let eigenvalues = hermitian
        .self_adjoint_eigenvalues(Side::Lower)
        .map_err(|_| BuildError::NotFinite { method: "taps" })?;
    Ok(eigenvalues[0])
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
