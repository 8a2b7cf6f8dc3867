//! What is said of a value, in the units of the file that gives it: checks know SI units alone.

use super::schema::is_key;
use super::units::key_in_si;
use crate::quantities::{Axis, FOOT, INCH, LENGTH, TWINS, Twin, shown_as};

/// Numbers with more digits than this were converted.
const MOST_DIGITS: usize = 10;

/// Metres of more than this are along the string, not across it.
const MOST_ACROSS: f64 = 3.0;

/// Numbers in a row that may have one unit.
const MOST_IN_A_ROW: usize = 32;

/// Digits of a number in the units of the file.
const CONVERTED: usize = 5;

/// The units that a file, or the one value of it that is spoken of, is in.
pub struct FileUnits {
    /// Whether all of the file is in oilfield units.
    are_field: bool,
    /// The twin that the key of the value is written as.
    of_key: Option<&'static Twin>,
}

impl FileUnits {
    /// Of a file, all in oilfield units or not, at a key as it is written there.
    pub fn new(are_field: bool, key: &str) -> Self {
        Self {
            are_field,
            of_key: key.rsplit(['.', '[', ']']).find_map(written_as),
        }
    }

    /// A message with its numbers and keys in these units.
    pub fn convert(&self, message: &str) -> String {
        let mut text = String::with_capacity(message.len());
        let (mut rest, mut is_quoted) = (message, false);
        while let Some(letter) = rest.chars().next() {
            let word = length_of(rest, |it| it.is_ascii_alphanumeric() || "_.[]".contains(it));
            let digits = length_of(rest, |it| it.is_ascii_digit() || ".e-".contains(it));
            if letter.is_ascii_alphabetic() {
                text += &self.key(&rest[..word]);
                rest = &rest[word..];
            } else if let Some((number, length)) = number(rest).filter(|_| !is_quoted) {
                let after = &rest[length..];
                text += &self.number(number, &rest[..length], unit_after(after));
                rest = self.after_number(number, after, &mut text);
            } else {
                // A run of digits that is no number, such as a date, at once.
                let length = digits.max(word).max(letter.len_utf8());
                is_quoted ^= letter == '`';
                text += &rest[..length];
                rest = &rest[length..];
            }
        }
        text
    }

    /// A word, or as a key is called in these units; a full stop may follow it.
    fn key(&self, word: &str) -> String {
        let (word, stop) = match word.strip_suffix('.') {
            Some(word) => (word, "."),
            None => (word, ""),
        };
        let name = word.rsplit('.').next().unwrap_or(word);
        let twin = shown_as(name).filter(|_| is_key(name) || Axis::from_name(name).is_some());
        match twin.filter(|_| self.are_field) {
            Some(twin) => format!("{}{}{stop}", word.trim_end_matches(twin.si), twin.twin),
            None => format!("{word}{stop}"),
        }
    }

    /// What a number in a unit is shown in, and how much of that unit it is.
    fn shown(&self, number: f64, unit: &str) -> Option<(&'static str, f64)> {
        let of_key = self.of_key.filter(|twin| twin.units[0] == unit);
        // Depths are in feet, for any unit of the key.
        let is_across = |twin: &&Twin| twin.units == LENGTH.units || number.abs() < MOST_ACROSS;
        let of_key = of_key.filter(|twin| unit != LENGTH.units[0] || is_across(twin));
        let of_file = TWINS
            .iter()
            .filter(|twin| self.are_field && twin.units[0] == unit);
        let twin = of_key.or(of_file.min_by_key(|twin| twin.units[1] != LENGTH.units[1]))?;
        // Radii are said to be such where keys are diameters.
        let size = match twin.units {
            ["m", "in"] => INCH,
            ["m", "mm"] => 1e-3,
            ["m", _] => FOOT,
            _ => twin.factors[0],
        };
        Some((twin.units[1], size))
    }

    fn number(&self, value: f64, as_written: &str, unit: Option<&str>) -> String {
        let rounded = |value: f64, digits: usize| {
            let rounded = format!("{value:.*e}", digits - 1).parse::<f64>();
            rounded.unwrap_or(value).to_string()
        };
        match unit.and_then(|unit| self.shown(value, unit)) {
            Some((_, size)) => rounded(value / size, CONVERTED),
            None if digits(as_written) > MOST_DIGITS => rounded(value, MOST_DIGITS),
            None => as_written.to_owned(),
        }
    }

    /// Writes the unit that follows a number at once as it is shown, and returns what is after it.
    fn after_number<'a>(&self, number: f64, after: &'a str, text: &mut String) -> &'a str {
        let Some(unit) = unit_at(after) else {
            return after;
        };
        let shown = self.shown(number, unit).map_or(unit, |(name, _)| name);
        *text += &format!(" {shown}");
        &after[1 + unit.len()..]
    }
}

