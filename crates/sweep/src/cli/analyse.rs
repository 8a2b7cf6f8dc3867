//! Arguments of `analyse`.

use std::path::PathBuf;

use clap::Args;
use sim::Label;

use super::values::{
    AxesOfCells, PictureFile, parse_axes, parse_picture, parse_regime, parse_width,
};
use super::{DocumentArguments, OverwriteArguments};

/// Arguments of `analyse`.
#[derive(Debug, Args)]
pub struct AnalyseArguments {
    /// A results folder, or shards of one sweep
    #[arg(required = true)]
    pub folders: Vec<PathBuf>,
    /// Count over ranges of an axis, or of two: X or X,Y; may be repeated [default: each axis]
    #[arg(long, value_name = "AXES", value_parser = parse_axes)]
    pub by: Vec<AxesOfCells>,
    /// Ranges of an axis that has more than a few values
    #[arg(long, default_value = "10", value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub bins: u16,
    /// Say how many more cases an interval no wider than this takes, e.g. 0.02
    #[arg(long, value_parser = parse_width)]
    pub width: Option<f64>,
    /// Write all counts and intervals to a CSV file
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Write Sobol's indices of a sensitivity design to a CSV file
    #[arg(long, value_name = "FILE")]
    pub indices: Option<PathBuf>,
    /// Draw how likely a regime is over the axes of --by, as .svg or .png
    #[arg(long, value_name = "FILE", value_parser = parse_picture, requires = "by")]
    pub picture: Option<PictureFile>,
    #[command(flatten)]
    pub overwrite: OverwriteArguments,
    /// Which regime to draw, by its label [default: stick-slip, sustained whirl]
    #[arg(long, value_name = "LABEL", value_parser = parse_regime, requires = "picture")]
    pub regime: Option<Label>,
    #[command(flatten)]
    pub document: DocumentArguments,
}
