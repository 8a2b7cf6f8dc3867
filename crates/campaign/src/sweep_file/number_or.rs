//! Values that are a number or a text that stands for one: an accuracy, `"auto"`.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error, Unexpected, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

/// Reads such a value.
struct NumberOr<Value> {
    /// What is meant, in messages.
    expected: &'static str,
    /// What a number means.
    of_number: fn(f64) -> Value,
    /// What a text means, if anything.
    of_text: fn(&str) -> Option<Value>,
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

    /// As JSON has whole numbers.
    fn visit_u64<E>(self, value: u64) -> Result<T, E> {
        Ok((self.of_number)(value as f64))
    }

    fn visit_i64<E>(self, value: i64) -> Result<T, E> {
        Ok((self.of_number)(value as f64))
    }
}

/// The largest error wanted, relative: 0.01 is one per cent.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Serialize)]
#[serde(transparent)]
pub struct Accuracy(pub f64);

impl fmt::Display for Accuracy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} %", per_cent(self.0))
    }
}

/// A part of one in per cent, to three digits.
pub fn per_cent(part: f64) -> f64 {
    let per_cent = 100.0 * part;
    format!("{per_cent:.2e}").parse().unwrap_or(per_cent)
}

impl<'de> Deserialize<'de> for Accuracy {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberOr {
            expected: "an accuracy such as \"1 %\" or 0.01",
            of_number: Accuracy,
            of_text: |text| {
                let number = text.strip_suffix('%')?.trim_end();
                Some(Accuracy(number.parse::<f64>().ok()? / 100.0))
            },
        })
    }
}

impl JsonSchema for Accuracy {
    fn schema_name() -> Cow<'static, str> {
        "Accuracy".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "anyOf": [
                { "type": "number", "minimum": 1e-4, "maximum": 0.5 },
                { "type": "string", "pattern": "^[0-9]*[.]?[0-9]+([eE][+-]?[0-9]+)? *%$" },
            ],
        })
    }
}

/// A number, or `"auto"`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum AutoOr {
    /// By rule.
    #[default]
    Auto,
    /// As given.
    #[serde(untagged)]
    Given(f64),
}

impl<'de> Deserialize<'de> for AutoOr {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberOr {
            expected: "a number or \"auto\"",
            of_number: AutoOr::Given,
            of_text: |text| (text == "auto").then_some(AutoOr::Auto),
        })
    }
}

/// A range of its key is one of the number.
impl JsonSchema for AutoOr {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "AutoOr".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "type": "number" }, { "const": "auto" }] })
    }
}

/// Whether a number that is zero by default is not given.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
pub fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

/// Whether what is left out by default is not asked for.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
pub fn is_false(value: &bool) -> bool {
    !*value
}

/// Whether a choice that has a default is that.
pub fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}
