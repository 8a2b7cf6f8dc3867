//! Tables of other programs and people: sheets, surveys, recordings, lists of cases. As CSV or
//! as a workbook, with headings as people write them, a title above, units in a separate row,
//! decimal commas.
//!
//! `read` has the [cells](grid) of a file, [`table`] finds the row of its headings, [`columns`] what they
//! say, by [`heading`] and [`units`]; [`decimal`] reads numbers.
//!
//! Headings are found below a title, with their units:
//!
//! ```
//! use campaign::tables::Table;
//!
//! let text = "Well A\n\nMD [m];Inc [deg];Azi [deg]\n0;0;0\n30,5;1,2;45\n";
//! let is_header = |headings: &[campaign::tables::Heading]| headings.len() == 3;
//! let table = Table::read("survey.csv".as_ref(), &|_, _| Ok(text.to_owned()), &is_header)?;
//! assert_eq!(table.header_line, 3);
//! assert_eq!(table.rows.len(), 2);
//! assert_eq!(table.rows[1].number(0).ok(), Some(30.5));
//! # Ok::<(), String>(())
//! ```

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
