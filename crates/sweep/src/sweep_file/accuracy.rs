//! `accuracy`: the largest error wanted, as a part of one or in per cent.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize};

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
        deserializer.deserialize_any(Visitor)
    }
}

struct Visitor;

impl serde::de::Visitor<'_> for Visitor {
    type Value = Accuracy;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an accuracy such as \"1 %\" or 0.01")
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Accuracy, E> {
        let number = text.strip_suffix('%').map(str::trim_end);
        let per_cent = number.and_then(|number| number.parse::<f64>().ok());
        per_cent
            .map(|per_cent| Accuracy(per_cent / 100.0))
            .ok_or_else(|| E::invalid_value(serde::de::Unexpected::Str(text), &self))
    }

    fn visit_f64<E>(self, value: f64) -> Result<Accuracy, E> {
        Ok(Accuracy(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Accuracy, E> {
        Ok(Accuracy(value as f64))
    }
}
