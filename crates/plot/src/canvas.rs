//! The drawing surface: shapes and text in picture pixels.

use super::colours::{Colour, Fill};
use super::geometry::{Pixel, Rect};
use super::lettering::{Align, TextLine};
use super::look::{Look, Paper};
use super::picture::Picture;
use super::shapes::{Drawing, Shape, Stroke};
use super::text::{Block, TITLE_SIZE};

/// Distance from the middle of digits down to their baseline, in font sizes.
const MIDDLE_TO_BASELINE: f64 = 0.36;

/// The surface that [`draw_titled`] hands to its caller.
pub(crate) struct Canvas {
    shapes: Vec<Shape>,
}

/// The title of a picture, centred above it and as wide as it is, and the margin around
/// both.
pub(crate) struct Title {
    text: Block,
    /// Width of the picture.
    pub width: f64,
    margin: f64,
    paper: Option<Paper>,
}

impl Title {
    /// Breaks the text, or that which is asked for, to fit a picture whose own width is this.
    pub fn new(look: &Look, text: &str, own_width: f64, margin: f64) -> Title {
        let text = look.title.as_deref().unwrap_or(text);
        let width = look.width(own_width);
        Title {
            text: Block::new(text, TITLE_SIZE, width - 2.0 * margin),
            width,
            margin,
            paper: look.paper,
        }
    }

    /// Where the picture below it begins.
    pub fn bottom(&self) -> f64 {
        match self.text.height() {
            0.0 => self.margin,
            height => 2.0 * self.margin + height,
        }
    }
}

/// Draws a title and, with `draw`, what is below it, on a picture of this height in pixels.
pub(crate) fn draw_titled(title: &Title, height: f64, draw: impl FnOnce(&mut Canvas)) -> Picture {
    let mut canvas = Canvas { shapes: Vec::new() };
    let first_row = title.margin + title.text.line_height() / 2.0;
    canvas.text(&title.text, title.width / 2.0, first_row, Align::Centre);
    draw(&mut canvas);
    Picture::of(Drawing {
        size: [tenths(title.width), tenths(height)],
        paper: title.paper,
        shapes: canvas.shapes,
    })
}

impl Canvas {
    /// A line through the given points.
    pub fn line(&mut self, points: &[Pixel], stroke: Stroke) {
        self.shapes.push(Shape::Line {
            points: points.iter().map(|&point| placed(point)).collect(),
            stroke: drawn(stroke),
        });
    }

    /// The line around a rectangle.
    pub fn outline(&mut self, area: Rect, stroke: Stroke) {
        self.line(&area.outline(), stroke);
    }

    /// The outline of a circle.
    pub fn ring(&mut self, centre: Pixel, radius: f64, stroke: Stroke) {
        self.shapes.push(Shape::Ring {
            centre: placed(centre),
            radius: tenths(radius),
            stroke: drawn(stroke),
        });
    }

    /// A filled circle.
    pub fn disc(&mut self, centre: Pixel, radius: f64, colour: Colour) {
        self.shapes.push(Shape::Disc {
            centre: placed(centre),
            radius: tenths(radius),
            colour,
        });
    }

    /// A filled polygon.
    pub fn polygon(&mut self, corners: &[Pixel], fill: impl Into<Fill>) {
        self.shapes.push(Shape::Polygon {
            corners: corners.iter().map(|&corner| placed(corner)).collect(),
            fill: fill.into(),
        });
    }

    /// Lines of text, the first one's middle at `y`, aligned at `x`.
    pub fn text(&mut self, block: &Block, x: f64, y: f64, align: Align) {
        for (text, down) in rows(block) {
            self.write(text, block.size, (x, y + down), (align, false));
        }
    }

    /// Text that reads upwards, centred at `y`, its first line's middle at `x`.
    pub fn upward_text(&mut self, block: &Block, x: f64, y: f64) {
        for (text, down) in rows(block) {
            self.write(text, block.size, (x + down, y), (Align::Centre, true));
        }
    }

    fn write(&mut self, text: &str, size: f64, place: Pixel, (align, upwards): (Align, bool)) {
        self.shapes.push(Shape::Text(TextLine {
            text: text.to_owned(),
            place: placed(place),
            size,
            align,
            upwards,
        }));
    }
}

/// Lines of text, and how far the baseline of each is below the middle of the first.
fn rows(block: &Block) -> impl Iterator<Item = (&str, f64)> {
    let lines = block.lines.iter().enumerate();
    lines.map(|(row, line)| {
        let middle = row as f64 * block.line_height();
        (line.as_str(), middle + MIDDLE_TO_BASELINE * block.size)
    })
}

/// Rounded to a tenth of a pixel: finer is not seen, and takes room in files. What is beyond
/// 200 million pixels stays there.
fn tenths(pixels: f64) -> f64 {
    f64::from((10.0 * pixels).round() as i32) / 10.0
}

fn placed((x, y): Pixel) -> Pixel {
    (tenths(x), tenths(y))
}

fn drawn(stroke: Stroke) -> Stroke {
    Stroke {
        width: tenths(stroke.width),
        ..stroke
    }
}
