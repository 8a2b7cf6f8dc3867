//! Arguments of `check`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::{MemoryArguments, OverwriteArguments};

/// Arguments of `check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// The sweep file that gives the setting
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
    pub format: CheckFormat,
    /// Write that to a file, and lines for people to standard output
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub overwrite: OverwriteArguments,
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
}
