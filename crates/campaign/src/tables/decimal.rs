//! Numbers with a decimal point or comma. An ambiguous number is decided by the others of its file,
//! or refused.

use std::borrow::Cow;

use thiserror::Error;

/// How the numbers of a file write their fractions and group their thousands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Decimals {
    /// With a point, or some with a point and some with a comma, or none does.
    #[default]
    Point,
    /// With a comma.
    Comma,
    /// With a point, and thousands are grouped by commas: `1,500.25`.
    PointInGroups,
    /// With a comma, and thousands are grouped by points: `1.500,25`.
    CommaInGroups,
}

/// Why a text is refused as a number.
#[derive(Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum NumberError {
    /// It is not a number.
    #[error("`{0}` is not a number")]
    NotANumber(String),
    /// Its comma may as well group thousands.
    #[error("`{text}` may be {decimal} or {grouped}: write it without a comma")]
    Ambiguous {
        /// The text.
        text: String,
        /// The number with a decimal comma.
        decimal: f64,
        /// The number without a comma that groups.
        grouped: String,
    },
    /// Its point may as well group thousands, as others of the file have decimal commas.
    #[error(
        "`{text}` may be {decimal} or {grouped}, as other numbers of the file have decimal commas: \
         write it without a point"
    )]
    AmbiguousPoint {
        /// The text.
        text: String,
        /// The number with a decimal point.
        decimal: f64,
        /// The number without a point that groups.
        grouped: String,
    },
}

/// A number with a decimal point or comma, by itself.
///
/// # Errors
/// Where it is not a number, or ambiguous.
pub fn number(text: &str) -> Result<f64, NumberError> {
    number_with(text, Decimals::Point)
}

/// A number of a file that writes fractions one way.
///
/// # Errors
/// Where it is not a number, or ambiguous.
pub fn number_with(text: &str, decimals: Decimals) -> Result<f64, NumberError> {
    let not_a_number = || NumberError::NotANumber(text.to_owned());
    let joined = without_blanks(text);
    let number: &str = &joined;
    let parsed = |plain: String| plain.parse().map_err(|_| not_a_number());
    if is_grouped(number, ',', '.') {
        return parsed(number.replace(',', ""));
    }
    if is_grouped(number, '.', ',') {
        return parsed(number.replace('.', "").replace(',', "."));
    }
    if let Ok(value) = number.parse::<f64>() {
        return match decimals {
            Decimals::CommaInGroups if may_group(number, '.') => parsed(number.replace('.', "")),
            Decimals::Comma if may_group(number, '.') => Err(NumberError::AmbiguousPoint {
                text: text.to_owned(),
                decimal: value,
                grouped: number.replace('.', ""),
            }),
            _ => Ok(value),
        };
    }
    let (whole, fraction) = number.split_once(',').ok_or_else(not_a_number)?;
    let decimal = parsed(format!("{whole}.{fraction}"))?;
    let grouped = format!("{whole}{fraction}");
    match decimals {
        Decimals::PointInGroups if may_group(number, ',') => parsed(grouped),
        Decimals::Point if may_group(number, ',') => Err(NumberError::Ambiguous {
            text: text.to_owned(),
            decimal,
            grouped,
        }),
        _ => Ok(decimal),
    }
}

/// How a file writes fractions, by the texts of its cells: one way, where one of them has no other
/// meaning and no other contradicts it.
pub fn decimals<'text>(texts: impl Iterator<Item = &'text str>) -> Decimals {
    let mut found: Option<Decimals> = None;
    for seen in texts.filter_map(evidence) {
        found = match (found, seen) {
            (None, seen) => Some(seen),
            (Some(found), seen) if found == seen => Some(found),
            (Some(Decimals::Point | Decimals::PointInGroups), Decimals::Point)
            | (Some(Decimals::Point), Decimals::PointInGroups) => Some(Decimals::PointInGroups),
            (Some(Decimals::Comma | Decimals::CommaInGroups), Decimals::Comma)
            | (Some(Decimals::Comma), Decimals::CommaInGroups) => Some(Decimals::CommaInGroups),
            _ => return Decimals::Point,
        };
    }
    found.unwrap_or_default()
}

/// What a text says of its file, if it is a number of one meaning that has a mark.
fn evidence(text: &str) -> Option<Decimals> {
    let joined = without_blanks(text);
    let text: &str = &joined;
    let has_fraction = text.starts_with(|letter: char| "+-.,0123456789".contains(letter));
    let is_number = |text: &str| text.parse::<f64>().is_ok();
    match text {
        _ if !has_fraction => None,
        _ if is_grouped(text, ',', '.') => Some(Decimals::PointInGroups),
        _ if is_grouped(text, '.', ',') => Some(Decimals::CommaInGroups),
        _ if text.contains('.') && is_number(text) && !may_group(text, '.') => {
            Some(Decimals::Point)
        }
        _ if text.contains(',')
            && is_number(&text.replacen(',', ".", 1))
            && !may_group(text, ',') =>
        {
            Some(Decimals::Comma)
        }
        _ => None,
    }
}

