//! The paper's digital filter (Eqs. 39–40): the causal sequence whose spectrum
//! has the sampled real part of the velocity response.

use super::{Buffers, ResponseAt, frequency_grid, inverse_transform, keep, sample};
use crate::fft;

/// Buffers for transforms of an even number of samples: half as many taps and one.
pub(crate) fn buffers(transform_length: usize, channels: usize) -> Buffers {
    Buffers {
        channels,
        samples: transform_length,
        taps: transform_length / 2 + 1,
    }
}

/// Taps of every channel.
///
/// Taking the imaginary part as the discrete Hilbert transform of the real
/// part (Eq. 39) folds the even sequence that belongs to the real part onto
/// positive times, so the fold is done directly.
pub(crate) fn taps(
    sampling_frequency: f64,
    buffers: Buffers,
    velocity_response: &ResponseAt<'_>,
) -> Vec<Vec<f64>> {
    let half = buffers.samples / 2;
    let grid = frequency_grid(buffers.samples, sampling_frequency);
    let plan = fft::inverse(buffers.samples);
    sample(buffers, &grid, velocity_response, &|mut spectrum| {
        spectrum.iter_mut().for_each(|value| value.im = 0.0);
        let sequence = inverse_transform(&*plan, &mut spectrum);
        let mut sequence = keep(sequence, buffers.taps);
        sequence[1..half].iter_mut().for_each(|tap| *tap *= 2.0);
        sequence
    })
}
