//! What responses and the transforms behind them may be: how long, and numbers.

use crate::error::BuildError;
use crate::method::{Method, Transform};

/// The most taps kept per response: 16 million, 128 MB.
pub(crate) const MOST_TAPS: usize = 1 << 24;

/// Taps that a simulation of the given time can use.
pub(crate) fn needed_taps(longest_time: f64, sampling_frequency: f64) -> f64 {
    ((longest_time * sampling_frequency).ceil() + 1.0).max(2.0)
}

/// The next length that is a product of twos, threes and fives: a transform of any other may
/// take several times as long.
pub(crate) fn transformable(length: usize) -> usize {
    let is_product = |length: usize| {
        let without = |mut left: usize, factor: usize| {
            while left % factor == 0 {
                left /= factor;
            }
            left
        };
        [2, 3, 5].into_iter().fold(length, without) == 1
    };
    let mut length = length.max(1);
    while !is_product(length) {
        length += 1;
    }
    length
}

/// Samples of a transform as given, or by default.
pub(super) fn samples_of(transform: &Transform, default: f64, sampling_frequency: f64) -> f64 {
    (transform.seconds).map_or(default, |seconds| seconds * sampling_frequency)
}

/// An even transform length of about a number of samples.
pub(super) fn transform_length(samples: f64, sampling_frequency: f64) -> Result<usize, BuildError> {
    if samples > MOST_TAPS as f64 {
        return Err(too_many(samples));
    }
    if samples < 4.0 || samples.is_nan() {
        return Err(BuildError::Parameter {
            name: "transform_s",
            value: samples / sampling_frequency,
            expected: "at least four samples long",
        });
    }
    Ok(2 * (samples / 2.0).round() as usize)
}

pub(crate) fn too_many(taps: f64) -> BuildError {
    BuildError::TooManyTaps {
        taps,
        most: MOST_TAPS,
    }
}

/// Refuses responses that are no numbers.
pub(super) fn all_finite(channels: &[Vec<f64>], method: &Method) -> Result<(), BuildError> {
    if channels.iter().flatten().all(|tap| tap.is_finite()) {
        Ok(())
    } else {
        Err(BuildError::NotFinite {
            method: method.name(),
        })
    }
}

/// Taps of responses that are as long as a simulation (s).
///
/// # Errors
/// Where these are more than are kept.
pub(crate) fn taps_of(longest_time: f64, sampling_frequency: f64) -> Result<usize, BuildError> {
    let needed = needed_taps(longest_time, sampling_frequency);
    if needed > MOST_TAPS as f64 {
        return Err(too_many(needed));
    }
    Ok(needed as usize)
}
