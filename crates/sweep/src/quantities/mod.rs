//! The quantities of a sweep that a design may vary: their names, units, ranges and
//! symbols, in one table; and the field units that these and other numbers of a file may
//! be given in, in another.

mod axis;
mod field_units;
mod numbered;
mod range;
mod table;

pub use axis::{Axis, StringAxis, TubeMeasure};
#[cfg(test)]
pub use field_units::TWINS;
pub use field_units::{FOOT, INCH, POUND, POUND_FORCE, factor_of_recorded, in_si};
pub use range::{in_digits, within};
pub use table::LONGEST_STRING;
