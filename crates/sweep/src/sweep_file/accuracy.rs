//! `accuracy`: the largest error wanted, as a part of one or in per cent.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize};

use super::number_or::NumberOr;

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
