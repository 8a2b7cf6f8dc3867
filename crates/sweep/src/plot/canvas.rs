//! The drawing surface: shapes and text in picture pixels, written as SVG.

use super::geometry::{Pixel, Rect};
use super::look::{Look, Paper};
use super::outlines::{INDEX_DEPTH, INDEX_SIZE, Line};
use super::picture::Picture;
use super::text::{self, Block, TITLE_SIZE, split_at_indices};
use anyhow::{Context, Result};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// SVG user units per pixel. plotters rounds coordinates and stroke widths to
/// whole units, which would make curves jagged at one unit per pixel.
const UNITS: f64 = 10.0;
/// Distance from the top of a line of text, as plotters anchors it, to the
/// middle of its digits, in font sizes.
const TOP_TO_MIDDLE: f64 = 0.40;

/// Lengths of dashes and gaps in pixels; empty for a solid line.
pub(super) type Dash = &'static [f64];

/// Dash patterns in the order in which lines get them.
pub(super) const DASHES: [Dash; 6] = [
    &[],
    &[9.0, 5.0],
    &[2.0, 3.0],
    &[10.0, 3.0, 2.0, 3.0],
    &[18.0, 5.0],
    &[10.0, 3.0, 2.0, 3.0, 2.0, 3.0],
];

/// How a line looks.
#[derive(Clone, Copy)]
pub(super) struct Stroke {
    pub colour: RGBColor,
    pub width: f64,
    pub dash: Dash,
}

impl Stroke {
    /// An undashed line.
    pub const fn solid(colour: RGBColor, width: f64) -> Stroke {
        Stroke {
            colour,
            width,
            dash: &[],
        }
    }
}

/// The surface that [`draw_titled`] hands to its caller.
pub(super) struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
    /// The dash pattern of every line drawn so far; see [`add_dashes`].
    dashes: Vec<Dash>,
    /// The lines of text written so far.
    text: Vec<Line>,
}

/// The title of a picture, centred above it and as wide as it is, and the margin around
/// both.
pub(super) struct Title {
    text: Block,
    /// Width of the picture.
    pub width: f64,
    margin: f64,
    paper: Option<Paper>,
}

