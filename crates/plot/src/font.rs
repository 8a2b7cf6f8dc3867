//! The embedded font: how wide its letters are, and their outlines.

use std::sync::LazyLock;

use tiny_skia::PathSegment;

use super::truetype::{Contour, TrueType};

/// Latin-1, Greek, sub- and superscripts of DejaVu Sans.
pub(crate) static FILE: &[u8] = include_bytes!("fonts/DejaVuSans.ttf");
/// The family name inside [`FILE`].
pub(crate) const FAMILY: &str = "DejaVu Sans";

/// [`FILE`] is part of the program: it is a font, and all its glyphs can be read.
const IS_A_FONT: &str = "the embedded file is a font";

static FONT: LazyLock<TrueType> = LazyLock::new(|| TrueType::parse(FILE).expect(IS_A_FONT));

/// A font size in the units of all lengths in the file.
fn em() -> f32 {
    f32::from(FONT.units_per_em)
}

/// What stands for a letter, or for one that the font lacks.
fn glyph(letter: char) -> u16 {
    FONT.glyph(letter).unwrap_or(0)
}

/// The distance from a letter to the next, in font sizes.
pub(crate) fn advance(letter: char) -> f32 {
    f32::from(FONT.width(glyph(letter)).expect(IS_A_FONT)) / em()
}

/// The outline of a letter that begins at the origin, each place given by `place` from x and y in
/// font sizes, y upwards from the baseline.
pub(crate) fn outline(letter: char, place: impl Fn(f32, f32) -> (f32, f32)) -> Vec<PathSegment> {
    let contours = FONT.contours(glyph(letter)).expect(IS_A_FONT);
    let mut path = Vec::new();
    for contour in contours {
        add_contour(&contour, &place, &mut path);
    }
    path
}

/// Adds a closed curve to an outline.
fn add_contour(
    contour: &Contour,
    place: impl Fn(f32, f32) -> (f32, f32),
    path: &mut Vec<PathSegment>,
) {
    let mut places = (contour.iter().chain(contour.first()))
        .map(|point| (place(point.x / em(), point.y / em()).into(), point.is_on));
    let Some((begin, _)) = places.next() else {
        return;
    };
    path.push(PathSegment::MoveTo(begin));
    let mut control = None;
    for (point, is_on) in places {
        match (is_on, control.take()) {
            (false, _) => control = Some(point),
            (true, None) => path.push(PathSegment::LineTo(point)),
            (true, Some(control)) => path.push(PathSegment::QuadTo(control, point)),
        }
    }
    path.push(PathSegment::Close);
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
        let glyphs = (0..).map_while(|glyph| FONT.width(glyph).map(|_| glyph));
        let is_blank = |glyph: &u16| FONT.contours(*glyph).unwrap().is_empty();
        let (blanks, drawn): (Vec<u16>, Vec<u16>) = glyphs.partition(is_blank);
        assert_eq!(blanks, ['\u{10FFFD}', ' ', '\u{a0}'].map(glyph));
        assert_eq!(drawn.len(), 489);
    }

    /// As the file has it, of 2048 units.
    #[test]
    fn widths_are_those_of_the_file() {
        assert_eq!(advance('M') * 2048.0, 1767.0);
    }
}
