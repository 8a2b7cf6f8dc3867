//! The files of a results folder.

mod boundary;
mod cases;
mod cells;
mod envelope;
mod files;
mod labels;
mod manifest;
mod results;
mod whirl_limit;

pub use boundary::{Boundary, StickSlipPoint, boundary, read_boundary, write_boundary};
pub use cases::{CaseReader, CaseRows};
pub use cells::{Cells, Extent};
pub use envelope::Envelope;
pub use files::{AtomicFile, write_atomically};
pub use labels::{FAILURES_HEADER, LabelRow, labels_row, read_labels};
pub use manifest::{Manifest, MethodRecord, differences, meaning};
pub use results::{Counted, Tally, write_tables};
pub use whirl_limit::{rolling_bound, rolling_envelope, rolling_whirls};
