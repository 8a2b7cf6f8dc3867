//! The plain inverse discrete Fourier transform of the sampled response, kept
//! to show that it fails (start of Section 2.4): between its samples the
//! spectrum of these taps is not positive-real, and a sticking bit chatters.

use super::{Buffers, ResponseAt, frequency_grid, inverse_transform, sample};
use crate::fft;

/// Buffers for transforms of an even number of samples, all of which are taps.
pub(crate) fn buffers(transform_length: usize, channels: usize) -> Buffers {
    Buffers {
        channels,
        samples: transform_length,
        taps: transform_length,
    }
}

/// Taps of every channel: all samples of the inverse transform, the wrapped-around end included.
pub(crate) fn taps(
    sampling_frequency: f64,
    buffers: Buffers,
    velocity_response: &ResponseAt<'_>,
) -> Vec<Vec<f64>> {
    let grid = frequency_grid(buffers.samples, sampling_frequency);
    let plan = fft::inverse(buffers.samples);
    sample(buffers, &grid, velocity_response, &|mut spectrum| {
        inverse_transform(&*plan, &mut spectrum)
    })
}
