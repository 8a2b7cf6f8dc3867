//! Keys that give a number or leave it to a rule.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize};

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
        struct Visitor;
        impl serde::de::Visitor<'_> for Visitor {
            type Value = AutoOr;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number or \"auto\"")
            }
            fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<AutoOr, E> {
                match text {
                    "auto" => Ok(AutoOr::Auto),
                    _ => Err(E::invalid_value(serde::de::Unexpected::Str(text), &self)),
                }
            }
            fn visit_f64<E>(self, value: f64) -> Result<AutoOr, E> {
                Ok(AutoOr::Given(value))
            }
            fn visit_i64<E>(self, value: i64) -> Result<AutoOr, E> {
                Ok(AutoOr::Given(value as f64))
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}
