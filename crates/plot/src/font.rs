//! The embedded font: how wide its letters are, and their outlines.

use std::sync::LazyLock;

use skrifa::charmap::Charmap;
use skrifa::instance::{LocationRef, Size};
use skrifa::metrics::GlyphMetrics;
use skrifa::outline::pen::PathElement;
use skrifa::outline::{DrawSettings, OutlineGlyphCollection};
use skrifa::{FontRef, GlyphId, MetadataProvider};

/// Latin-1, Greek, sub- and superscripts of DejaVu Sans.
pub(crate) static FILE: &[u8] = include_bytes!("fonts/DejaVuSans.ttf");
/// The family name inside [`FILE`].
pub(crate) const FAMILY: &str = "DejaVu Sans";

static FONT: LazyLock<Font> = LazyLock::new(Font::read);

struct Font {
    letters: Charmap<'static>,
    widths: GlyphMetrics<'static>,
    outlines: OutlineGlyphCollection<'static>,
    /// A font size in the units of all lengths in the file.
    em: f32,
}

impl Font {
    /// Reads [`FILE`], which is part of the program: it is a font.
    fn read() -> Self {
        let font = FontRef::new(FILE).expect("the embedded file is a font");
        let (size, location) = (Size::unscaled(), LocationRef::default());
        Self {
            letters: font.charmap(),
            widths: font.glyph_metrics(size, location),
            outlines: font.outline_glyphs(),
            em: f32::from(font.metrics(size, location).units_per_em),
        }
    }

    /// What stands for a letter, or for one that the font lacks.
    fn glyph(&self, letter: char) -> GlyphId {
        self.letters.map(letter).unwrap_or(GlyphId::NOTDEF)
    }
}

/// The distance from a letter to the next, in font sizes.
pub(crate) fn advance(letter: char) -> f32 {
    let width = FONT.widths.advance_width(FONT.glyph(letter));
    width.unwrap_or(0.0) / FONT.em
}

/// The outline of a letter that begins at the origin, each place given by `place` from x and y in
/// font sizes, y upwards from the baseline.
pub(crate) fn outline(letter: char, place: impl Fn(f32, f32) -> (f32, f32)) -> Vec<PathElement> {
    let mut path = Vec::new();
    if let Some(outline) = FONT.outlines.get(FONT.glyph(letter)) {
        let unscaled = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
        // An outline that cannot be read is left out: a test reads all.
        let _ = outline.draw(unscaled, &mut path);
    }
    let place = |x: f32, y: f32| place(x / FONT.em, y / FONT.em);
    path.into_iter()
        .map(|element| placed(element, place))
        .collect()
}

fn placed(element: PathElement, place: impl Fn(f32, f32) -> (f32, f32)) -> PathElement {
    match element {
        PathElement::MoveTo { x, y } => {
            let (x, y) = place(x, y);
            PathElement::MoveTo { x, y }
        }
        PathElement::LineTo { x, y } => {
            let (x, y) = place(x, y);
            PathElement::LineTo { x, y }
        }
        PathElement::QuadTo { cx0, cy0, x, y } => {
            let ((cx0, cy0), (x, y)) = (place(cx0, cy0), place(x, y));
            PathElement::QuadTo { cx0, cy0, x, y }
        }
        PathElement::CurveTo {
            cx0,
            cy0,
            cx1,
            cy1,
            x,
            y,
        } => {
            let ((cx0, cy0), (cx1, cy1)) = (place(cx0, cy0), place(cx1, cy1));
            let (x, y) = place(x, y);
            PathElement::CurveTo {
                cx0,
                cy0,
                cx1,
                cy1,
                x,
                y,
            }
        }
        PathElement::Close => PathElement::Close,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(letter: char) -> Vec<PathElement> {
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

    #[test]
    fn every_outline_of_the_font_can_be_read() {
        for (_, outline) in FONT.outlines.iter() {
            let unscaled = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
            let mut path: Vec<PathElement> = Vec::new();
            outline.draw(unscaled, &mut path).expect("read");
        }
    }

    /// As the file has it, of 2048 units.
    #[test]
    fn widths_are_those_of_the_file() {
        assert_eq!(advance('M') * 2048.0, 1767.0);
    }
}
