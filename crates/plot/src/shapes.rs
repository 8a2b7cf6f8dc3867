//! What a picture is made of. Every format is written from the same shapes.

use super::colours::{Colour, Fill};
use super::geometry::Pixel;
use super::lettering::TextLine;
use super::look::Paper;

/// Lengths of dashes and gaps in pixels; empty for a solid line.
pub(crate) type Dash = &'static [f64];

/// Dash patterns in the order in which lines get them.
pub(crate) const DASHES: [Dash; 6] = [
    &[],
    &[9.0, 5.0],
    &[2.0, 3.0],
    &[10.0, 3.0, 2.0, 3.0],
    &[18.0, 5.0],
    &[10.0, 3.0, 2.0, 3.0, 2.0, 3.0],
];

/// How a line looks. Its corners are round, so that sharp peaks grow no spikes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Stroke {
    pub colour: Colour,
    /// In pixels.
    pub width: f64,
    pub dash: Dash,
}

impl Stroke {
    /// An undashed line.
    pub const fn solid(colour: Colour, width: f64) -> Stroke {
        Stroke {
            colour,
            width,
            dash: &[],
        }
    }
}

/// What every format of a picture is written from.
#[derive(Debug, PartialEq)]
pub(crate) struct Drawing {
    /// Width and height, pixels.
    pub size: [f64; 2],
    pub paper: Option<Paper>,
    /// From the lowest to the uppermost, on white.
    pub shapes: Vec<Shape>,
}

/// One thing on a picture.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Shape {
    /// A line through points.
    Line { points: Vec<Pixel>, stroke: Stroke },
    /// A filled polygon.
    Polygon { corners: Vec<Pixel>, fill: Fill },
    /// The outline of a circle.
    Ring {
        centre: Pixel,
        radius: f64,
        stroke: Stroke,
    },
    /// A filled circle.
    Disc {
        centre: Pixel,
        radius: f64,
        colour: Colour,
    },
    /// A line of black text.
    Text(TextLine),
}
