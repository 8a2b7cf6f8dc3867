//! What becomes of a case by a method: its record, what that makes certain, and the table of the
//! columns in which it is written, read, drawn and handed to Python.
//!
//! ```
//! use campaign::quantities::Units;
//! use campaign::records::ResultColumn;
//! use sim::Motion;
//!
//! let column = ResultColumn::named("peak_radius_mm").ok_or("it is measured")?;
//! assert_eq!((column.words, column.motion), ("Greatest radius", Some(Motion::Lateral)));
//! assert_eq!(column.unit(Units::Field).name, "in");
//! # Ok::<(), &str>(())
//! ```

mod column;
mod columns;
mod field;
mod measure;
mod record;
mod verdict;
mod wall_push;
mod whirl;

pub use column::{Group, Needs, RecordRow, ResultColumn, to_kn, to_m_h, to_mm, to_rpm, to_turns};
pub use columns::{
    COLUMNS, FAILED, FOUND_ROUNDS, FOUND_SITES, MISFIT, MOTOR_STALLED, PUSH_COLUMNS, RENAMED,
    STICK_SLIP_MARGIN, WHIRL_AGREES, is_of_results, name_now,
};
pub use field::{Field, Kind};
pub use measure::Measure;
pub use record::{ByStart, Failure, Found, Record, certified};
pub use verdict::{Certainty, Certified, FINER, MotionVerdict, Verdict, certainty, verdict};
pub use wall_push::{WallPush, strength};
pub use whirl::{Whirl, is_whirl};
