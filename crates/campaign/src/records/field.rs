//! What a field of `labels.csv` holds.

use std::borrow::Cow;
use std::fmt;

use serde::{Serialize, Serializer};

/// What a column holds, where a row has anything there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Names.
    Text,
    /// Numbers.
    Number,
    /// Numbers of things, counted from 0.
    Count,
    /// `true` or `false`.
    Flag,
}

/// A field of a row; written, that is its text in the table.
#[derive(Debug, Clone, PartialEq)]
pub enum Field<'a> {
    /// Empty.
    Nothing,
    /// A name, or several.
    Text(Cow<'a, str>),
    /// A number, in the unit that the column names.
    Number(f64),
    /// A number of things.
    Count(usize),
    /// Whether something is so.
    Flag(bool),
}

impl Field<'_> {
    /// The number or count that it holds, if it does.
    pub fn number(&self) -> Option<f64> {
        match self {
            Field::Number(number) => Some(*number),
            Field::Count(count) => Some(*count as f64),
            Field::Nothing | Field::Text(_) | Field::Flag(_) => None,
        }
    }
}

impl fmt::Display for Field<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Field::Nothing => Ok(()),
            Field::Text(text) => f.write_str(text),
            Field::Number(number) => write!(f, "{number}"),
            Field::Count(count) => write!(f, "{count}"),
            Field::Flag(flag) => write!(f, "{flag}"),
        }
    }
}

/// In a document, a field of nothing is null, and so is a number that is not finite.
impl Serialize for Field<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Field::Nothing => serializer.serialize_none(),
            Field::Text(text) => serializer.serialize_str(text),
            Field::Number(number) => serializer.serialize_f64(*number),
            Field::Count(count) => count.serialize(serializer),
            Field::Flag(flag) => serializer.serialize_bool(*flag),
        }
    }
}

impl<'a> From<&'a str> for Field<'a> {
    fn from(text: &'a str) -> Self {
        Field::Text(text.into())
    }
}

impl From<String> for Field<'_> {
    fn from(text: String) -> Self {
        Field::Text(text.into())
    }
}

impl From<f64> for Field<'_> {
    fn from(number: f64) -> Self {
        Field::Number(number)
    }
}

impl From<usize> for Field<'_> {
    fn from(count: usize) -> Self {
        Field::Count(count)
    }
}

impl From<bool> for Field<'_> {
    fn from(flag: bool) -> Self {
        Field::Flag(flag)
    }
}

impl<'a, T: Into<Field<'a>>> From<Option<T>> for Field<'a> {
    fn from(value: Option<T>) -> Self {
        value.map_or(Field::Nothing, Into::into)
    }
}
