//! Arguments of `run`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::WorkArguments;
use super::values::sweep_file;
use campaign::engine::{RunOptions, Shard};

/// Arguments of `run`.
#[derive(Debug, Args)]
pub struct RunArguments {
    /// The sweep file, or - for standard input
    #[arg(value_parser = sweep_file())]
    pub file: PathBuf,
    /// Results folder [default: results/NAME, by the name of the sweep file]
    #[arg(long)]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub work: WorkArguments,
    /// Say what would run and why, and stop
    #[arg(long)]
    pub dry_run: bool,
    /// Run only part I (from 0) of N [default folder: results/NAME/shard-I-of-N]
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Begin anew, over the results of an earlier run or a part of it
    #[arg(long)]
    pub fresh: bool,
    /// Continue after a case without an answer, and list it in failures.csv (the default)
    #[arg(long, conflicts_with = "fail_fast")]
    pub keep_going: bool,
    /// Stop at the first case that gives no answer
    #[arg(long)]
    pub fail_fast: bool,
    /// Simulate every case to its end, even where the rest is certain or settled
    #[arg(long)]
    pub full: bool,
    /// Only warn of a method whose margin says that a stuck site chatters
    #[arg(long)]
    pub allow_unstable: bool,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
    /// How to tell of progress on the error stream
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    pub log: LogFormat,
}

impl RunArguments {
    /// What of them the results depend on.
    pub fn options(&self) -> RunOptions {
        RunOptions {
            full: self.full,
            allow_unstable: self.allow_unstable,
        }
    }
}

/// How progress is reported.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum LogFormat {
    /// For people: a bar on a terminal, lines elsewhere
    Text,
    /// One JSON object a line
    Json,
}
