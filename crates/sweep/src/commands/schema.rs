//! `sweep schema`: the JSON Schema of sweep files.

use anyhow::Result;

use super::status::Status;
use super::terminal::say;
use campaign::sweep_file::schema::of_sweep_files;

/// Prints it.
///
/// # Errors
/// Where standard output cannot be written.
pub fn schema() -> Result<Status> {
    say(&format!("{:#}\n", of_sweep_files()))?;
    Ok(Status::Complete)
}