impl Title {
    /// Breaks the text, or that which is asked for, to fit a picture whose own width is this.
    pub fn new(look: &Look, text: &str, own_width: f64, margin: f64) -> Result<Title> {
        let text = look.title.as_deref().unwrap_or(text);
        let width = look.width(own_width);
        Ok(Title {
            text: Block::new(text, TITLE_SIZE, width - 2.0 * margin)?,
            width,
            margin,
            paper: look.paper,
        })
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
pub(super) fn draw_titled(
    title: &Title,
    height: f64,
    draw: impl FnOnce(&mut Canvas) -> Result<()>,
) -> Result<Picture> {
    let size = (units(title.width) as u32, units(height) as u32);
    let mut svg = String::new();
    let (dashes, text) = {
        let mut canvas = Canvas {
            area: SVGBackend::with_string(&mut svg, size).into_drawing_area(),
            dashes: Vec::new(),
            text: Vec::new(),
        };
        canvas.area.fill(&WHITE)?;
        let first_row = title.margin + title.text.line_height() / 2.0;
        canvas.text(&title.text, title.width / 2.0, first_row, HPos::Center)?;
        draw(&mut canvas)?;
        canvas.area.present()?;
        (canvas.dashes, canvas.text)
    };
    let svg = add_dashes(&with_size(&svg, size, title.paper)?, &dashes);
    let outlines = with_outlines(&svg, &text)?;
    Picture::new(&with_subscripts(&svg), outlines, title.paper)
}

impl Canvas<'_> {
    /// A line through the given points.
    pub fn line(&mut self, points: &[Pixel], stroke: Stroke) -> Result<()> {
        self.dashes.push(stroke.dash);
        let points: Vec<_> = points.iter().map(|&p| in_units(p)).collect();
        let style = stroke.colour.stroke_width(units(stroke.width) as u32);
        self.area.draw(&PathElement::new(points, style))?;
        Ok(())
    }

    /// The line around a rectangle.
    pub fn outline(&mut self, area: Rect, stroke: Stroke) -> Result<()> {
        self.line(&area.outline(), stroke)
    }

    /// The outline of a circle.
    pub fn ring(&self, centre: Pixel, radius: f64, stroke: Stroke) -> Result<()> {
        let style = stroke.colour.stroke_width(units(stroke.width) as u32);
        let circle = Circle::new(in_units(centre), units(radius), style);
        self.area.draw(&circle)?;
        Ok(())
    }

    /// A filled circle.
    pub fn disc(&self, centre: Pixel, radius: f64, colour: RGBColor) -> Result<()> {
        let circle = Circle::new(in_units(centre), units(radius), colour.filled());
        self.area.draw(&circle)?;
        Ok(())
    }

    /// A filled polygon.
    pub fn polygon(&self, corners: &[Pixel], colour: impl Into<RGBAColor>) -> Result<()> {
        let corners: Vec<_> = corners.iter().map(|&p| in_units(p)).collect();
        self.area.draw(&Polygon::new(corners, colour.into()))?;
        Ok(())
    }

    /// Lines of text, the first one's middle at `y`, aligned at `x`.
    pub fn text(&mut self, block: &Block, x: f64, y: f64, align: HPos) -> Result<()> {
        self.lines_of_text(block, align, FontTransform::None, y, |top| (x, top))
    }

    /// Text that reads upwards, centred at `y`, its first line's middle at `x`.
    pub fn upward_text(&mut self, block: &Block, x: f64, y: f64) -> Result<()> {
        let upwards = FontTransform::Rotate270;
        self.lines_of_text(block, HPos::Center, upwards, x, |left| (left, y))
    }

    /// Lines each at the `place` of its top, the first one's middle at `middle`.
    fn lines_of_text(
        &mut self,
        block: &Block,
        align: HPos,
        transform: FontTransform,
        middle: f64,
        place: impl Fn(f64) -> Pixel,
    ) -> Result<()> {
        let upwards = matches!(transform, FontTransform::Rotate270);
        let style = text_style(block, align, transform)?;
        for (row, line) in block.lines.iter().enumerate() {
            let top = middle + row as f64 * block.line_height() - TOP_TO_MIDDLE * block.size;
            let (x, y) = in_units(place(top));
            self.area.draw_text(line, &style, (x, y))?;
            self.text.push(Line {
                text: line.clone(),
                place: (f64::from(x), f64::from(y)),
                size: UNITS * block.size,
                align,
                upwards,
            });
        }
        Ok(())
    }
}

/// Black text anchored at its top: the only vertical anchor that plotters
/// writes in font sizes, and so the same with any viewer's font.
fn text_style(block: &Block, align: HPos, transform: FontTransform) -> Result<TextStyle<'static>> {
    let font = text::font(block.size * UNITS)?.transform(transform);
    Ok(TextStyle::from(font)
        .color(&BLACK)
        .pos(Pos::new(align, VPos::Top)))
}

fn units(pixels: f64) -> i32 {
    (pixels * UNITS).round() as i32
}

fn in_units((x, y): Pixel) -> (i32, i32) {
    (units(x), units(y))
}

/// Replaces the document's opening tag, whose size is in user units, by one whose size is in
/// pixels, or on paper in mm. Round joins keep sharp peaks from growing spikes.
fn with_size(svg: &str, (width, height): (u32, u32), paper: Option<Paper>) -> Result<String> {
    let (_, body) = svg.split_once('>').context("the plot has no content")?;
    let [shown_width, shown_height] = [width, height].map(|length| {
        let pixels = f64::from(length) / UNITS;
        match paper {
            None => format!("{pixels}"),
            Some(paper) => format!("{:.2}mm", pixels * paper.pixel_mm()),
        }
    });
    Ok(format!(
        "<svg width=\"{shown_width}\" height=\"{shown_height}\" \
         viewBox=\"0 0 {width} {height}\" \
         xmlns=\"http://www.w3.org/2000/svg\" stroke-linejoin=\"round\">{body}",
    ))
}

/// Gives each polyline its dash pattern, which plotters cannot write: `dashes`
/// has one pattern for each polyline, in document order.
fn add_dashes(svg: &str, dashes: &[Dash]) -> String {
    const TAG: &str = "<polyline";
    let mut pieces = svg.split(TAG);
    let mut dashed = pieces.next().unwrap_or_default().to_string();
    for (piece, dash) in pieces.zip(dashes) {
        dashed.push_str(TAG);
        if !dash.is_empty() {
            let lengths: Vec<_> = dash.iter().map(|&d| units(d).to_string()).collect();
            dashed.push_str(&format!(" stroke-dasharray=\"{}\"", lengths.join(",")));
        }
        dashed.push_str(piece);
    }
    dashed
}

/// Draws the outlines of each line of text in its place: `text` has them in document order.
fn with_outlines(svg: &str, text: &[Line]) -> Result<String> {
    const END: &str = "</text>";
    let mut pieces = svg.split("<text");
    let mut drawn = pieces.next().unwrap_or_default().to_owned();
    for (piece, line) in pieces.zip(text) {
        let (_, after) = piece.split_once(END).context("a text has no end")?;
        drawn += &line.path()?;
        drawn += after;
    }
    Ok(drawn)
}

