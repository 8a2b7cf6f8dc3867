//! Arguments of `export`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::OverwriteArguments;

/// Arguments of `export`.
#[derive(Debug, Args)]
pub struct ExportArguments {
    /// A results folder, of an unfinished run too, or one of `simulate`
    pub folder: PathBuf,
    /// The format
    #[arg(long, value_name = "FORMAT")]
    pub format: ExportFormat,
    /// Which table of the folder
    #[arg(long, value_name = "TABLE", default_value = "labels")]
    pub table: ExportTable,
    /// The file [default: TABLE.parquet in the folder]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub overwrite: OverwriteArguments,
}

/// A table of numbers by case and method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ExportTable {
    /// The labels of a run
    Labels,
    /// The motion of cases, step by step, of `simulate`
    History,
    /// Their rows as in labels
    Case,
    /// Their contacts with the wall
    Contacts,
    /// How far the whole string goes to the side
    String,
    /// The shapes of the string in a film
    Film,
}

impl ExportTable {
    /// The name of its file, without the ending.
    pub fn name(self) -> &'static str {
        match self {
            ExportTable::Labels => "labels",
            ExportTable::History => "history",
            ExportTable::Case => "case",
            ExportTable::Contacts => "contacts",
            ExportTable::String => "string",
            ExportTable::Film => "film",
        }
    }
}

/// What tables are exported as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ExportFormat {
    /// Apache Parquet, in a program that is built with `--features parquet`
    Parquet,
}
