//! Round numbers and how they are written at ticks.

/// The smallest of 1, 2 or 5 times a power of ten that is at least `raw`, as
/// the digit and the exponent.
pub(crate) fn nice_step(raw: f64) -> (i32, i32) {
    let exponent = raw.log10().floor() as i32;
    let digit = [1, 2, 5].into_iter().find(|&d| power(d, exponent) >= raw);
    digit.map_or((1, exponent + 1), |digit| (digit, exponent))
}

/// A number that is not negative in two digits.
pub(crate) fn in_two(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let exponent = value.log10().floor() as i32;
    if (-4..4).contains(&exponent) {
        let rounded: f64 = format!("{value:.1e}").parse().unwrap_or(value);
        rounded.to_string()
    } else {
        let mantissa = value / 10f64.powi(exponent);
        format!("{mantissa:.1}×10{}", superscript(exponent))
    }
}

/// `digit`·10^`exponent`, rounded once where the power of ten is exact.
pub(crate) fn power(digit: i32, exponent: i32) -> f64 {
    if exponent < 0 {
        f64::from(digit) / 10f64.powi(-exponent)
    } else {
        f64::from(digit) * 10f64.powi(exponent)
    }
}

/// A label with the decimals that a step of 10^`step_exponent` needs.
pub(crate) fn linear_label(value: f64, largest: f64, step_exponent: i32) -> String {
    if value == 0.0 {
        return "0".to_string();
    }
    if (1e-3..1e6).contains(&largest) {
        return with_minus(format!("{value:.*}", decimals(step_exponent)));
    }
    let exponent = largest.log10().floor() as i32;
    let mantissa = value / 10f64.powi(exponent);
    let mantissa = format!("{mantissa:.*}", decimals(step_exponent - exponent));
    with_minus(format!("{mantissa}×10{}", superscript(exponent)))
}

/// A label of a logarithmic axis.
pub(crate) fn decade_label(digit: i32, exponent: i32) -> String {
    if (-3..=4).contains(&exponent) {
        let value = power(digit, exponent);
        format!("{value:.*}", decimals(exponent))
    } else if digit == 1 {
        format!("10{}", superscript(exponent))
    } else {
        format!("{digit}×10{}", superscript(exponent))
    }
}

/// Decimals that show multiples of 10^`exponent`.
fn decimals(exponent: i32) -> usize {
    usize::try_from(-exponent).unwrap_or(0)
}

fn with_minus(number: String) -> String {
    number.replace('-', "−")
}

fn superscript(number: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    number
        .to_string()
        .chars()
        .map(|c| c.to_digit(10).map_or('⁻', |d| DIGITS[d as usize]))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_one_two_or_five() {
        assert_eq!(nice_step(0.1), (1, -1));
        assert_eq!(nice_step(0.11), (2, -1));
        assert_eq!(nice_step(30.0), (5, 1));
        assert_eq!(nice_step(60.0), (1, 2));
    }

    #[test]
    fn two_digits_are_enough_for_a_difference() {
        let found = [0.0, 0.012_34, 3.96, 7.0, 4.2e-9].map(in_two);
        assert_eq!(found, ["0", "0.012", "4", "7", "4.2×10⁻⁹"]);
    }

    #[test]
    fn labels_have_no_trailing_noise() {
        assert_eq!(linear_label(3.0 * 0.1, 0.6, -1), "0.3");
        assert_eq!(linear_label(-2500.0, 3000.0, 2), "−2500");
        assert_eq!(linear_label(1.5e-5, 2e-5, -6), "1.5×10⁻⁵");
        assert_eq!(decade_label(5, -2), "0.05");
        assert_eq!(decade_label(2, 7), "2×10⁷");
        assert_eq!(decade_label(1, -12), "10⁻¹²");
    }
}
