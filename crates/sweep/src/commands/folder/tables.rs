//! The results that are in a folder, for who would read them.

use std::path::Path;

use anyhow::{Result, bail};

use super::damage::refuse_damaged;
use super::names::{LOG, MANIFEST};
use crate::commands::status::UsageError;
use crate::commands::terminal::Terminal;
use results::folder::ResultTables;

/// Refuses a path that is no folder, or a folder with neither results nor a log.
///
/// # Errors
/// What is missing.
pub fn refuse_empty(folder: &Path) -> Result<()> {
    let folder_name = folder.display();
    if !folder.is_dir() {
        bail!(UsageError(format!("{folder_name} is not a folder")));
    }
    if !folder.join(LOG).exists() && !folder.join(MANIFEST).exists() {
        bail!(UsageError(format!(
            "{folder_name} holds no results: there is no manifest.json in it"
        )));
    }
    Ok(())
}

/// The tables of a folder: of a finished run, or of one that is not, as far as it is.
///
/// # Errors
/// Where there are none, or they are not those that were written.
pub fn tables_of(folder: &Path, terminal: Terminal) -> Result<ResultTables> {
    refuse_empty(folder)?;
    let log = folder.join(LOG);
    if log.exists() {
        let Some(tables) = ResultTables::so_far(&log)? else {
            bail!(UsageError(format!(
                "{} holds a run that has only just begun ({LOG}): the same `sweep run` as before \
                 continues it",
                folder.display()
            )));
        };
        return Ok(tables);
    }
    let tables = ResultTables::finished(folder)?;
    refuse_damaged(&tables.manifest, folder, terminal)?;
    Ok(tables)
}
