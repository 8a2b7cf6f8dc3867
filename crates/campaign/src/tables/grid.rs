//! The cells of a file.

use std::borrow::Cow;

use super::decimal::{Decimals, NumberError, number_with};

/// Most columns that are read: each may be a heading, with a unit to look for.
pub const MOST_COLUMNS: usize = 1000;

/// A cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A text, which may be that of a number.
    Text(String),
    /// A number that a workbook has as one.
    Number(f64),
}

impl Cell {
    /// What it says.
    pub fn text(&self) -> Cow<'_, str> {
        match self {
            Self::Text(text) => Cow::Borrowed(text.as_str()),
            Self::Number(number) => Cow::Owned(number.to_string()),
        }
    }

    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        matches!(self, Self::Text(text) if text.is_empty())
    }

    /// Its number, in a file that writes fractions one way.
    ///
    /// # Errors
    /// Where it is not a number, or ambiguous.
    pub fn number(&self, decimals: Decimals) -> Result<f64, NumberError> {
        match self {
            Self::Number(number) => Ok(*number),
            Self::Text(text) => number_with(text, decimals),
        }
    }
}

/// A line of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Its number in the file, from 1.
    pub number: usize,
    /// Its cells.
    pub cells: Vec<Cell>,
    /// Whether it is a comment, and its cells are what that would be without its mark.
    pub is_comment: bool,
}

impl Line {
    /// Cells up to the last that is not empty.
    pub fn filled(&self) -> usize {
        let filled = self.cells.iter().rposition(|cell| !cell.is_empty());
        filled.map_or(0, |last| last + 1)
    }
}

/// The lines of a file that have any content.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TextGrid {
    /// They.
    pub lines: Vec<Line>,
    /// What separates the cells of a text, whose rows have one for each column.
    pub separator: Option<u8>,
}
