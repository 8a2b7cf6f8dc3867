//! Methods whose labels mean little.

use linear::passivity::STABLE_MARGIN;
use thiserror::Error;

/// A method's responses that are not positive-real.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "the responses in {motion} by {method} are not positive-real (margin {margin:.2e}): \
     a stuck site chatters and labels mean little"
)]
pub struct Instability {
    /// Name of the method.
    pub method: &'static str,
    /// `torsion` or `bending`.
    pub motion: &'static str,
    /// Positive-real margin.
    pub margin: f64,
}

/// Whether a positive-real margin says that a stuck site chatters.
pub fn is_unstable(margin: f64) -> bool {
    margin < STABLE_MARGIN
}
