//! Plans of Fourier transforms of real sequences.
//!
//! The algorithms behind them are generic: whoever plans compiles all of them. They are
//! planned here alone, so that they are compiled once.

use std::sync::Arc;

use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

/// The transform of so many real values; not scaled.
pub fn forward(length: usize) -> Arc<dyn RealToComplex<f64>> {
    RealFftPlanner::new().plan_fft_forward(length)
}

/// Its inverse, `length` times too large.
pub fn inverse(length: usize) -> Arc<dyn ComplexToReal<f64>> {
    RealFftPlanner::new().plan_fft_inverse(length)
}
