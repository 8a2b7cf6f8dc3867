//! A picture as an SVG document, an element a line. Its font is in it; a program that does not
//! read fonts from there takes another without serifs.

use std::fmt::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::colours::{BLACK, Colour, WHITE};
use super::font::{FAMILY, FILE};
use super::geometry::Pixel;
use super::lettering::{Align, INDEX_DEPTH, INDEX_SIZE, TextLine, split_at_indices};
use super::shapes::{Drawing, Shape, Stroke};

/// The document of a picture.
pub(crate) fn document(drawing: &Drawing) -> String {
    let [width, height] = drawing.size;
    let mut svg = String::new();
    let root = Tag::open(&mut svg, "svg");
    let root = match drawing.paper {
        None => root.number("width", width).number("height", height),
        Some(paper) => {
            let mm = |pixels: f64| format!("{:.2}mm", pixels * paper.pixel_mm());
            root.word("width", &mm(width)).word("height", &mm(height))
        }
    };
    root.word(
        "viewBox",
        &format!("0 0 {} {}", number(width), number(height)),
    )
    .word("xmlns", "http://www.w3.org/2000/svg")
    .word("font-family", &format!("'{FAMILY}', sans-serif"))
    .word("stroke-linejoin", "round")
    .begin();
    svg += &format!(
        "\n<style>@font-face {{ font-family: '{FAMILY}'; src: url(data:font/ttf;base64,{}) }}</style>\n",
        STANDARD.encode(FILE)
    );
    let paper = Tag::open(&mut svg, "rect");
    let paper = paper.number("width", width).number("height", height);
    paper.colour("fill", WHITE).end();
    for shape in &drawing.shapes {
        write_shape(&mut svg, shape);
    }
    svg + "</svg>\n"
}

fn write_shape(svg: &mut String, shape: &Shape) {
    match shape {
        Shape::Line { points, stroke } => {
            let line = Tag::open(svg, "polyline").stroke(*stroke);
            line.points(points).end();
        }
        Shape::Polygon { corners, fill } => {
            let area = Tag::open(svg, "polygon").colour("fill", fill.colour);
            let area = match fill.opacity {
                1.0 => area,
                opacity => area.number("fill-opacity", opacity),
            };
            area.points(corners).end();
        }
        Shape::Ring {
            centre,
            radius,
            stroke,
        } => {
            let ring = Tag::open(svg, "circle").stroke(*stroke);
            ring.circle(*centre, *radius).end();
        }
        Shape::Disc {
            centre,
            radius,
            colour,
        } => {
            let disc = Tag::open(svg, "circle").colour("fill", *colour);
            disc.circle(*centre, *radius).end();
        }
        Shape::Text(line) => write_text(svg, line),
    }
}

fn write_text(svg: &mut String, line: &TextLine) {
    let (x, y) = line.place;
    let text = Tag::open(svg, "text");
    let text = if line.upwards {
        let [x, y] = [x, y].map(number);
        text.word("transform", &format!("translate({x} {y}) rotate(-90)"))
    } else {
        text.number("x", x).number("y", y)
    };
    let text = text.number("font-size", line.size);
    let text = match line.align {
        Align::Left => text,
        Align::Centre => text.word("text-anchor", "middle"),
        Align::Right => text.word("text-anchor", "end"),
    };
    text.colour("fill", BLACK).begin();
    *svg += &content(&line.text);
    *svg += "</text>\n";
}

/// The words of a line with the indices of torques below it. What follows on the line goes back
/// up to it.
fn content(text: &str) -> String {
    let mut content = String::new();
    let mut is_down = false;
    for (piece, index) in split_at_indices(text) {
        let piece = escaped(piece);
        if is_down && !piece.is_empty() {
            let up = number(-INDEX_DEPTH);
            content += &format!("<tspan dy=\"{up}em\">{piece}</tspan>");
        } else {
            content += &piece;
        }
        is_down = !index.is_empty();
        if is_down {
            let (down, size) = (number(INDEX_DEPTH / INDEX_SIZE), number(100.0 * INDEX_SIZE));
            content += &format!("<tspan dy=\"{down}em\" font-size=\"{size}%\">{index}</tspan>");
        }
    }
    content
}

