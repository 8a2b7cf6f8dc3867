//! The sweep file as it is written: its text with its bases, its keys, and errors with
//! file, line and key. What the keys mean together is the business of `plan`.

mod bit;
mod change;
mod design;
mod error;
mod file;
#[cfg(test)]
mod guide;
mod lateral;
mod map;
mod methods;
mod number_or;
mod placed;
mod source;
mod string;
mod wording;

pub use bit::{BitTable, LawTable, RockName};
pub use design::{AxisRange, DesignKind, DesignTable, Spacing};
pub use error::SweepFileError;
pub use file::FileContent;
pub use lateral::{BendingTable, EccentricMassTable, ImpulseTable, SupportName};
pub use map::MarkTable;
pub use methods::MethodName;
pub use number_or::{Accuracy, AutoOr, per_cent};
pub use source::{Source, TextOf};
pub use string::SectionTable;
pub use wording::nearest;
