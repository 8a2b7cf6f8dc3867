//! The buffers between frequency responses and their taps.

use super::gathering;
use crate::budget::{COMPLEX, Need, REAL};
use crate::parallel::threads;

/// Bytes that a transform holds for each of its samples in addition to its input: its output, its
/// plan and, for lengths with large prime factors, another, longer transform; and what a thread does
/// not give back at once. Measured, and rounded up.
const TRANSFORM: f64 = 70.0;

/// Lengths of the buffers of a filter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Buffers {
    /// Responses that are made side by side.
    pub(crate) channels: usize,
    /// Samples of a transform (even).
    pub(crate) samples: usize,
    /// Taps that are kept of each response.
    pub(crate) taps: usize,
}

impl Buffers {
    /// Frequencies at which responses are sampled: the others are their conjugates.
    pub(crate) fn frequencies(self) -> usize {
        self.samples / 2 + 1
    }

    /// All responses are sampled at all frequencies, with a number of bytes on each thread; then
    /// they are transformed, some on each thread.
    pub(crate) fn need(self, on_thread: f64) -> Need {
        let (channels, frequencies) = (self.channels as f64, self.frequencies() as f64);
        let sampled = COMPLEX * channels * frequencies;
        let (gathered, at_once) = gathering(self.channels);
        let on_each = gathered as f64 * COMPLEX * frequencies + TRANSFORM * self.samples as f64;
        let transformed = at_once as f64 * on_each;
        let kept = REAL * channels * self.taps as f64;
        let sampling = threads() as f64 * on_thread;
        Need {
            peak: sampled + sampling.max(transformed + kept),
            kept,
        }
    }
}
