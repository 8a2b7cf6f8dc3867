//! `sweep new`: a sweep file to start from.

use std::path::Path;

use anyhow::{Result, bail};

use super::outputs::{Output, refuse_to_lose};
use super::schema::{SCHEMA_BEGINNING, schema_text};
use super::status::{Status, UsageError};
use super::terminal::say;
use campaign::sweep_file::TEMPLATE;
use campaign::words::shell_word;
use results::files::write_atomically;

/// Its schema, where its first line says that it is.
const SCHEMA: &str = "sweep.schema.json";

/// Writes a commented sweep file, and the schema next to it where that is wanted.
pub fn new(path: &Path, with_schema: bool, force: bool) -> Result<Status> {
    let file = path.display();
    if !force && path.symlink_metadata().is_ok() {
        bail!(UsageError(format!(
            "{file} is there already: give another name, or --force to write over it"
        )));
    }
    let schema = path.with_file_name(SCHEMA);
    if with_schema {
        let beginnings = [SCHEMA_BEGINNING.as_bytes()];
        refuse_to_lose(&schema, Output::Beginning(&beginnings), force)?;
        write_atomically(&schema, schema_text().as_bytes())?;
    }
    write_atomically(path, TEMPLATE.as_bytes())?;
    let [word, schema] = [path, &schema].map(|path| shell_word(&path.display().to_string()));
    let for_editor = match with_schema {
        true => format!("{schema} is written, too: an editor that knows TOML completes its keys"),
        false => format!("for an editor that completes its keys\n  sweep schema > {schema}"),
    };
    say(&format!(
        "{file} is written: put in your own numbers, then try\n  \
         sweep inspect {word}\n  \
         sweep run {word}\n{for_editor}\n"
    ))?;
    Ok(Status::Complete)
}
