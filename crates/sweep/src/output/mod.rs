//! The files of a results folder.

mod boundary;
mod files;
mod labels;
mod manifest;

pub use boundary::{Boundary, boundary, read_boundary, write_boundary};
pub use files::write_atomically;
pub use labels::{LabelRow, failures_csv, labels_csv, read_labels};
pub use manifest::{Manifest, meaning_hash};
