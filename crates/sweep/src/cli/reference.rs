//! Arguments of `reference`.

use std::path::PathBuf;

use clap::Args;

use super::values::{parse_axis, parse_margin, sweep_file};
use super::{MemoryArguments, OverwriteArguments};
use campaign::quantities::Axis;

/// Arguments of `reference`.
#[derive(Debug, Args)]
pub struct ReferenceArguments {
    /// A results folder, of an unfinished run too
    pub folder: PathBuf,
    /// By which part of its value each axis of a case is changed, both ways
    #[arg(long, default_value = "5%", value_parser = parse_margin)]
    pub margin: f64,
    /// Axes to change [default: all]
    #[arg(long, value_name = "AXES", value_delimiter = ',', value_parser = parse_axis)]
    pub along: Vec<Axis>,
    /// The reference [default: reference.csv in the folder]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub overwrite: OverwriteArguments,
    /// The sweep file of the results [default: that of their manifest.json]
    #[arg(long, value_name = "FILE", value_parser = sweep_file())]
    pub sweep: Option<PathBuf>,
    /// Threads, at most 8 a core [default: $SLURM_CPUS_PER_TASK, $SLURM_CPUS_ON_NODE, all cores]
    #[arg(long)]
    pub jobs: Option<usize>,
    #[command(flatten)]
    pub memory: MemoryArguments,
}
