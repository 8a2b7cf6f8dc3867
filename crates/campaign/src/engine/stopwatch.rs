//! The time that something takes, where there is a clock.

#[cfg(not(target_family = "wasm"))]
use std::time::Instant;

/// Runs from its start.
#[derive(Debug, Clone, Copy)]
pub struct Stopwatch {
    /// A page's engine does not have a clock: its caller has one.
    #[cfg(not(target_family = "wasm"))]
    start: Instant,
}

impl Stopwatch {
    /// Begins now.
    pub fn start() -> Self {
        Self {
            #[cfg(not(target_family = "wasm"))]
            start: Instant::now(),
        }
    }

    /// The time since then, s; zero without a clock.
    pub fn seconds(self) -> f64 {
        #[cfg(not(target_family = "wasm"))]
        let seconds = self.start.elapsed().as_secs_f64();
        #[cfg(target_family = "wasm")]
        let seconds = 0.0;
        seconds
    }
}
