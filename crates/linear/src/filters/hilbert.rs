//! The paper's digital filter (Eqs. 39–40): the causal sequence whose spectrum
//! has the sampled real part of the velocity response.

use super::{frequency_grid, inverse_transform, keep, sample};
use crate::assembly::lanes::Lanes;
use crate::fft;

/// Taps of every channel from a transform of `transform_length` samples
/// (even): `transform_length / 2 + 1` taps each.
///
/// Taking the imaginary part as the discrete Hilbert transform of the real
/// part (Eq. 39) folds the even sequence that belongs to the real part onto
/// positive times, so the fold is done directly.
pub fn taps(
    sampling_frequency: f64,
    transform_length: usize,
    channels: usize,
    velocity_response: &(impl Fn(Lanes, &mut [Lanes]) + Sync),
) -> Vec<Vec<f64>> {
    let half = transform_length / 2;
    let grid = frequency_grid(transform_length, sampling_frequency);
    let plan = fft::inverse(transform_length);
    sample(channels, half + 1, grid, velocity_response)
        .map(|mut spectrum| {
            spectrum.iter_mut().for_each(|value| value.im = 0.0);
            let sequence = inverse_transform(&*plan, &mut spectrum);
            let mut sequence = keep(sequence, half + 1);
            sequence[1..half].iter_mut().for_each(|tap| *tap *= 2.0);
            sequence
        })
        .collect()
}
