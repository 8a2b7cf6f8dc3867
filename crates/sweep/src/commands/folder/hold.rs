//! A results folder in the hand of one command.

use std::path::Path;

use anyhow::{Context, Result, anyhow};

use super::names::LOG;
use crate::commands::terminal::Terminal;
use campaign::text_file::unreadable;
use results::files::{FolderLock, LockError, has_left, remove_left};

/// Keeps other commands from writing into a folder, as long as the lock is held, and
/// removes what killed ones left half written. An error names the file that is to
/// be written.
///
/// # Errors
/// Where another command writes there, or it cannot be written.
pub fn hold(folder: &Path, file: &str, terminal: Terminal) -> Result<FolderLock> {
    let lock = FolderLock::take(folder).map_err(|error| match error {
        LockError::Taken if folder.join(LOG).exists() => anyhow!(
            "another run is writing {}; wait for it, or choose another --out",
            folder.join(LOG).display()
        ),
        LockError::Taken => anyhow!("another command is writing {}", folder.display()),
        LockError::File(error) => {
            let path = folder.join(file);
            anyhow!("{} cannot be written: {error}", path.display())
        }
    })?;
    if let Some(error) = lock.unsupported() {
        terminal.complain(&format!(
            "warning: the file system of {} has no locks ({error}): see to it that no other \
             command writes there",
            folder.display()
        ));
    }
    remove_left(folder).with_context(|| unreadable(folder))?;
    Ok(lock)
}

/// Removes what killed commands left in a folder that is only read, if no other command writes
/// there and the folder is writable.
pub fn tidy(folder: &Path) {
    if !has_left(folder).is_ok_and(|has_left| has_left) {
        return;
    }
    if let Ok(_lock) = FolderLock::take(folder) {
        let _ = remove_left(folder);
    }
}
