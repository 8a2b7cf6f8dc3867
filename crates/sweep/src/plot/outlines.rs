//! Text as the outlines of its letters: what draws the PNG reads no fonts.

use std::fmt::Write;
use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, OutlineCurve, Point};
use anyhow::{Result, anyhow};
use plotters::style::text_anchor::HPos;

use super::text::{FONT, split_at_indices};

/// From where a line is anchored, its top, down to its baseline, in font sizes, as plotters
/// writes it.
const TOP_TO_BASELINE: f32 = 0.76;

/// An index is so much smaller than what it belongs to, and so much lower, in the font size
/// of that.
pub(super) const INDEX_SIZE: f32 = 0.7;
pub(super) const INDEX_DEPTH: f32 = 0.21;

static READ: LazyLock<Option<FontRef<'static>>> =
    LazyLock::new(|| FontRef::try_from_slice(FONT).ok());

/// A line of text on a picture, in SVG user units.
pub(super) struct Line {
    /// The text; `T_d` stands for T with an index.
    pub text: String,
    /// Where the top of the line is.
    pub place: (f64, f64),
    /// Font size.
    pub size: f64,
    /// What of the line is there.
    pub align: HPos,
    /// Whether it reads upwards.
    pub upwards: bool,
}

impl Line {
    /// The SVG path of its letters.
    ///
    /// # Errors
    /// Where the embedded font cannot be read.
    pub fn path(&self) -> Result<String> {
        let font = READ.as_ref();
        let font = font.ok_or_else(|| anyhow!("the embedded font cannot be read"))?;
        let mut letters = Letters::new(font, self.size as f32);
        for (piece, index) in split_at_indices(&self.text) {
            letters.set(piece);
            letters.set_index(index);
        }
        let (x, y) = self.place;
        let start = match self.align {
            HPos::Left => 0.0,
            HPos::Center => -0.5 * letters.width,
            HPos::Right => -letters.width,
        };
        let down = TOP_TO_BASELINE * self.size as f32;
        let turned = if self.upwards { " rotate(270)" } else { "" };
        Ok(format!(
            "<path d=\"{}\" transform=\"translate({x},{y}){turned} translate({start},{down})\"/>",
            letters.path
        ))
    }
}

/// Letters set one after the other from the origin on, along the baseline.
struct Letters<'a> {
    font: &'a FontRef<'static>,
    size: f32,
    path: String,
    width: f32,
}

impl<'a> Letters<'a> {
    fn new(font: &'a FontRef<'static>, size: f32) -> Self {
        Self {
            font,
            size,
            path: String::new(),
            width: 0.0,
        }
    }

    fn set(&mut self, text: &str) {
        self.set_at(text, self.size, 0.0);
    }

    fn set_index(&mut self, text: &str) {
        self.set_at(text, INDEX_SIZE * self.size, INDEX_DEPTH * self.size);
    }

    /// Sets a text of a size so far below the line.
    fn set_at(&mut self, text: &str, size: f32, depth: f32) {
        let scale = size / self.font.units_per_em().unwrap_or(1000.0);
        let mut last = None;
        for letter in text.chars() {
            let glyph = self.font.glyph_id(letter);
            if let Some(last) = last.replace(glyph) {
                self.width += scale * self.font.kern_unscaled(last, glyph);
            }
            if let Some(outline) = self.font.outline(glyph) {
                self.draw(&outline.curves, scale, depth);
            }
            self.width += scale * self.font.h_advance_unscaled(glyph);
        }
    }

    /// Draws curves, of which each contour's follow one another.
    fn draw(&mut self, curves: &[OutlineCurve], scale: f32, depth: f32) {
        let left = self.width;
        let at = |point: &Point| {
            format!(
                "{:.2} {:.2}",
                left + scale * point.x,
                depth - scale * point.y
            )
        };
        let mut end = None;
        for curve in curves {
            let (start, next, drawn) = match curve {
                OutlineCurve::Line(from, to) => (from, to, format!("L{}", at(to))),
                OutlineCurve::Quad(from, by, to) => (from, to, format!("Q{} {}", at(by), at(to))),
                OutlineCurve::Cubic(from, by, and, to) => {
                    (from, to, format!("C{} {} {}", at(by), at(and), at(to)))
                }
            };
            if end != Some(*start) {
                let _ = write!(self.path, "M{}", at(start));
            }
            self.path += &drawn;
            end = Some(*next);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(text: &str, align: HPos) -> Line {
        Line {
            text: text.to_owned(),
            place: (100.0, 50.0),
            size: 20.0,
            align,
            upwards: false,
        }
    }

    fn start(text: &str, align: HPos) -> f32 {
        let path = line(text, align).path().expect("drawn");
        let (_, last) = path.rsplit_once("translate(").expect("placed");
        let (start, _) = last.split_once(',').expect("two numbers");
        start.parse().expect("a number")
    }

    #[test]
    fn a_line_is_as_wide_to_the_left_of_its_end_as_to_the_right_of_its_start() {
        let [left, centre, right] =
            [HPos::Left, HPos::Center, HPos::Right].map(|align| start("bit speed", align));
        assert_eq!(left, 0.0);
        assert!((right - 2.0 * centre).abs() < 1e-3 && right < -60.0 && right > -120.0);
    }

    #[test]
    fn an_index_is_narrower_than_a_letter_on_the_line() {
        for texts in [["T_d", "T d", "T"], ["T_s", "T s", "T"]] {
            let [index, letters, first] = texts.map(|text| -start(text, HPos::Right));
            assert!(
                first < index && index < letters,
                "{first} {index} {letters}"
            );
        }
    }

    #[test]
    fn each_letter_of_the_plots_has_an_outline_of_its_own() {
        let missing = line("\u{10FFFD}", HPos::Left).path().expect("drawn");
        for letter in ["ω", "Ω", "₀", "ₛ", "−", "×", "⁻", "μ", "Δ"] {
            let path = line(letter, HPos::Left).path().expect("drawn");
            assert!(path.contains('L') && path != missing, "{letter}: {path}");
        }
    }
}
