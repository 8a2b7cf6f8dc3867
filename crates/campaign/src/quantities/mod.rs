//! The quantities of a sweep that a design may vary: their names, units, ranges and
//! symbols, in one table; and the field units that these and other numbers may be given and
//! shown in, in another.

mod axis;
mod field_units;
mod numbered;
mod range;
mod table;
mod units;

pub use axis::{Axis, RockConstant, StringAxis, TubeMeasure, WallQuantity};
pub use field_units::{
    FOOT, FORCE, IMPULSE, INCH, INERTIA, INTEGRAL_GAIN, LENGTH, POUND, POUND_FORCE,
    PROPORTIONAL_GAIN, TORQUE, TWINS, Twin, WIDTH, in_si, shown_as, twins_of, unit_of,
};
pub use range::{in_digits, within};
pub use table::LONGEST_STRING;
pub use units::{RPM, Unit, Units};
