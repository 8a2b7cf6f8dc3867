//! The embedded font: how wide its letters are, and their outlines.

use std::sync::LazyLock;

use tiny_skia::{PathSegment, Point};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Latin-1, Greek, sub- and superscripts of DejaVu Sans.
pub(crate) static FILE: &[u8] = include_bytes!("fonts/DejaVuSans.ttf");
/// The family name inside [`FILE`].
pub(crate) const FAMILY: &str = "DejaVu Sans";

/// [`FILE`] is part of the program: it is a font.
static FONT: LazyLock<Face<'static>> =
    LazyLock::new(|| Face::parse(FILE, 0).expect("the embedded file is a font"));

/// A font size in the units of all lengths in the file.
fn em() -> f32 {
    f32::from(FONT.units_per_em())
}

/// What stands for a letter, or for one that the font lacks.
fn glyph(letter: char) -> GlyphId {
    FONT.glyph_index(letter).unwrap_or(GlyphId(0))
}

/// The distance from a letter to the next, in font sizes.
pub(crate) fn advance(letter: char) -> f32 {
    let width = FONT.glyph_hor_advance(glyph(letter));
    f32::from(width.unwrap_or(0)) / em()
}

/// The outline of a letter that begins at the origin, each place given by `place` from x and y in
/// font sizes, y upwards from the baseline.
pub(crate) fn outline(letter: char, place: impl Fn(f32, f32) -> (f32, f32)) -> Vec<PathSegment> {
    let mut pen = Pen {
        place: |x: f32, y: f32| place(x / em(), y / em()).into(),
        path: Vec::new(),
    };
    // A letter without an outline is a blank.
    let _ = FONT.outline_glyph(glyph(letter), &mut pen);
    pen.path
}

/// Collects an outline, each place given by `place` from x and y in the units of the file.
struct Pen<P> {
    place: P,
    path: Vec<PathSegment>,
}

impl<P: Fn(f32, f32) -> Point> OutlineBuilder for Pen<P> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.path.push(PathSegment::MoveTo((self.place)(x, y)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.path.push(PathSegment::LineTo((self.place)(x, y)));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let [by, end] = [(x1, y1), (x, y)].map(|(x, y)| (self.place)(x, y));
        self.path.push(PathSegment::QuadTo(by, end));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let [one, two, end] = [(x1, y1), (x2, y2), (x, y)].map(|(x, y)| (self.place)(x, y));
        self.path.push(PathSegment::CubicTo(one, two, end));
    }

    fn close(&mut self) {
        self.path.push(PathSegment::Close);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(letter: char) -> Vec<PathSegment> {
        outline(letter, |x, y| (x, y))
    }

    #[test]
    fn each_letter_of_the_plots_has_its_own_outline() {
        let mut seen = vec![drawn('\u{10FFFD}')];
        for letter in "AωgéΩΔμ₀ₛ−×⁻".chars() {
            let path = drawn(letter);
            assert!(!path.is_empty() && !seen.contains(&path), "{letter}");
            seen.push(path);
        }
        assert!(drawn(' ').is_empty());
    }

    /// All but the two blanks and what stands for a letter that the font lacks.
    #[test]
    fn every_outline_of_the_font_can_be_read() {
        let is_blank = |glyph| {
            let mut pen = Pen {
                place: |x, y| Point { x, y },
                path: Vec::new(),
            };
            FONT.outline_glyph(GlyphId(glyph), &mut pen).is_none()
        };
        let blanks = (0..FONT.number_of_glyphs()).filter(|&glyph| is_blank(glyph));
        let known = ['\u{10FFFD}', ' ', '\u{a0}'].map(|letter| glyph(letter).0);
        assert_eq!(blanks.collect::<Vec<_>>(), known);
    }

    /// As the file has it, of 2048 units.
    #[test]
    fn widths_are_those_of_the_file() {
        assert_eq!(advance('M') * 2048.0, 1767.0);
    }
}
