//! The files of a results folder.

mod boundary;
mod cases;
mod cells;
mod curves;
mod extent;
mod files;
mod fractions;
mod labels;
mod manifest;
mod motion;
mod results;

pub use boundary::{
    Boundary, StickSlipPoint, boundary, read_boundary, whirl_bound, write_boundary,
};
pub use cases::{CaseReader, CaseRows};
pub use cells::Cells;
pub use curves::Curve;
pub use extent::Extent;
pub use files::{AtomicFile, write_atomically};
pub use fractions::Fractions;
pub use labels::{FAILURES_HEADER, LabelRow, labels_row, read_labels};
pub use manifest::{Manifest, MethodRecord, differences, meaning};
pub use motion::Motion;
pub use results::{Counted, Tally, write_tables};
