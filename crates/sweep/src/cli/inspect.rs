//! Arguments of `inspect`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::values::{parse_order, sweep_file};
use super::{DocumentArguments, PictureArguments, WorkArguments};

/// Arguments of `inspect`.
#[derive(Debug, Args)]
pub struct InspectArguments {
    /// The sweep file, or - for standard input
    #[arg(value_parser = sweep_file())]
    pub file: PathBuf,
    /// Folder for pictures and tables [default: results/NAME, by the name of the sweep file]
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Show natural frequencies, critical speeds and shapes of the N lowest modes [default N: 6]
    #[arg(
        long,
        value_name = "N",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "6",
        value_parser = clap::value_parser!(u8).range(1..=30)
    )]
    pub modes: Option<u8>,
    /// With --modes: what shakes the string, in multiples of its surface speed
    #[arg(
        long,
        value_name = "ORDERS",
        value_delimiter = ',',
        default_value = "1,2,3",
        requires = "modes",
        value_parser = parse_order
    )]
    pub orders: Vec<f64>,
    /// Of a string at rest in its hole: what holds its bit sideways [default: its wall, where it is a
    /// site]
    #[arg(long, value_enum)]
    pub bit: Option<BitHolder>,
    /// Write impulse and frequency responses and modes as CSV into the folder
    #[arg(long)]
    pub csv: bool,
    #[command(flatten)]
    pub document: DocumentArguments,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub work: WorkArguments,
}

/// What holds a bit sideways.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum BitHolder {
    /// The wall, which it may leave.
    Contact,
    /// What it cuts, in the middle of the hole.
    Pinned,
    /// Nothing.
    Free,
}

impl From<BitHolder> for statics::Bit {
    fn from(holder: BitHolder) -> Self {
        match holder {
            BitHolder::Contact => Self::Contact,
            BitHolder::Pinned => Self::Pinned,
            BitHolder::Free => Self::Free,
        }
    }
}
