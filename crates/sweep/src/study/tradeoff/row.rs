//! One configuration and one measure: a row of the table.

use super::configuration::Configuration;
use super::measure::{Measure, Reference};

/// The sweep that costs are told for: cases, and seconds simulated of each.
pub const CASES: f64 = 1000.0;
/// Seconds simulated of each case.
pub const CASE_SECONDS: f64 = 10.0;

/// One configuration and one measure.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Which measure.
    pub measure: Measure,
    /// Which configuration.
    pub configuration: Configuration,
    /// Its value, where it is one number.
    pub value: Option<f64>,
    /// What it should be.
    pub reference: Reference,
    /// Its relative error; `None` where there is no answer.
    pub error: Option<f64>,
    /// Time to build the responses, s.
    pub build_seconds: f64,
    /// Time per simulated second, s.
    pub step_seconds: f64,
}

impl Row {
    /// Time for a sweep of [`CASES`] cases on one core, build included, s.
    pub fn cost(&self) -> f64 {
        cost(self.build_seconds, self.step_seconds)
    }
}

/// Time for a sweep of [`CASES`] cases on one core, s.
pub fn cost(build_seconds: f64, step_seconds: f64) -> f64 {
    build_seconds + CASES * CASE_SECONDS * step_seconds
}
