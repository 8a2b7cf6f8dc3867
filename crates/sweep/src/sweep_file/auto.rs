//! Keys that give a number or leave it to a rule.

use serde::{Deserialize, Deserializer, Serialize};

use super::number_or::NumberOr;

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
