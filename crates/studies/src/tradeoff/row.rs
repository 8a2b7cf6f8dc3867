//! One configuration and one measure: a row of the table.

use super::configuration::Configuration;
use super::measure::Measure;

/// Costs are those of a sweep with this number of cases.
pub const CASES: f64 = 1000.0;
/// Seconds simulated of each case.
pub const CASE_SECONDS: f64 = 10.0;

/// What a measure should be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reference {
    /// The value; of a whole history, nothing.
    pub value: f64,
    /// How far it may be off, in parts of itself.
    pub uncertainty: f64,
}

impl Reference {
    /// A value in closed form.
    pub fn exact(value: f64) -> Self {
        Self {
            value,
            uncertainty: 0.0,
        }
    }

    /// What two methods that share no discretisation agree on.
    pub fn agreed(one: f64, other: f64) -> Self {
        Self {
            value: 0.5 * (one + other),
            uncertainty: 0.5 * (one / other - 1.0).abs(),
        }
    }
}

/// The limit of a sequence of the given order from its values at two neighbouring
/// frequencies, the second twice the first.
pub fn extrapolated(coarse: f64, fine: f64, order: i32) -> f64 {
    fine + (fine - coarse) / (2f64.powi(order) - 1.0)
}

/// One configuration and one measure.
#[derive(Debug, Clone, PartialEq)]
pub struct TradeoffRow {
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

impl TradeoffRow {
    /// Time for a sweep of [`CASES`] cases on one core, build included, s.
    pub fn cost(&self) -> f64 {
        cost(self.build_seconds, self.step_seconds)
    }
}

/// Time for a sweep of [`CASES`] cases on one core, s.
pub fn cost(build_seconds: f64, step_seconds: f64) -> f64 {
    build_seconds + CASES * CASE_SECONDS * step_seconds
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extrapolation_removes_the_leading_error() {
        let value = |h: f64| 5.0 + 3.0 * h * h;
        assert!((extrapolated(value(0.2), value(0.1), 2) - 5.0).abs() < 1e-12);
    }
}