/// The twin that a key is written as, if it is no key in SI units.
fn written_as(key: &str) -> Option<&'static Twin> {
    let (in_si, _) = key_in_si(key)?;
    let mut fitting = TWINS.iter();
    fitting.find(|twin| {
        let stem = key.strip_suffix(twin.twin);
        stem.is_some_and(|stem| in_si == format!("{stem}{}", twin.si))
    })
}

/// How many bytes at the beginning of a text are letters of a kind.
fn length_of(text: &str, is_of_kind: impl Fn(char) -> bool) -> usize {
    text.find(|letter| !is_of_kind(letter))
        .unwrap_or(text.len())
}

/// The number that a text begins with, and how long it is.
fn number(text: &str) -> Option<(f64, usize)> {
    let written = length_of(text, |it| it.is_ascii_digit() || ".e-".contains(it));
    let written = text[..written].trim_end_matches(['.', '-', 'e']);
    let ends = text[written.len()..].chars().next();
    let is_alone = !ends.is_some_and(|letter| letter.is_alphanumeric() || letter == '_');
    let value = written.parse().ok().filter(|_| is_alone)?;
    Some((value, written.len()))
}

fn digits(number: &str) -> usize {
    let mantissa = number.split('e').next().unwrap_or(number);
    let digits = mantissa.chars().filter(char::is_ascii_digit);
    digits.skip_while(|digit| *digit == '0').count()
}

/// The unit of a number that this follows: of a few numbers in a row, that of the last.
fn unit_after(mut text: &str) -> Option<&'static str> {
    for _ in 0..MOST_IN_A_ROW {
        if let Some(unit) = unit_at(text) {
            return Some(unit);
        }
        let mut joined = [" and ", " to ", ", "].into_iter();
        let next = joined.find_map(|word| text.strip_prefix(word))?;
        let (_, length) = number(next)?;
        text = &next[length..];
    }
    None
}

/// The unit that a text begins with, after a space.
fn unit_at(text: &str) -> Option<&'static str> {
    let text = text.strip_prefix(' ')?;
    let of_text = |unit: &&str| {
        let after = text.strip_prefix(unit);
        let next = after.map(|after| after.chars().next());
        next.is_some_and(|next| {
            !next.is_some_and(|letter| letter.is_alphanumeric() || "/²³".contains(letter))
        })
    };
    let units = TWINS.iter().map(|twin| twin.units[0]);
    units.filter(of_text).max_by_key(|unit| unit.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_keys_are_those_of_the_file() {
        for (key, message, expected) in [
            (
                "parts[0].length_ft",
                "-9.143999999999998 m is not between 0.001 and 20000 m",
                "-30 ft is not between 0.0032808 and 65617 ft",
            ),
            (
                "parts[0].outer_diameter_in",
                "has 0.0543052 m and 0.0508 m, at a depth of 304.8 m",
                "has 2.138 in and 2 in, at a depth of 1000 ft",
            ),
            (
                "bit.weight_on_bit_klbf",
                "2224.11080763025 kN is not between 0 and 2000 kN; is it in another unit?",
                "500 klbf is not between 0 and 449.62 klbf; is it in another unit?",
            ),
            (
                "bit",
                "needs `torque_dynamic_nm`, or `well.hole_radius_m`: known here: length_m, repeat",
                "needs `torque_dynamic_lbf_ft`, or `well.hole_diameter_in`: known here: length_ft, repeat",
            ),
            (
                "string_friction",
                "20 N m, of 3 pieces, each 0.2 N m s/rad per m and 7850 kg/m³",
                "14.751 lbf ft, of 3 pieces, each 0.044962 lbf s/rad and 65.511 ppg",
            ),
            ("sites", "`0.5 m` and 12 times", "`0.5 m` and 12 times"),
            (
                "sites",
                "on 2026-11-26: part_2 of m3 length_m.",
                "on 2026-11-26: part_2 of m3 length_ft.",
            ),
        ] {
            assert_eq!(FileUnits::new(true, key).convert(message), expected);
        }
    }

    #[test]
    fn of_a_file_in_si_units_one_value_may_be_in_others() {
        let converted = |key: &str, message: &str| FileUnits::new(false, key).convert(message);
        assert_eq!(converted("a.length_ft", "3.048 m, 5 kN"), "10 ft, 5 kN");
        assert_eq!(converted("a.length_m", "18287.999999999996 m"), "18288 m");
        assert_eq!(
            converted("a.outer_diameter_mm", "0.05 m of `length_m`"),
            "50 mm of `length_m`"
        );
        assert_eq!(converted("a", "case 3 of 1.5"), "case 3 of 1.5");
    }
    /// A file may name a key as long as it is itself.
    #[test]
    fn long_messages_take_no_longer_than_they_are() {
        for piece in ["a", "a_", "1-", "1, ", "`", ".", "é", "_m "] {
            let long = piece.repeat(200_000);
            assert_eq!(
                FileUnits::new(true, "sites").convert(&long).len(),
                long.len()
            );
        }
    }
}
