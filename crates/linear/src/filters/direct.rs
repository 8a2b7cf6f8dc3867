//! The plain inverse discrete Fourier transform of the sampled response, kept
//! to show that it fails (start of Section 2.4): between its samples the
//! spectrum of these taps is not positive-real, and a sticking bit chatters.

use super::{frequency_grid, inverse_transform, sample};
use crate::assembly::lanes::Lanes;
use crate::fft;

/// Taps of every channel: all `transform_length` (even) samples of the inverse
/// transform, the wrapped-around end included.
pub fn taps(
    sampling_frequency: f64,
    transform_length: usize,
    channels: usize,
    velocity_response: &(impl Fn(Lanes, &mut [Lanes]) + Sync),
) -> Vec<Vec<f64>> {
    let grid = frequency_grid(transform_length, sampling_frequency);
    let plan = fft::inverse(transform_length);
    sample(channels, transform_length / 2 + 1, grid, velocity_response)
        .map(|mut spectrum| inverse_transform(&*plan, &mut spectrum))
        .collect()
}
