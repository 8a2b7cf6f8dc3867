//! The results that are in a folder, for who would read them.

use std::path::Path;

use anyhow::Result;

use crate::commands::status::UsageError;
use crate::commands::terminal::Terminal;
use results::folder::{NoResults, ResultTables};

/// Refuses a path that is no folder, or a folder with neither results nor a log.
///
/// # Errors
/// What is missing.
pub fn refuse_empty(folder: &Path) -> Result<()> {
    results::folder::refuse_empty(folder).map_err(in_words)
}

/// The tables of a folder: of a finished run, or of one that is not, as far as it is.
///
/// # Errors
/// Where there are none, or they are not those that were written.
pub fn tables_of(folder: &Path, terminal: Terminal) -> Result<ResultTables> {
    let note = |note: String| terminal.complain(&format!("note: {note}"));
    ResultTables::open(folder, note).map_err(in_words)
}

fn in_words(error: NoResults) -> anyhow::Error {
    match error {
        NoResults::Unreadable(error) => error,
        _ => UsageError(error.to_string()).into(),
    }
}