/// A number in at most two decimals.
fn number(value: f64) -> String {
    let mut digits = String::new();
    push_number(&mut digits, value);
    digits
}

/// Writes a number in at most two decimals.
fn push_number(svg: &mut String, value: f64) {
    let hundredths = (100.0 * value).round() as i64;
    let sign = if hundredths < 0 { "-" } else { "" };
    let (whole, rest) = (hundredths.abs() / 100, hundredths.abs() % 100);
    // Writing to a string cannot fail.
    let _ = match (rest / 10, rest % 10) {
        (0, 0) => write!(svg, "{sign}{whole}"),
        (tenths, 0) => write!(svg, "{sign}{whole}.{tenths}"),
        _ => write!(svg, "{sign}{whole}.{rest:02}"),
    };
}

/// A text as it stands between tags or in a quoted attribute.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            letter => escaped.push(letter),
        }
    }
    escaped
}

/// A tag to which attributes are added.
struct Tag<'a>(&'a mut String);

impl<'a> Tag<'a> {
    fn open(svg: &'a mut String, name: &str) -> Self {
        *svg += "<";
        *svg += name;
        Self(svg)
    }

    fn word(self, name: &str, value: &str) -> Self {
        let value = escaped(value);
        self.attribute(name, |svg| *svg += &value)
    }

    fn number(self, name: &str, value: f64) -> Self {
        self.attribute(name, |svg| push_number(svg, value))
    }

    fn colour(self, name: &str, colour: Colour) -> Self {
        self.word(name, &colour.to_string())
    }

    fn stroke(self, stroke: Stroke) -> Self {
        let line = (self.word("fill", "none"))
            .colour("stroke", stroke.colour)
            .number("stroke-width", stroke.width);
        if stroke.dash.is_empty() {
            return line;
        }
        let dash: Vec<String> = stroke.dash.iter().map(|&length| number(length)).collect();
        line.word("stroke-dasharray", &dash.join(","))
    }

    fn circle(self, (x, y): Pixel, radius: f64) -> Self {
        self.number("cx", x).number("cy", y).number("r", radius)
    }

    fn points(self, points: &[Pixel]) -> Self {
        self.attribute("points", |svg| {
            for (place, &(x, y)) in points.iter().enumerate() {
                if place > 0 {
                    svg.push(' ');
                }
                push_number(svg, x);
                svg.push(',');
                push_number(svg, y);
            }
        })
    }

    /// An attribute whose value `write` appends.
    fn attribute(self, name: &str, write: impl FnOnce(&mut String)) -> Self {
        *self.0 += " ";
        *self.0 += name;
        *self.0 += "=\"";
        write(self.0);
        *self.0 += "\"";
        self
    }

    /// Ends the tag of an element without content.
    fn end(self) {
        *self.0 += "/>\n";
    }

    /// Ends the tag of an element whose content follows.
    fn begin(self) {
        *self.0 += ">";
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_two_decimals_at_most() {
        let numbers = [0.0, -0.001, 7.0, 0.1, -3.456, 100.05, 1e-9].map(number);
        assert_eq!(numbers, ["0", "0", "7", "0.1", "-3.46", "100.05", "0"]);
    }

    #[test]
    fn what_steers_a_document_is_text() {
        assert_eq!(
            content("a < \"b\" & c > d"),
            "a &lt; &quot;b&quot; &amp; c &gt; d"
        );
    }

    #[test]
    fn the_indices_of_torques_are_below_the_line() {
        let index = |letter| format!("<tspan dy=\"0.3em\" font-size=\"70%\">{letter}</tspan>");
        let between = "<tspan dy=\"-0.21em\"> &lt; 2 kN m, T</tspan>";
        assert_eq!(
            content("T_d < 2 kN m, T_s"),
            format!("T{}{between}{}", index('d'), index('s'))
        );
    }
}
