//! Folders of results.
//!
//! ```text
//!   log        each case kept as done, so that a run continues from where it was stopped
//!    │
//!   folder     labels.csv, failures.csv, records.jsonl.gz, manifest.json
//!    │
//!   traced     the limits of a traced design
//!   analysis   how often, how surely, and which axis decides
//!   window     where no limit is near
//! ```
//!
//! `files` writes whole files or none, in folders that are locked meanwhile.

pub mod analysis;
pub mod files;
pub mod folder;
pub mod log;
pub mod traced;
pub mod window;
