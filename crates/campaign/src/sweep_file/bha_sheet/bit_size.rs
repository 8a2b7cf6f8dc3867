//! The size of a bit by its name: `12 1/4 in PDC bit`, `8-1/2" tricone`, `311 mm`.

use crate::quantities::INCH;

/// Diameters of bits, m: what is not between them in a name is something else, as cutters or pins are.
const BITS: [f64; 2] = [2.0 * INCH, 48.0 * INCH];

/// Fractions of an inch that have a letter.
const VULGAR: [(char, &str); 7] = [
    ('¼', " 1/4"),
    ('½', " 1/2"),
    ('¾', " 3/4"),
    ('⅛', " 1/8"),
    ('⅜', " 3/8"),
    ('⅝', " 5/8"),
    ('⅞', " 7/8"),
];

/// The diameter (m) that a name says, the greatest of several; none where it says none. A number
/// has a unit, or is a fraction, which is of an inch.
pub fn diameter_in_name(name: &str) -> Option<f64> {
    let mut text = name.to_lowercase();
    for (letter, words) in VULGAR {
        text = text.replace(letter, words);
    }
    let is_between = |letter: char| letter.is_whitespace() || ",;:()".contains(letter);
    let words: Vec<&str> = text.split(is_between).filter(|it| !it.is_empty()).collect();
    let found = (0..words.len()).filter_map(|place| diameter_at(&words[place..]));
    let of_bit = found.filter(|diameter| (BITS[0]..=BITS[1]).contains(diameter));
    of_bit.reduce(f64::max)
}

/// The diameter (m) that words begin with.
fn diameter_at(words: &[&str]) -> Option<f64> {
    let (first, unit) = number_and_unit(words[0]);
    // A whole number and a fraction may be two words.
    let second = (words.get(1).map(|word| number_and_unit(word)))
        .filter(|(number, _)| unit.is_empty() && number.contains('/'));
    let (value, has_fraction, unit, used) = match second.and_then(|(number, unit)| {
        let whole: u32 = first.parse().ok()?;
        Some((f64::from(whole) + fraction(number)?, unit))
    }) {
        Some((value, unit)) => (value, true, unit, 2),
        None => (mixed(first)?, first.contains('/'), unit, 1),
    };
    let unit = match unit {
        "" => words.get(used).copied().unwrap_or_default(),
        unit => unit,
    };
    match unit.trim_end_matches('.') {
        "in" | "inch" | "inches" | "\"" | "''" | "″" | "”" => Some(value * INCH),
        "mm" => Some(1e-3 * value),
        _ => has_fraction.then_some(value * INCH),
    }
}

/// A word as a number and the unit right behind it.
fn number_and_unit(word: &str) -> (&str, &str) {
    let is_of_number = |letter: char| letter.is_ascii_digit() || "./-".contains(letter);
    word.split_at(
        word.find(|letter| !is_of_number(letter))
            .unwrap_or(word.len()),
    )
}

/// A decimal, a fraction, or both with a dash between.
fn mixed(text: &str) -> Option<f64> {
    match text.split_once('-') {
        Some((whole, part)) => Some(f64::from(whole.parse::<u32>().ok()?) + fraction(part)?),
        None if text.contains('/') => fraction(text),
        None => text.parse().ok(),
    }
}

/// A proper fraction.
fn fraction(text: &str) -> Option<f64> {
    let (above, below) = text.split_once('/')?;
    let (above, below) = (above.parse::<u32>().ok()?, below.parse::<u32>().ok()?);
    (above < below).then(|| f64::from(above) / f64::from(below))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_bits_say_their_size() {
        for (name, inches) in [
            ("Bit: 12 1/4 in PDC bit", Some(12.25)),
            ("12-1/4\" PDC", Some(12.25)),
            ("8 1/2 PDC bit, 6 blades, 16 mm cutters", Some(8.5)),
            ("PDC bit 8.5\" 4 1/2 REG pin", Some(8.5)),
            ("Bit 12¼ in", Some(12.25)),
            ("26 in. tricone", Some(26.0)),
            ("bit 17.5 inch, TFA 0.8 in2", Some(17.5)),
            ("PDC bit", None),
            ("Bit MDi616, 6 blades, 16 mm cutters", None),
            ("Bit no. 4, run 12", None),
            ("Bit 1/0 3/2", None),
        ] {
            let found = diameter_in_name(name).map(|diameter| diameter / INCH);
            let is_same = |(one, other): (f64, f64)| (one - other).abs() < 1e-9;
            assert_eq!(found.is_some(), inches.is_some(), "{name}: {found:?}");
            assert!(found.zip(inches).is_none_or(is_same), "{name}: {found:?}");
        }
        let metric = diameter_in_name("Meißel 311 mm").unwrap();
        assert!((metric - 0.311).abs() < 1e-12);
    }
}
