//! The sweep file as it is written: its text with its bases, its keys, and errors with
//! file, line and key. What the keys mean together is the business of `plan`.
//!
//! What is wrong is reported with its line and its key:
//!
//! ```
//! use campaign::Campaign;
//!
//! let text = "[string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = -1\n";
//! let refused = Campaign::open("my.toml".as_ref(), &[], &|_, _| Ok(text.to_owned()));
//! let error = refused.err().ok_or("it is no sweep file")?;
//! assert_eq!(error.file(), std::path::Path::new("my.toml"));
//! assert!(error.to_string().starts_with("my.toml"));
//! # Ok::<(), &str>(())
//! ```

mod bha_sheet;
pub mod bit;
mod change;
pub mod compare;
pub mod design;
mod error;
pub mod feed;
pub mod file;
mod in_file_units;
pub mod lateral;
pub mod map;
pub mod methods;
pub mod motor;
mod named_table;
mod number_or;
mod placed;
mod recording;
mod rivals;
pub mod schema;
mod source;
mod start;
pub mod string;
mod survey;
pub mod top_drive;
pub mod units;
pub mod well;
pub mod wording;

pub use bha_sheet::{SheetNotes, ToolKind, diameter_in_name, put_sections};
pub use bit::{BitTable, ContactName, CuttingTable, LawTable, RockName};
pub use change::NoPlace;
pub use compare::{CompareTable, Extreme, TraceName};
pub use design::{
    AxisRange, DesignKind, DesignTable, DistributionName, PointsName, Spacing, TRACE_TOLERANCE,
};
pub use error::SweepFileError;
pub use feed::{FeedName, FeedTable};
pub use file::FileContent;
pub use lateral::{
    BendingTable, EccentricMassTable, ImpulseTable, MassForm, SiteTable, SitesName, SupportName,
    ToolTable,
};
pub use map::MarkTable;
pub use methods::MethodName;
pub use motor::MotorTable;
pub use number_or::{Accuracy, AutoOr, per_cent};
pub use recording::read_series;
pub use source::{Source, TextOf};
pub use start::StartName;
pub use string::{SectionTable, TubeTable};
pub use survey::{SurveyNotes, read_survey};
pub use top_drive::{ControllerName, TopDriveTable};
pub use well::{AxialForceTable, HoleTable, PressedByName};
pub use wording::{UnknownAxis, axis_in_units, axis_named, nearest};

/// A sweep file to start from, which runs as it is: what `sweep new` writes. A test switches on each
/// of its settings.
pub const TEMPLATE: &str = include_str!("template.toml");
