//! The range of values that a quantity can have.

/// Refuses a value outside what it can be: more likely, if it has the right
/// sign, in another unit.
///
/// # Errors
/// A sentence.
pub fn within(value: f64, least: f64, most: f64, unit: &str) -> Result<(), String> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    let space = if unit.is_empty() { "" } else { " " };
    let hint = if value > 0.0 && value.is_finite() && !unit.is_empty() {
        "; is it in another unit?"
    } else {
        ""
    };
    let value = in_digits(value);
    Err(format!(
        "{value}{space}{unit} is not between {least} and {most}{space}{unit}{hint}"
    ))
}

/// A number as it would be typed, and not in hundreds of digits.
pub fn in_digits(value: f64) -> String {
    if value == 0.0 || (1e-9..1e15).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}
