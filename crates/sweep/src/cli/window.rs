//! Arguments of `window`.

use std::path::PathBuf;

use clap::Args;

use super::DocumentArguments;
use super::values::{parse_order, parse_part, sweep_file};

/// Arguments of `window`.
#[derive(Debug, Args)]
pub struct WindowArguments {
    /// The sweep file, or - for standard input
    #[arg(value_parser = sweep_file())]
    pub file: PathBuf,
    /// Results folders of its string [default: results/NAME, by the name of the sweep file]
    pub folders: Vec<PathBuf>,
    /// Folder for window.svg, window.png and window.csv [default: the first results folder]
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// What shakes the string sideways, in multiples of its surface speed
    #[arg(long, value_name = "ORDERS", value_delimiter = ',', default_value = "1", value_parser = parse_order)]
    pub orders: Vec<f64>,
    /// Places that hold the string sideways, from the bit, in m or, with `units = "field"`, ft [default: the sites of the file]
    #[arg(long, value_name = "PLACES", value_delimiter = ',')]
    pub held_at: Option<Vec<f64>>,
    /// The part by which a critical speed and the wall's friction may be off
    #[arg(long, default_value_t = 0.1, value_parser = parse_part)]
    pub margin: f64,
    /// Of random cases, the part with vibration up to which a cell is safe
    #[arg(long, default_value_t = 0.1, value_parser = parse_part)]
    pub risk: f64,
    /// Ranges of either axis that random cases are counted in
    #[arg(long, default_value = "10", value_parser = clap::value_parser!(u16).range(2..=100))]
    pub bins: u16,
    /// Of a bit that cuts, axial chatter is safe as long as the bit stays in its rock
    #[arg(long)]
    pub accept_chatter: bool,
    /// The part of either axis that the best point keeps from every limit
    #[arg(long, default_value_t = 0.05, value_parser = parse_part)]
    pub clearance: f64,
    #[command(flatten)]
    pub document: DocumentArguments,
    /// Threads, at most 8 a core [default: $SLURM_CPUS_PER_TASK, $SLURM_CPUS_ON_NODE, all cores]
    #[arg(long)]
    pub jobs: Option<usize>,
}
