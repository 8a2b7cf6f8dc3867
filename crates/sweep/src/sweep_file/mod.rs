//! The sweep file: read with its base, resolved to SI, refused with file, line
//! and key where it does not make sense.

mod accuracy;
mod bit;
mod change;
mod file;
#[cfg(test)]
mod fuzz;
#[cfg(test)]
mod guide;
mod lateral;
mod map;
mod placed;
mod resolve;
mod setting;
mod sheet;
mod source;
mod string;
#[cfg(test)]
mod tests;

pub use accuracy::{Accuracy, per_cent};
pub use file::{AxisRange, DesignKind, DesignTable, FileContent, MethodName, Spacing};
pub use lateral::{ImpulseSettings, LARGEST_IMPULSE, LateralSettings};
pub use resolve::{Bit, Conditions, MapMark, MapSettings, Sweep, Time, to_rpm};
pub use setting::Setting;
pub use sheet::{INCH, POUND_PER_FOOT};
pub use source::{Source, SweepFileError, TextOf, nearest};
