//! Why a string has no static state, or none that is found.

use thiserror::Error;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum StaticsError {
    /// A number that has to be finite and positive is not, or one that may be zero is negative.
    #[error("{quantity} of {value} is not that of a string in a hole")]
    Quantity {
        /// What it is, with its unit.
        quantity: &'static str,
        /// The number.
        value: f64,
    },
    /// There are no contacts.
    #[error("the string has no place where it may touch its hole")]
    NoContacts,
    /// A contact is not on the string.
    #[error("a contact {distance} m from the bit is not on a string of {length} m")]
    OffString {
        /// Its distance from the bit, m.
        distance: f64,
        /// Length of the string, m.
        length: f64,
    },
    /// Two contacts are closer to each other than an element may be short.
    #[error("two contacts are less than {least} m apart, {distance} m from the bit")]
    TooClose {
        /// The distance of one of them from the bit, m.
        distance: f64,
        /// The least distance between two, m.
        least: f64,
    },
    /// There are not as many coefficients of friction as contacts.
    #[error("{given} coefficients of friction are not those of {contacts} contacts")]
    OtherContacts {
        /// Coefficients.
        given: usize,
        /// Contacts.
        contacts: usize,
    },
    /// The bit is said to touch its hole, but has no clearance.
    #[error("the bit touches its hole, but no contact is 0 m from the bit")]
    NoContactAtBit,
    /// The survey ends above the bit.
    #[error("the survey ends at {depth} m, above the bit at {length} m")]
    SurveyTooShort {
        /// Where it ends, m.
        depth: f64,
        /// Length of the string, m.
        length: f64,
    },
    /// The string buckles between its contacts, if it is held at all of them.
    #[error(
        "under {weight_on_bit} N on the bit the string buckles between its contacts, even if held \
         at all of them"
    )]
    BucklesBetweenContacts {
        /// Weight on bit, N.
        weight_on_bit: f64,
    },
    /// Iteration does not end.
    #[error(
        "no static state is found under {weight_on_bit} N on the bit with a friction of {friction}"
    )]
    NotFound {
        /// Weight on bit, N.
        weight_on_bit: f64,
        /// Coefficient of friction.
        friction: f64,
    },
}

/// Refuses what is not finite and positive.
pub(crate) fn positive(quantity: &'static str, value: f64) -> Result<(), StaticsError> {
    match value.is_finite() && value > 0.0 {
        true => Ok(()),
        false => Err(StaticsError::Quantity { quantity, value }),
    }
}

/// Refuses what is not finite.
pub(crate) fn finite(quantity: &'static str, value: f64) -> Result<(), StaticsError> {
    match value.is_finite() {
        true => Ok(()),
        false => Err(StaticsError::Quantity { quantity, value }),
    }
}

/// Refuses what is not finite or negative.
pub(crate) fn not_negative(quantity: &'static str, value: f64) -> Result<(), StaticsError> {
    match value.is_finite() && value >= 0.0 {
        true => Ok(()),
        false => Err(StaticsError::Quantity { quantity, value }),
    }
}
