//! The quantities of a sweep that a design may vary: their names, units, ranges and
//! symbols, in one table.

mod axis;
mod field_units;
mod numbered;
mod range;
mod table;

pub use axis::{Axis, StringAxis, TubeMeasure};
#[cfg(test)]
pub use field_units::TWINS;
pub use field_units::{INCH, POUND, in_si};
pub use range::{in_digits, within};
pub use table::LONGEST_STRING;
