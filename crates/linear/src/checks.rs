//! Refusals that several builders share.

use crate::error::BuildError;

/// Refuses what is no sampling frequency.
pub(crate) fn check_sampling(value: f64) -> Result<(), BuildError> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(BuildError::Parameter {
            name: "sampling_frequency",
            value,
            expected: "a positive number of Hz",
        })
    }
}

/// Refuses what is no time to simulate.
pub(crate) fn check_time(value: f64) -> Result<(), BuildError> {
    if value.is_finite() && value >= 0.0 {
        Ok(())
    } else {
        Err(BuildError::Parameter {
            name: "longest_time",
            value,
            expected: "zero or a positive number of seconds",
        })
    }
}