/// Sets the indices of T_s and T_d below the line. What follows on the line goes back up to it.
fn with_subscripts(svg: &str) -> String {
    let (size, depth) = (100.0 * INDEX_SIZE, INDEX_DEPTH / INDEX_SIZE);
    let mut set = String::with_capacity(svg.len());
    let mut is_down = false;
    for (piece, index) in split_at_indices(svg) {
        let end = piece.find(['\n', '<']).unwrap_or(piece.len());
        let (line, rest) = piece.split_at(end);
        if is_down && !line.is_empty() {
            set += &format!("<tspan dy=\"-{INDEX_DEPTH}em\">{line}</tspan>{rest}");
        } else {
            set += piece;
        }
        is_down = !index.is_empty();
        if is_down {
            set += &format!("<tspan dy=\"{depth:.1}em\" font-size=\"{size:.0}%\">{index}</tspan>");
        }
    }
    set
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use resvg::tiny_skia::Pixmap;
    use resvg::usvg;

    /// Fails unless all that is filled, text among it, lies inside the picture.
    pub fn assert_text_inside(picture: &Picture) {
        let options = usvg::Options::default();
        let tree = usvg::Tree::from_str(&picture.outlines, &options).expect("valid SVG");
        let (width, height) = (tree.size().width(), tree.size().height());
        let boxes = filled(tree.root());
        assert!(boxes.len() > picture.svg.matches("<text").count());
        for ink in boxes {
            let inside = ink.left() >= 0.0
                && ink.top() >= 0.0
                && ink.right() <= width
                && ink.bottom() <= height;
            assert!(
                inside,
                "something leaves the picture of {width} by {height}: {ink:?}"
            );
        }
    }

    /// The boxes, in pixels, of what is filled below a group.
    fn filled(group: &usvg::Group) -> Vec<usvg::Rect> {
        let mut found = Vec::new();
        for node in group.children() {
            match node {
                usvg::Node::Group(inner) => found.extend(filled(inner)),
                usvg::Node::Path(path) if path.fill().is_some() => {
                    found.push(path.abs_bounding_box());
                }
                _ => {}
            }
        }
        found
    }

    fn draw_on(
        (width, height): (f64, f64),
        draw: impl FnOnce(&mut Canvas) -> Result<()>,
    ) -> Picture {
        let title = Title::new(&Look::default(), "", width, 0.0).expect("laid out");
        draw_titled(&title, height, draw).expect("drawn")
    }

    #[test]
    fn the_png_has_twice_the_size_of_the_svg() {
        let picture = draw_on((90.0, 62.0), |_| Ok(()));
        assert!(picture.svg.starts_with("<svg width=\"90\" height=\"62\""));
        let pixels = Pixmap::decode_png(&picture.png().expect("rasterised")).expect("valid PNG");
        assert_eq!((pixels.width(), pixels.height()), (180, 124));
    }

    #[test]
    fn the_indices_of_torques_are_below_the_line() {
        let picture = draw_on((200.0, 62.0), |canvas| {
            let text = Block::new("T_d < 2 kN m, T_s", 14.0, 200.0)?;
            canvas.text(&text, 5.0, 30.0, HPos::Left)
        });
        let index = |letter| format!("<tspan dy=\"0.3em\" font-size=\"70%\">{letter}</tspan>");
        let between = "<tspan dy=\"-0.21em\"> &lt; 2 kN m, T</tspan>";
        let text = format!("T{}{between}{}\n", index('d'), index('s'));
        assert!(picture.svg.contains(&text), "{}", picture.svg);
        assert_text_inside(&picture);
    }

    #[test]
    fn each_line_gets_its_own_dashes() {
        let picture = draw_on((90.0, 62.0), |canvas| {
            for dash in [DASHES[0], DASHES[1], DASHES[0], DASHES[2]] {
                let stroke = Stroke {
                    dash,
                    ..Stroke::solid(BLACK, 1.0)
                };
                canvas.line(&[(0.0, 0.0), (50.0, 50.0)], stroke)?;
            }
            Ok(())
        });
        let lines: Vec<_> = (picture.svg.lines())
            .filter(|l| l.contains("<polyline"))
            .collect();
        let dashed: Vec<_> = lines.iter().map(|l| l.contains("dasharray")).collect();
        assert_eq!(dashed, [false, true, false, true]);
        assert!(lines[1].contains("stroke-dasharray=\"90,50\""));
    }
}
