//! The buffers between frequency responses and their taps.

use super::gathering;
use crate::budget::{COMPLEX, Need, REAL};
use crate::parallel::threads;

/// Bytes that the plan of a transform holds for each of its samples; measured, and rounded up.
const PLAN: f64 = 20.0;

/// The same of a transform in addition to its plan and its input: its output and, for lengths with
/// large prime factors, another, longer transform.
const TRANSFORM: f64 = 40.0;

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

    /// Bytes that all responses take together, as they are sampled and as they are kept, on any number of
    /// threads.
    pub(crate) fn together(self) -> f64 {
        let (channels, frequencies) = (self.channels as f64, self.frequencies() as f64);
        COMPLEX * channels * frequencies + self.kept()
    }

    fn kept(self) -> f64 {
        REAL * self.channels as f64 * self.taps as f64
    }

    /// All responses are sampled at all frequencies, with a number of bytes on each thread; then
    /// they are transformed, some on each thread.
    pub(crate) fn need(self, on_thread: f64) -> Need {
        let frequencies = self.frequencies() as f64;
        let (gathered, at_once) = gathering(self.channels);
        let on_each = gathered as f64 * COMPLEX * frequencies + TRANSFORM * self.samples as f64;
        let transformed = PLAN * self.samples as f64 + at_once as f64 * on_each;
        let (kept, sampling) = (self.kept(), threads() as f64 * on_thread);
        Need {
            peak: self.together() - kept + sampling.max(transformed + kept),
            kept,
        }
    }
}
