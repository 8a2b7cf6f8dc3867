//! `sweep schema`: the JSON Schema of sweep files.

use anyhow::Result;

use super::status::Status;
use super::terminal::say;
use campaign::sweep_file::schema::of_sweep_files;

/// How it begins.
pub const SCHEMA_BEGINNING: &str = "{\n  \"$defs\": {\n    \"Accuracy\"";

/// It as a file has it.
pub fn schema_text() -> String {
    format!("{:#}\n", of_sweep_files())
}

/// Prints it.
///
/// # Errors
/// Where standard output cannot be written.
pub fn schema() -> Result<Status> {
    say(&schema_text())?;
    Ok(Status::Complete)
}