/// A number without the blanks and apostrophes that group its thousands: `1 500,5`, `1'500.5`.
fn without_blanks(text: &str) -> Cow<'_, str> {
    let is_blank = |letter: char| {
        matches!(
            letter,
            ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}' | '\'' | '’'
        )
    };
    let whole = text.split(['.', ',']).next().unwrap_or_default();
    match whole.contains(is_blank) && are_thousands(whole.split(is_blank)) {
        true => Cow::Owned(text.replace(is_blank, "")),
        false => Cow::Borrowed(text),
    }
}

/// Whether a number has no other meaning than thousands in groups by one mark, and perhaps a
/// fraction behind the other: `1,500.5`, and `1,500,000`, which has two groups.
fn is_grouped(text: &str, group: char, fraction: char) -> bool {
    let (whole, behind) = match text.split_once(fraction) {
        Some((whole, behind)) => (whole, Some(behind)),
        None => (text, None),
    };
    let marks = whole.matches(group).count();
    let is_clear = marks > 1 || marks == 1 && behind.is_some();
    let are_digits = |text: &str| text.bytes().all(|letter| letter.is_ascii_digit());
    is_clear && are_thousands(whole.split(group)) && behind.is_none_or(are_digits)
}

/// Whether digits are in groups of thousands: one to three, then three each.
fn are_thousands<'text>(mut groups: impl Iterator<Item = &'text str>) -> bool {
    let are_digits = |text: &str| text.bytes().all(|letter| letter.is_ascii_digit());
    let first = groups.next().unwrap_or_default();
    let first = first.trim_start_matches(['+', '-']);
    (1..=3).contains(&first.len())
        && !first.starts_with('0')
        && are_digits(first)
        && groups.all(|group| group.len() == 3 && are_digits(group))
}

/// Whether the one mark in a number may group thousands: three digits behind it, and one to three
/// before it, of which the first is not 0.
fn may_group(text: &str, mark: char) -> bool {
    text.matches(mark).count() == 1 && are_thousands(text.split(mark))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_is_a_decimal_one_only_where_it_groups_no_thousands() {
        for (text, value) in [
            ("0,1", 0.1),
            ("-12,5", -12.5),
            ("0,125", 0.125),
            ("1,5e3", 1500.0),
            ("1234,567", 1234.567),
            ("1.500", 1.5),
            ("1,500.25", 1500.25),
            ("-1.500,25", -1500.25),
            ("1,500,000", 1.5e6),
            ("1.500.000", 1.5e6),
            ("1 500,5", 1500.5),
            ("11\u{a0}500", 11500.0),
            ("1'500.5", 1500.5),
        ] {
            assert_eq!(number(text), Ok(value), "{text}");
        }
        let refused = number("1,500").expect_err("ambiguous").to_string();
        assert!(refused.contains("may be 1.5 or 1500"), "{refused}");
        for text in [
            "15,00.5",
            "1,500.2,5",
            "1.50,5",
            "0.500,5",
            "1 50",
            "1 500 00",
            "5 ft",
            ",",
            "",
            "1;5",
            "x,5",
            "1,,500",
            "1.500,-5",
        ] {
            assert!(number(text).is_err(), "{text}");
        }
    }

    /// `4,276` next to `9,45` is a fraction, and `1.200` may be twelve hundred.
    #[test]
    fn the_other_numbers_of_a_file_decide() {
        let of = |texts: &[&str]| decimals(texts.iter().copied());
        assert_eq!(of(&["Drillpipe", "4,276", "9,45"]), Decimals::Comma);
        assert_eq!(of(&["4,276", "1200"]), Decimals::Point);
        assert_eq!(of(&["4,276", "9,45", "1.5"]), Decimals::Point);
        assert_eq!(number_with("4,276", Decimals::Comma), Ok(4.276));
        assert_eq!(number_with("1.25", Decimals::Comma), Ok(1.25));
        let refused = number_with("1.200", Decimals::Comma)
            .unwrap_err()
            .to_string();
        assert!(
            refused.starts_with("`1.200` may be 1.2 or 1200"),
            "{refused}"
        );
        assert_eq!(number_with("1.200", Decimals::Point), Ok(1.2));
        // Where thousands are grouped for certain, one mark and three digits behind it are more of them.
        for (texts, text, value) in [
            (["1,500.25", "9.5"], "4,276", 4276.0),
            (["9.5", "1,500.25"], "4,276", 4276.0),
            (["1.500,25", "9,5"], "1.200", 1200.0),
            (["9,5", "1.500,25"], "-1.200", -1200.0),
        ] {
            assert_eq!(number_with(text, of(&texts)), Ok(value), "{texts:?}");
        }
        assert_eq!(of(&["1.500,25", "9.5"]), Decimals::Point);
    }
}
