//! Names of files in a results folder.

/// The log of a run that is not finished.
pub const LOG: &str = "cases.log";

/// What a run that is finished says of itself.
pub const MANIFEST: &str = "manifest.json";

/// The page about a folder.
pub const REPORT: &str = "report.html";
