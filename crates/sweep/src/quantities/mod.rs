//! The quantities of a sweep that a design may vary: their names, units, ranges and
//! symbols, in one table.

mod axis;
mod numbered;
mod range;
mod table;

pub use axis::{Axis, StringAxis, TubeMeasure};
pub use range::{in_digits, within};
pub use table::LONGEST_STRING;
