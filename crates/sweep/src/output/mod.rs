//! The files of a results folder.

mod boundary;
mod files;
mod labels;
mod manifest;
mod results;

pub use boundary::{Boundary, boundary, read_boundary, whirl_bound, write_boundary};
pub use files::{AtomicFile, write_atomically};
pub use labels::{FAILURES_HEADER, LabelRow, labels_row, read_labels, stream_labels};
pub use manifest::{Manifest, differences, meaning};
pub use results::{Counted, Tally, write_tables};
