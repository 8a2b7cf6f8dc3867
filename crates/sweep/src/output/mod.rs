//! The files of a results folder.

mod boundary;
mod cases;
mod cells;
mod failures;
mod files;
mod labels;
mod manifest;
mod results;

pub use boundary::{
    Boundary, StickSlipPoint, boundary, read_boundary, whirl_bound, write_boundary,
};
pub use cases::{CaseReader, CaseRows};
pub use cells::{Cells, Extent};
pub use failures::FAILURES_HEADER;
pub use files::{AtomicFile, write_atomically};
pub use labels::{LabelRow, labels_header, labels_row, read_labels};
pub use manifest::{Manifest, MethodRecord, differences, meaning};
pub use results::{Counted, Tally, write_tables};
