//! Names that count sections, parts and sites: other numbers take the places of the
//! zeros of a pattern such as `section_0_repeat`.

/// The pattern with these numbers.
pub fn numbered(pattern: &str, numbers: [usize; 2]) -> String {
    let mut parts = pattern.split('0');
    let mut text = parts.next().unwrap_or_default().to_owned();
    for (number, part) in numbers.iter().zip(parts) {
        text += &format!("{number}{part}");
    }
    text
}

/// The numbers of a name of this pattern. A number spelt with leading zeros or a sign
/// is another name for the same thing: none.
pub fn numbers_in(name: &str, pattern: &str) -> Option<[usize; 2]> {
    let mut parts = pattern.split('0');
    let mut rest = name.strip_prefix(parts.next()?)?;
    let mut numbers = [0; 2];
    for (number, part) in numbers.iter_mut().zip(parts) {
        let end = rest.find(|letter: char| !letter.is_ascii_digit());
        let (digits, after) = rest.split_at(end.unwrap_or(rest.len()));
        *number = digits.parse().ok()?;
        if number.to_string() != digits {
            return None;
        }
        rest = after.strip_prefix(part)?;
    }
    rest.is_empty().then_some(numbers)
}
