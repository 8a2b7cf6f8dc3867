//! The files of a results folder.

mod about;
mod boundary;
mod cases;
mod cells;
mod curves;
mod extent;
mod fractions;
mod integrity;
mod labels;
mod manifest;
mod motion;
mod results;
mod tables;

pub use crate::files::write_atomically;
pub use about::About;
pub use boundary::{Boundary, StickSlipPoint, boundary, whirl_bound, write_boundary};
pub use cases::{CaseReader, CaseRows};
pub use cells::Cells;
pub use curves::Curve;
pub use extent::Extent;
pub use fractions::Fractions;
pub use integrity::{Damage, PICTURES, TABLES};
pub use labels::{FAILURES_HEADER, LabelRow, labels_header, labels_row, labels_start, read_labels};
pub use manifest::{Manifest, MethodRecord, differences, meaning};
pub use motion::Motion;
pub use results::{Counted, Tally, write_tables};
pub use tables::ResultTables;
