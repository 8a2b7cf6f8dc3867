//! Numbers with a decimal point or comma. An ambiguous number is decided by the others of its file,
//! or refused.

use thiserror::Error;

/// How the numbers of a file write their fractions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Decimals {
    /// With a point, or some with a point and some with a comma, or none does.
    #[default]
    Point,
    /// With a comma.
    Comma,
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

/// What a text says of the decimals of its file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Evidence {
    Point,
    Comma,
    None,
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
    if let Ok(value) = text.parse::<f64>() {
        let is_ambiguous = decimals == Decimals::Comma && may_group(text, '.');
        return match is_ambiguous {
            true => Err(NumberError::AmbiguousPoint {
                text: text.to_owned(),
                decimal: value,
                grouped: text.replace('.', ""),
            }),
            false => Ok(value),
        };
    }
    let not_a_number = || NumberError::NotANumber(text.to_owned());
    let (whole, fraction) = text.split_once(',').ok_or_else(not_a_number)?;
    let decimal: f64 = format!("{whole}.{fraction}")
        .parse()
        .map_err(|_| not_a_number())?;
    if decimals == Decimals::Point && may_group(text, ',') {
        return Err(NumberError::Ambiguous {
            text: text.to_owned(),
            decimal,
            grouped: format!("{whole}{fraction}"),
        });
    }
    Ok(decimal)
}

/// How a file writes fractions, by the texts of its cells: with a comma, where one of them has no
/// other meaning and no other has a decimal point.
pub fn decimals<'text>(texts: impl Iterator<Item = &'text str>) -> Decimals {
    let mut found = Decimals::Point;
    for text in texts {
        match evidence(text) {
            Evidence::Point => return Decimals::Point,
            Evidence::Comma => found = Decimals::Comma,
            Evidence::None => {}
        }
    }
    found
}

fn evidence(text: &str) -> Evidence {
    let has_fraction = text.starts_with(|letter: char| "+-.,0123456789".contains(letter));
    let is_number = |text: &str| text.parse::<f64>().is_ok();
    match text {
        _ if !has_fraction => Evidence::None,
        _ if text.contains('.') && is_number(text) && !may_group(text, '.') => Evidence::Point,
        _ if text.contains(',')
            && is_number(&text.replacen(',', ".", 1))
            && !may_group(text, ',') =>
        {
            Evidence::Comma
        }
        _ => Evidence::None,
    }
}

/// Whether the one mark in a number may group thousands: three digits behind it, and one to three
/// before it, of which the first is not 0.
fn may_group(text: &str, mark: char) -> bool {
    let Some((whole, fraction)) = text.split_once(mark) else {
        return false;
    };
    let digits = whole.trim_start_matches(['+', '-']);
    fraction.len() == 3
        && fraction.bytes().all(|letter| letter.is_ascii_digit())
        && (1..=3).contains(&digits.len())
        && !digits.starts_with('0')
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
        ] {
            assert_eq!(number(text), Ok(value), "{text}");
        }
        let refused = number("1,500").expect_err("ambiguous").to_string();
        assert!(refused.contains("may be 1.5 or 1500"), "{refused}");
        for text in ["1,500,000", "1.500,5", "1,500.5", ",", "", "1;5", "x,5"] {
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
    }
}
