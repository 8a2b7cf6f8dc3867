//! Random numbers that hang on a seed and a number alone: no order, thread or shard
//! changes them.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

use crate::sweep_file::Spacing;

/// A stream of random numbers.
pub struct Stream(ChaCha8Rng);

impl Stream {
    /// The stream of a number.
    pub fn new(seed: u64, number: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(number);
        Self(random)
    }

    /// The next number, uniform from 0 to 1.
    pub fn part(&mut self) -> f64 {
        // 53 random bits: every double in [0, 1) of that spacing.
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// The next number, uniform between two, or with a uniform logarithm.
    pub fn between(&mut self, from: f64, to: f64, spacing: Spacing) -> f64 {
        spacing.between(from, to, self.part())
    }
}
