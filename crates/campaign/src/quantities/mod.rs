//! The quantities of a sweep that a design may vary: their names, units, ranges and
//! symbols, in one table; and the field units that these and other numbers may be given and
//! shown in, in another.
//!
//! ```
//! use campaign::quantities::{Axis, Units};
//!
//! let axis = Axis::from_name("weight_on_bit_kn").ok_or("it has a name")?;
//! let unit = axis.unit(Units::Field);
//! assert_eq!((unit.name.as_str(), unit.text(100.0, 1)), ("klbf", "22.48 klbf".to_owned()));
//! assert!(axis.check(50.0).is_ok());
//! // A name in other units is that of the same axis.
//! let (same, per_unit) = Axis::from_field_name("weight_on_bit_klbf").ok_or("it has a name")?;
//! assert_eq!(same, axis);
//! assert!((per_unit - 4.448).abs() < 1e-3);
//! # Ok::<(), &str>(())
//! ```

mod axis;
mod field_units;
mod numbered;
mod range;
mod table;
mod units;

pub use axis::{Axis, RockConstant, StringAxis, TubeMeasure, WallQuantity};
pub use field_units::{
    FOOT, FORCE, IMPULSE, INCH, INERTIA, INTEGRAL_GAIN, LENGTH, POUND, POUND_FORCE,
    PROPORTIONAL_GAIN, RATE, STRESS, TORQUE, TWINS, Twin, WIDTH, in_si, shown_as, twins_of,
    unit_of,
};
pub use range::{in_digits, within};
pub use table::LONGEST_STRING;
pub use units::{RPM, Unit, Units};
