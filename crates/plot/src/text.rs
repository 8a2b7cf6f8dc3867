//! Measuring text and breaking it into lines.

use super::font;

/// Size of plot titles.
pub(crate) const TITLE_SIZE: f64 = 16.0;
/// Size of axis titles.
pub(crate) const LABEL_SIZE: f64 = 15.0;
/// Size of tick labels, legends and names inside the plot.
pub(crate) const SMALL_SIZE: f64 = 14.0;
/// Distance between lines of text, in font sizes.
const LINE_HEIGHT: f64 = 1.3;

/// Factor on widths in the embedded font: a program that does not read it sets text in another
/// one, which may be a little wider.
const ROOM: f64 = 1.065;

/// The width that there has to be for a line of text, pixels.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    let width: f32 = text.chars().map(font::advance).sum();
    ROOM * size * f64::from(width)
}

/// The width of the widest of several lines.
pub(crate) fn widest<'a>(lines: impl IntoIterator<Item = &'a String>, size: f64) -> f64 {
    let widths = lines.into_iter().map(|line| width(line, size));
    widths.fold(0.0, f64::max)
}

/// A text broken into lines that fit a width.
pub(crate) struct Block {
    /// The lines, top to bottom; none for an empty text.
    pub lines: Vec<String>,
    /// Font size in pixels.
    pub size: f64,
    /// Width of the widest line in pixels.
    pub width: f64,
}

impl Block {
    /// Breaks `text` so that no line is wider than `max_width`.
    pub fn new(text: &str, size: f64, max_width: f64) -> Block {
        // XML forbids these.
        let is_forbidden =
            |letter: char| letter.is_control() || matches!(letter, '\u{fffe}'..='\u{ffff}');
        let lines = wrap(&text.replace(is_forbidden, " "), size, max_width);
        Block {
            width: widest(&lines, size),
            lines,
            size,
        }
    }

    /// The same text broken anew.
    pub fn broken_at(&self, max_width: f64) -> Block {
        Block::new(&self.lines.join(" "), self.size, max_width)
    }

    /// Distance between the centres of two lines.
    pub fn line_height(&self) -> f64 {
        self.size * LINE_HEIGHT
    }

    /// Height of all lines.
    pub fn height(&self) -> f64 {
        self.lines.len() as f64 * self.line_height()
    }
}

/// Breaks between words, and inside a word only if it is too wide by itself.
fn wrap(text: &str, size: f64, max_width: f64) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for word in words(text) {
        let longer = format!("{line} {word}");
        let longer = longer.trim_start();
        if width(longer, size) <= max_width {
            line = longer.to_owned();
            continue;
        }
        if !line.is_empty() {
            lines.push(std::mem::take(&mut line));
        }
        line = break_word(&word, size, max_width, &mut lines);
    }
    if !line.is_empty() {
        lines.push(line);
    }
    lines
}

/// The words of a text; the number of an equation stays with what it is of.
fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match words.last_mut() {
            Some(before) if before.ends_with("Eq.") => *before += &format!(" {word}"),
            _ => words.push(word.to_owned()),
        }
    }
    words
}

/// Pushes the full lines of a word to `lines` and returns its last piece.
fn break_word(word: &str, size: f64, max_width: f64, lines: &mut Vec<String>) -> String {
    let mut piece = String::new();
    for letter in word.chars() {
        let longer = format!("{piece}{letter}");
        if !piece.is_empty() && width(&longer, size) > max_width {
            lines.push(std::mem::take(&mut piece));
        }
        piece.push(letter);
    }
    piece
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn longer_text_is_wider() {
        let short = width("bit", SMALL_SIZE);
        let long = width("bit speed", SMALL_SIZE);
        assert!(short > 5.0 && long > 2.0 * short);
    }

    #[test]
    fn lines_break_between_words_and_fit() {
        let block = Block::new("every method finds stick-slip", 14.0, 120.0);
        assert!(block.lines.len() > 1);
        assert!(block.width <= 120.0);
        assert_eq!(block.lines.join(" "), "every method finds stick-slip");
    }

    #[test]
    fn an_overlong_word_is_broken() {
        let word = "unbreakable".repeat(10);
        let block = Block::new(&word, 14.0, 100.0);
        assert!(block.width <= 100.0);
        assert_eq!(block.lines.concat(), word);
    }

    #[test]
    fn control_characters_and_empty_text_are_harmless() {
        let block = Block::new("a\u{0}b\u{ffff}c", 14.0, 100.0);
        assert_eq!(block.lines, ["a b c"]);
        let empty = Block::new("", 14.0, 100.0);
        assert_eq!(empty.height(), 0.0);
    }
}
