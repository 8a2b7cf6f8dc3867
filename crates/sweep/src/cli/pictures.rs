//! Arguments of pictures, which several commands have, and of `plot`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::values::{AxisRange, Length, parse_length, parse_range};

/// How pictures look.
#[derive(Debug, Args)]
pub struct PictureArguments {
    /// Width of pictures on paper, e.g. 90mm, 9cm, 3.5in, 255pt [default: as for a screen]
    #[arg(long, value_name = "LENGTH", value_parser = parse_length)]
    pub width: Option<Length>,
    /// With --width: the size of numbers and legends, e.g. 8pt
    #[arg(
        long,
        value_name = "LENGTH",
        default_value = "8pt",
        requires = "width",
        value_parser = parse_length
    )]
    pub font_size: Length,
    /// Formats of pictures, separated by commas
    #[arg(
        long,
        value_name = "FORMATS",
        value_delimiter = ',',
        default_value = "svg,png"
    )]
    pub format: Vec<PictureFormat>,
    /// Title that replaces those of the pictures; `none` for no title
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
}

/// Which part of a picture is shown.
#[derive(Debug, Args)]
pub struct RangeArguments {
    /// Ends of the horizontal axis, in its unit, e.g. 0..60; of a history, of time
    #[arg(
        long,
        value_name = "FROM..TO",
        allow_hyphen_values = true,
        value_parser = parse_range
    )]
    pub x_range: Option<AxisRange>,
    /// Ends of the vertical axis, in its unit; of a history, of its first quantity
    #[arg(
        long,
        value_name = "FROM..TO",
        allow_hyphen_values = true,
        value_parser = parse_range
    )]
    pub y_range: Option<AxisRange>,
}

/// A format of pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum PictureFormat {
    /// In vectors, for a page
    Svg,
    /// In pixels, twice as many as on a screen; with --width, 600 to the inch
    Png,
    /// In vectors, for paper
    Pdf,
}

impl PictureFormat {
    /// The ending of its files.
    pub fn ending(self) -> &'static str {
        match self {
            PictureFormat::Svg => "svg",
            PictureFormat::Png => "png",
            PictureFormat::Pdf => "pdf",
        }
    }
}

/// Arguments of `plot`.
#[derive(Debug, Args)]
pub struct PlotArguments {
    /// A results folder, of an unfinished run too
    pub folder: PathBuf,
    #[command(flatten)]
    pub picture: PictureArguments,
    #[command(flatten)]
    pub ranges: RangeArguments,
}
