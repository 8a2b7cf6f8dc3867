//! Random numbers of a study: each problem draws from (seed, number) alone.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

/// A stream of random numbers.
pub struct Draw(ChaCha8Rng);

impl Draw {
    /// The stream of a number.
    pub fn new(seed: u64, number: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(number);
        Self(random)
    }

    /// Uniform in [0, 1).
    fn fraction(&mut self) -> f64 {
        // 53 random bits: every double of that spacing.
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + self.fraction() * (to - from)
    }

    /// With a uniform logarithm between two numbers.
    pub fn log_between(&mut self, from: f64, to: f64) -> f64 {
        from * (to / from).powf(self.fraction())
    }
}
