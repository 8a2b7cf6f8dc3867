//! `sweep export`: the labels of a results folder, or the history of a case, in another format. A
//! run does not write it: it continues from its log, and its tables are CSV.

#[cfg(feature = "parquet")]
mod parquet;

use anyhow::{Result, bail};

use super::folder::tables_of;
use super::outputs::{Output, refuse_to_lose};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use crate::cli::{ExportArguments, ExportFormat, ExportTable};
#[cfg(feature = "parquet")]
use parquet::write;

/// Exports a table.
pub fn export(arguments: &ExportArguments, terminal: Terminal) -> Result<Status> {
    match arguments.format {
        ExportFormat::Parquet => to_parquet(arguments, terminal),
    }
}

fn to_parquet(arguments: &ExportArguments, terminal: Terminal) -> Result<Status> {
    if cfg!(not(feature = "parquet")) {
        bail!(not_built());
    }
    let ExportArguments { folder, table, .. } = arguments;
    let name = table.name();
    // Holds the tables of a run that is not finished.
    let tables = match table {
        ExportTable::Labels => Some(tables_of(folder, terminal)?),
        _ => None,
    };
    let within = tables.as_ref().map_or(folder, |tables| &tables.folder);
    let csv = within.join(format!("{name}.csv"));
    if !csv.is_file() {
        bail!(UsageError(format!(
            "{} holds no {name}.csv, as `sweep simulate` writes it",
            folder.display()
        )));
    }
    let default = || folder.join(format!("{name}.parquet"));
    let out = arguments.out.clone().unwrap_or_else(default);
    let ours = Output::Beginning(&[b"PAR1"]);
    refuse_to_lose(&out, ours, arguments.overwrite.force)?;
    write(&csv, name, &out)?;
    say(&format!("{}\n", out.display()))?;
    Ok(Status::Complete)
}

/// How to get a program that has it.
fn not_built() -> UsageError {
    UsageError(
        "--format parquet: this program is built without it; those of releases have it, and \
         `cargo install --locked --path crates/sweep --features parquet` builds one"
            .to_owned(),
    )
}

#[cfg(not(feature = "parquet"))]
fn write(_: &std::path::Path, _: &str, _: &std::path::Path) -> Result<()> {
    Err(not_built().into())
}
