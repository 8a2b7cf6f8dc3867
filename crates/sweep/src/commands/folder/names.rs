//! Names of files in a results folder.

pub use results::folder::{LOG, MANIFEST};

/// The page about a folder.
pub const REPORT: &str = "report.html";
