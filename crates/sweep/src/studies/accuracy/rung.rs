//! The reference's method at one sampling frequency.

use linear::Method;

use super::answer::{Answer, Difference, largest_difference};
use super::error::AccuracyError;
use super::probes::Systems;

/// The reference's method at one sampling frequency.
pub struct Rung {
    /// The method.
    pub method: Method,
    /// The frequency, Hz.
    pub frequency: f64,
    /// Its systems, or why it has none.
    pub systems: Result<Systems, AccuracyError>,
    /// Memory that the systems take, bytes.
    pub kept: f64,
    /// Its answers; none without systems.
    pub answers: Vec<Answer>,
}

/// Memory that the systems of some frequencies take, bytes.
pub fn memory_of(rungs: &[Rung]) -> f64 {
    rungs.iter().map(|rung| rung.kept).sum()
}

/// By how much the last answers may be wrong: by what they changed over two doublings,
/// for over one they may agree by chance.
///
/// # Errors
/// Where these answers cannot be compared.
pub fn uncertainty_of(rungs: &[Rung], asked: f64) -> Result<Difference, AccuracyError> {
    match rungs {
        [.., quarter, _, whole] => largest_difference(&quarter.answers, &whole.answers, asked),
        _ => Err(AccuracyError::NoAnswers),
    }
}
