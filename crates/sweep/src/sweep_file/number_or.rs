//! Values that are a number or a text that stands for one.

use std::fmt;

use serde::de::{Error, Unexpected, Visitor};

/// Reads such a value.
pub struct NumberOr<Value> {
    /// What is meant, as a user is told.
    pub expected: &'static str,
    /// What a number means.
    pub of_number: fn(f64) -> Value,
    /// What a text means, if anything.
    pub of_text: fn(&str) -> Option<Value>,
}

impl<T> Visitor<'_> for NumberOr<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.expected)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        (self.of_text)(text).ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))
    }

    fn visit_f64<E>(self, value: f64) -> Result<T, E> {
        Ok((self.of_number)(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<T, E> {
        Ok((self.of_number)(value as f64))
    }
}
