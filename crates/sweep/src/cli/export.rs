//! Arguments of `export`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::OverwriteArguments;

/// Arguments of `export`.
#[derive(Debug, Args)]
pub struct ExportArguments {
    /// A results folder, of an unfinished run too
    pub folder: PathBuf,
    /// The format
    #[arg(long, value_name = "FORMAT")]
    pub format: ExportFormat,
    /// The file [default: labels.parquet in the folder]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub overwrite: OverwriteArguments,
}

/// What labels are exported as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ExportFormat {
    /// Apache Parquet, in a program that is built with `--features parquet`
    Parquet,
}
