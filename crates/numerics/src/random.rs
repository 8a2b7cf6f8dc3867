//! Counter-based random numbers: each depends only on (seed, index), not on order, threads or
//! shards.
//!
//! ```
//! use numerics::random::Stream;
//!
//! let mut eighth = Stream::new(1, 8);
//! let first = eighth.part();
//! // It is the same after any others, and another for another seed.
//! for case in 0..8 {
//!     Stream::new(1, case).part();
//! }
//! assert_eq!(Stream::new(1, 8).part(), first);
//! assert_ne!(Stream::new(2, 8).part(), first);
//! ```

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

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
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }
}

/// The number at a place of the SplitMix64 sequence of a key (G. L. Steele, D. Lea and
/// C. H. Flood, *OOPSLA* 2014, 453–472): random bits for little, where a separate stream for each
/// would cost too much.
pub fn mixed(key: u64, place: u64) -> u64 {
    let state = key.wrapping_add(place.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ (mixed >> 31)
}
