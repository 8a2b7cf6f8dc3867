//! Words and numbers for people: plurals, a few digits, lines that fit a terminal.
//! Files carry every digit instead.
//!
//! ```
//! use campaign::words::{counted, short, site_title};
//! use campaign::quantities::Units;
//!
//! assert_eq!(counted(1, "case"), "1 case");
//! assert_eq!(counted(4225, "case"), "4225 cases");
//! assert_eq!(short(672.073_165), "672.1");
//! assert_eq!(site_title(30.48, Units::Field), "100 ft above the bit");
//! ```

use crate::quantities::{LENGTH, Units};
use crate::text_file::STANDARD_INPUT;

/// Lines for people are no wider than this, but for what is to be copied whole.
pub const WIDTH: usize = 80;

/// `1 method`, `2 methods`.
pub fn counted(count: usize, thing: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {thing}{plural}")
}

/// Magnitudes that are written without a power of ten.
const PLAIN: std::ops::Range<f64> = 1e-4..1e7;

/// A number in four significant digits.
pub fn short(value: f64) -> String {
    let text = format!("{value:.3e}");
    let Ok(rounded) = text.parse::<f64>() else {
        return text;
    };
    if rounded == 0.0 || PLAIN.contains(&rounded.abs()) || !rounded.is_finite() {
        // Adding zero takes the sign of a zero away.
        (rounded + 0.0).to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// A number with a number of decimals, and no negative zero.
pub fn decimals(value: f64, count: usize) -> String {
    let text = format!("{value:.count$}");
    match text.strip_prefix('-') {
        Some(rest) if !rest.contains(|digit: char| ('1'..='9').contains(&digit)) => rest.to_owned(),
        _ => text,
    }
}

/// A name of a file as a title.
pub fn in_words(name: &str) -> String {
    let mut letters = name.trim_matches('_').chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    let rest = letters.map(|letter| if letter == '_' { ' ' } else { letter });
    first.chain(rest).collect()
}

/// How a site is called, by its distance from the bit in m.
pub fn site_title(distance: f64, units: Units) -> String {
    if distance == 0.0 {
        "the bit".to_owned()
    } else {
        let length = units.of(&LENGTH);
        let (distance, unit) = (length.rounded(distance), length.name);
        format!("{distance} {unit} above the bit")
    }
}

/// A path as a shell takes it, and then a command: one that begins with a dash is no
/// option.
pub fn shell_word(path: &str) -> String {
    let dash = if path.starts_with('-') { "./" } else { "" };
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "/._-".contains(letter);
    if path.chars().all(is_plain) {
        format!("{dash}{path}")
    } else {
        format!("'{dash}{}'", path.replace('\'', r"'\''"))
    }
}

/// A sweep file as a shell takes it, and then a command: `-` where it was read from standard input.
pub fn file_word(file: &str) -> String {
    if file == STANDARD_INPUT {
        "-".to_owned()
    } else {
        shell_word(file)
    }
}

/// Words that stay on one line of [`wrapped`] text.
pub fn together(words: &str) -> String {
    words.replace(' ', NO_BREAK)
}

const NO_BREAK: &str = "\u{a0}";

/// A paragraph in lines of limited width, the first one indented by `first` and the
/// others by `later`.
pub fn wrapped(paragraph: &str, first: usize, later: usize) -> String {
    let mut text = " ".repeat(first);
    let mut column = first;
    let mut begins = true;
    for word in paragraph.split([' ', '\n']).filter(|word| !word.is_empty()) {
        let length = word.chars().count();
        if !begins && column + 1 + length > WIDTH {
            text += &format!("\n{}", " ".repeat(later));
            column = later;
        } else if !begins {
            text.push(' ');
            column += 1;
        }
        begins = false;
        text += &word.replace(NO_BREAK, " ");
        column += length;
    }
    text + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_for_people_have_four_digits() {
        for (value, expected) in [
            (672.073_165_867_471_3, "672.1"),
            (0.0, "0"),
            (-0.0, "0"),
            (5.8e24, "5.8e24"),
            (1e-9, "1e-9"),
            (0.000_123_456, "0.0001235"),
            (-20480.0, "-20480"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(short(value), expected);
        }
        assert_eq!(decimals(-0.001, 2), "0.00");
        assert_eq!(decimals(-0.25, 2), "-0.25");
    }

    #[test]
    fn one_of_a_thing_is_no_plural() {
        let both = [0, 1, 2].map(|count| counted(count, "case"));
        assert_eq!(both, ["0 cases", "1 case", "2 cases"]);
    }

    #[test]
    fn a_path_is_one_word_of_a_shell_and_no_option() {
        for (path, expected) in [
            ("a/b-c_1.toml", "a/b-c_1.toml"),
            ("my sweep.toml", "'my sweep.toml'"),
            ("-a'b", r"'./-a'\''b'"),
        ] {
            assert_eq!(shell_word(path), expected);
        }
    }

    #[test]
    fn paragraphs_are_no_wider_than_a_terminal() {
        let text = wrapped(&"a word or two ".repeat(40), 2, 6);
        assert!(text.lines().count() > 4);
        assert!(text.lines().all(|line| line.chars().count() <= WIDTH));
        assert!(text.starts_with("  a word"));
        assert!(
            text.lines()
                .skip(1)
                .all(|line| line.starts_with("      ") && !line[6..].starts_with(' '))
        );
    }

    #[test]
    fn what_belongs_together_is_not_parted() {
        let text = wrapped(&format!("{} {}", "a ".repeat(39), together("50 %")), 0, 2);
        assert!(text.ends_with("\n  50 %\n"), "{text}");
    }

    #[test]
    fn a_word_wider_than_a_terminal_stays_whole() {
        let path = "long/".repeat(30);
        assert_eq!(
            wrapped(&format!("in {path}"), 0, 2),
            format!("in\n  {path}\n")
        );
    }
}
