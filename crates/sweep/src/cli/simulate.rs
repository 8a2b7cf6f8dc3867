//! Arguments of `simulate`, and of its film.

use std::path::PathBuf;

use clap::Args;

use super::values::{parse_setting, sweep_file};
use super::{PictureArguments, RangeArguments, WorkArguments};
use campaign::quantities::Axis;

/// Arguments of `simulate`.
#[derive(Debug, Args)]
pub struct SimulateArguments {
    /// The sweep file, or - for standard input
    #[arg(value_parser = sweep_file())]
    pub file: PathBuf,
    /// Which of the sweep's cases, from 0; several are drawn together
    #[arg(long, value_name = "CASES", value_delimiter = ',', default_value = "0")]
    pub case: Vec<usize>,
    /// Set a quantity, e.g. surface_speed_rpm=0.1; may be repeated
    #[arg(long, value_name = "AXIS=VALUE", value_parser = parse_setting)]
    pub set: Vec<(Axis, f64)>,
    #[command(flatten)]
    pub film: FilmArguments,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub ranges: RangeArguments,
    /// Folder for the files [default: results/NAME, by the name of the sweep file]
    #[arg(long)]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub work: WorkArguments,
    /// The case of a run with --full: its numbers are those at its end
    #[arg(long)]
    pub full: bool,
    /// The case of a run with --allow-unstable, where axes change the string
    #[arg(long)]
    pub allow_unstable: bool,
}

/// Which snapshots `simulate` draws of the string in its hole.
#[derive(Debug, Args)]
pub struct FilmArguments {
    /// Draw the string in its hole from time to time, of the first case and method
    #[arg(long)]
    pub film: bool,
    /// With --film: how many frames, up to 60
    #[arg(
        long = "film-frames",
        value_name = "N",
        default_value = "12",
        requires = "film",
        value_parser = clap::value_parser!(u8).range(1..=60)
    )]
    pub frames: u8,
    /// With --film: time of its first frame, s [default: at the first contact]
    #[arg(long = "film-from", value_name = "TIME", requires = "film")]
    pub from: Option<f64>,
    /// With --film: time of its last frame, s [default: at the end]
    #[arg(long = "film-to", value_name = "TIME", requires = "film")]
    pub to: Option<f64>,
}

impl FilmArguments {
    /// How many frames are asked for.
    pub fn frames_asked(&self) -> usize {
        if self.film { self.frames.into() } else { 0 }
    }
}
