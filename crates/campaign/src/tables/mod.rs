//! Tables of other programs and people: sheets, surveys, recordings, lists of cases. As CSV or
//! as a workbook, with headings as people write them, a title above, units in a separate row,
//! decimal commas.
//!
//! `read` has the [cells](grid) of a file, [`table`] finds the row of its headings, [`columns`] what they
//! say, by [`heading`] and [`units`]; [`decimal`] reads numbers.

pub mod columns;
pub mod decimal;
pub mod grid;
pub mod hand_table;
mod header;
pub mod heading;
#[cfg(feature = "workbooks")]
mod open_document;
mod read;
pub mod table;
pub mod units;
#[cfg(feature = "workbooks")]
mod workbook;

pub use columns::{Column, Columns, Wanted};
pub use grid::Cell;
pub use heading::Heading;
pub use table::{Row, Table};
pub use units::Dimension;
