//! Arguments of `check`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::values::sweep_file;
use super::{MemoryArguments, OverwriteArguments};

/// Arguments of `check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// The sweep file that gives the setting, or - for standard input
    #[arg(value_parser = sweep_file())]
    pub file: PathBuf,
    /// Reference labels: columns case, method, the axes, torsion
    pub reference: PathBuf,
    #[command(flatten)]
    pub output: CheckOutput,
    /// Threads, at most 8 a core [default: $SLURM_CPUS_PER_TASK, $SLURM_CPUS_ON_NODE, all cores]
    #[arg(long)]
    pub jobs: Option<usize>,
    #[command(flatten)]
    pub memory: MemoryArguments,
}

/// How `check` says what it found.
#[derive(Debug, Args)]
pub struct CheckOutput {
    /// How to say which labels differ
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    format: CheckFormat,
    /// The same as --format json
    #[arg(long, conflicts_with = "format")]
    json: bool,
    /// Write that to a file, and lines for people to standard output
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub overwrite: OverwriteArguments,
}

impl CheckOutput {
    /// The format that is asked for.
    pub fn format(&self) -> CheckFormat {
        if self.json {
            CheckFormat::Json
        } else {
            self.format
        }
    }
}

/// Who reads what `check` says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CheckFormat {
    /// People: a line for each label that differs
    Human,
    /// GitHub: an annotation for each, at its line of the reference
    Github,
    /// What shows tests: JUnit XML with a test for each label
    Junit,
    /// Programs: one JSON document
    Json,
}
