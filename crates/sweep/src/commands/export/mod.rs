//! `sweep export`: the labels of a results folder in another format. A run does not write it: it
//! continues from its log, and its tables are CSV.

#[cfg(feature = "parquet")]
mod parquet;

use anyhow::Result;

use super::status::Status;
use super::terminal::Terminal;
use crate::cli::{ExportArguments, ExportFormat};

/// Exports labels.
pub fn export(arguments: &ExportArguments, terminal: Terminal) -> Result<Status> {
    match arguments.format {
        ExportFormat::Parquet => to_parquet(arguments, terminal),
    }
}

#[cfg(feature = "parquet")]
fn to_parquet(arguments: &ExportArguments, terminal: Terminal) -> Result<Status> {
    let tables = super::folder::tables_of(&arguments.folder, terminal)?;
    let default = || arguments.folder.join("labels.parquet");
    let out = arguments.out.clone().unwrap_or_else(default);
    let ours = super::outputs::Output::Beginning(&[b"PAR1"]);
    super::outputs::refuse_to_lose(&out, ours, arguments.overwrite.force)?;
    parquet::write(&tables.folder.join("labels.csv"), &out)?;
    super::terminal::say(&format!("{}\n", out.display()))?;
    Ok(Status::Complete)
}

#[cfg(not(feature = "parquet"))]
fn to_parquet(_: &ExportArguments, _: Terminal) -> Result<Status> {
    anyhow::bail!(super::status::UsageError(
        "--format parquet: this program is built without it; build one that has it by `cargo \
         install --locked --path crates/sweep --features parquet`"
            .to_owned()
    ))
}
