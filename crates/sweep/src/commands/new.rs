//! `sweep new`: a sweep file to start from.

use anyhow::{Result, bail};

use super::status::{Status, UsageError};
use super::terminal::say;
use crate::cli::NewArguments;
use crate::output::write_atomically;

/// The file, which runs as it is. A test switches on each of its settings.
const TEMPLATE: &str = include_str!("new.toml");

/// Writes a commented sweep file.
pub fn new(arguments: &NewArguments) -> Result<Status> {
    let file = arguments.file.display();
    if !arguments.force && arguments.file.symlink_metadata().is_ok() {
        bail!(UsageError(format!(
            "{file} is there already: give another name, or --force to write over it"
        )));
    }
    write_atomically(&arguments.file, TEMPLATE.as_bytes())?;
    say(&format!(
        "{file} is written: put in your own numbers, then try\n  \
         sweep inspect {file}\n  \
         sweep run {file}\n"
    ))?;
    Ok(Status::Complete)
}
