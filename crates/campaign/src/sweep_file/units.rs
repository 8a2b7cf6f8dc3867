//! Keys in oilfield units: read as those in SI units that they are twins of.

use toml::Value;

use super::schema::is_key;
use crate::quantities::{Axis, in_si};

/// Of an axis, what has its unit.
const WITH_UNIT: [&str; 7] = [
    "from",
    "to",
    "values",
    "mean",
    "standard_deviation",
    "median",
    "mode",
];

/// A key in SI units for one in others, and the factors of its numbers; `None` for any other.
pub fn key_in_si(key: &str) -> Option<(String, &'static [f64])> {
    in_si(key, |known| {
        is_key(known) || Axis::from_name(known).is_some()
    })
}

/// Multiplies the numbers of a value: rows of numbers one by one, of the table of an axis those
/// that have its unit. What is no number stays, to be refused where it is read.
pub fn scale(value: &mut Value, factors: &[f64]) {
    match value {
        Value::Float(number) => *number *= factors[0],
        Value::Integer(number) => *value = Value::Float(*number as f64 * factors[0]),
        Value::Array(items) => {
            for (index, item) in items.iter_mut().enumerate() {
                match item {
                    Value::Array(_) => scale(item, factors),
                    _ => scale(item, &factors[index.min(factors.len() - 1)..]),
                }
            }
        }
        Value::Table(table) => {
            for key in WITH_UNIT {
                if let Some(value) = table.get_mut(key) {
                    scale(value, factors);
                }
            }
        }
        _ => {}
    }
}
