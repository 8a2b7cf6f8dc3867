//! The range of values that a quantity can have.

use std::fmt::Display;

use thiserror::Error;

/// Why a quantity is refused a value.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ValueError {
    /// Outside its range: if it has the right sign, probably in another unit.
    #[error(
        "{} is not between {least} and {}{}",
        with_unit(in_digits(*value), unit),
        with_unit(most, unit),
        hint(*value, unit)
    )]
    OutOfRange {
        /// The value.
        value: f64,
        /// The least that it may be.
        least: f64,
        /// The most that it may be.
        most: f64,
        /// The unit of all three.
        unit: &'static str,
    },
    /// At zero speed nothing is drilled, and every time of a case is infinite.
    #[error("{0} rpm: the surface must turn, in the positive direction")]
    StandsStill(f64),
    /// It counts something.
    #[error("{0} is not a whole number")]
    NotWhole(f64),
}

/// Refuses a value outside a range.
///
/// # Errors
/// Where it is.
pub fn within(value: f64, least: f64, most: f64, unit: &'static str) -> Result<(), ValueError> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(ValueError::OutOfRange {
        value,
        least,
        most,
        unit,
    })
}

fn with_unit(number: impl Display, unit: &str) -> String {
    let space = if unit.is_empty() { "" } else { " " };
    format!("{number}{space}{unit}")
}

fn hint(value: f64, unit: &str) -> &'static str {
    if value > 0.0 && value.is_finite() && !unit.is_empty() {
        "; is it in another unit?"
    } else {
        ""
    }
}

/// A number as it would be typed, and not in hundreds of digits.
pub fn in_digits(value: f64) -> String {
    if value == 0.0 || (1e-9..1e15).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}
