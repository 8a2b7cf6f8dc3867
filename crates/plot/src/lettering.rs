//! Lines of text: where their letters stand, and what is set below the line.

use tiny_skia::PathSegment;

use super::font;
use super::geometry::Pixel;

/// The size of an index, and how far it stands below the line, in the font size of what it
/// belongs to.
pub(crate) const INDEX_SIZE: f64 = 0.7;
pub(crate) const INDEX_DEPTH: f64 = 0.21;

/// What of a line of text stands at its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Align {
    Left,
    Centre,
    Right,
}

/// A line of text on a picture.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct TextLine {
    /// The text; `T_d` stands for T with an index.
    pub text: String,
    /// Where it stands, on its baseline.
    pub place: Pixel,
    /// Font size, pixels.
    pub size: f64,
    pub align: Align,
    /// Whether it reads upwards.
    pub upwards: bool,
}

impl TextLine {
    /// The outlines of its letters, in pixels of the picture.
    pub fn outlines(&self) -> Vec<PathSegment> {
        let letters = letters(&self.text);
        let width = letters.last().map_or(0.0, |last| last.end);
        let start = match self.align {
            Align::Left => 0.0,
            Align::Centre => -0.5 * width,
            Align::Right => -width,
        };
        let (x, y) = (self.place.0 as f32, self.place.1 as f32);
        let size = self.size as f32;
        let of_letter = |letter: &Letter| {
            let &Letter {
                begin, part, depth, ..
            } = letter;
            font::outline(letter.letter, move |along, up| {
                let along = size * (start + begin + part * along);
                let down = size * (depth - part * up);
                let (x, y) = if self.upwards {
                    (x + down, y - along)
                } else {
                    (x + along, y + down)
                };
                (hundredths(x), hundredths(y))
            })
        };
        letters.iter().flat_map(of_letter).collect()
    }
}

/// Rounded to a hundredth of a pixel, which keeps files small.
fn hundredths(pixels: f32) -> f32 {
    (100.0 * pixels).round() / 100.0
}

/// A letter of a line; lengths are in font sizes.
struct Letter {
    letter: char,
    /// Where it begins and ends, from the beginning of the line.
    begin: f32,
    end: f32,
    /// Its own size, and how far it stands below the line.
    part: f32,
    depth: f32,
}

fn letters(text: &str) -> Vec<Letter> {
    let mut letters = Vec::new();
    let mut begin = 0.0;
    let mut set = |text: &str, part: f32, depth: f32| {
        for letter in text.chars() {
            let end = begin + part * font::advance(letter);
            letters.push(Letter {
                letter,
                begin,
                end,
                part,
                depth,
            });
            begin = end;
        }
    };
    for (piece, index) in split_at_indices(text) {
        set(piece, 1.0, 0.0);
        set(index, INDEX_SIZE as f32, INDEX_DEPTH as f32);
    }
    letters
}

/// A text in pieces, each with the index of the torque T_s or T_d that ends it; that of the last is
/// empty.
pub fn split_at_indices(text: &str) -> Vec<(&str, &str)> {
    let mut pieces = Vec::new();
    let mut begin = 0;
    let is_torque = |place: &usize| {
        let mut letters = text[place + 2..].chars();
        letters.next().is_some_and(|letter| "sd".contains(letter))
            && !letters.next().is_some_and(char::is_alphanumeric)
    };
    let places = text.match_indices("T_").map(|(place, _)| place);
    for place in places.filter(is_torque) {
        pieces.push((&text[begin..place + 1], &text[place + 2..place + 3]));
        begin = place + 3;
    }
    pieces.push((&text[begin..], ""));
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From where the line is anchored to its left and its right end.
    fn ends(text: &str, align: Align) -> [f32; 2] {
        let line = TextLine {
            text: text.to_owned(),
            place: (0.0, 0.0),
            size: 20.0,
            align,
            upwards: false,
        };
        let mut ends = [f32::INFINITY, f32::NEG_INFINITY];
        for segment in line.outlines() {
            if let PathSegment::LineTo(end) | PathSegment::QuadTo(_, end) = segment {
                ends = [ends[0].min(end.x), ends[1].max(end.x)];
            }
        }
        ends
    }

    #[test]
    fn a_line_is_as_wide_to_the_left_of_its_end_as_to_the_right_of_its_start() {
        let [left, centre, right] =
            [Align::Left, Align::Centre, Align::Right].map(|align| ends("bit speed", align));
        assert!(
            left[0] > 0.0 && left[1] > 60.0 && left[1] < 120.0,
            "{left:?}"
        );
        assert!(right[1] < 0.0 && right[0] < -60.0, "{right:?}");
        let middle = 0.5 * (left[0] + right[0]);
        assert!((centre[0] - middle).abs() < 0.02, "{centre:?}");
    }

    #[test]
    fn an_index_is_narrower_than_a_letter_on_the_line() {
        for texts in [["T_d", "T d", "T"], ["T_s", "T s", "T"]] {
            let [index, letters, first] =
                texts.map(|text| letters(text).last().map_or(0.0, |last| last.end));
            assert!(
                first < index && index < letters,
                "{first} {index} {letters}"
            );
        }
    }

    #[test]
    fn what_reads_upwards_is_turned_about_its_place() {
        let line = |upwards| TextLine {
            text: "Wω".to_owned(),
            place: (100.0, 50.0),
            size: 20.0,
            align: Align::Centre,
            upwards,
        };
        let (level, upright) = (line(false).outlines(), line(true).outlines());
        assert!(level.len() > 20 && level.len() == upright.len());
        for pair in level.iter().zip(&upright) {
            if let (PathSegment::LineTo(level), PathSegment::LineTo(upright)) = pair {
                assert!((upright.x - 100.0 - (level.y - 50.0)).abs() < 0.015);
                assert!((upright.y - 50.0 + (level.x - 100.0)).abs() < 0.015);
            }
        }
    }
}
