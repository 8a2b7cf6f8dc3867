//! `sweep new`: a sweep file to start from.

use std::path::Path;

use anyhow::{Result, bail};

use super::status::{Status, UsageError};
use super::terminal::say;
use campaign::sweep_file::TEMPLATE;
use campaign::words::shell_word;
use results::files::write_atomically;

/// Writes a commented sweep file.
pub fn new(path: &Path, force: bool) -> Result<Status> {
    let file = path.display();
    if !force && path.symlink_metadata().is_ok() {
        bail!(UsageError(format!(
            "{file} is there already: give another name, or --force to write over it"
        )));
    }
    write_atomically(path, TEMPLATE.as_bytes())?;
    let word = shell_word(&file.to_string());
    say(&format!(
        "{file} is written: put in your own numbers, then try\n  \
         sweep inspect {word}\n  \
         sweep run {word}\n"
    ))?;
    Ok(Status::Complete)
}
