//! What of a text reaches a terminal: letters, and nothing that steers it.

use std::borrow::Cow;

/// Whether a letter steers a terminal, breaks a line or turns the direction of
/// writing, instead of being read: control characters, separators of lines and
/// paragraphs, and the overrides, embeddings and isolates of Unicode's
/// bidirectional algorithm (UAX 9).
pub fn steers(letter: char) -> bool {
    letter.is_control()
        || matches!(
            letter,
            '\u{2028}'..='\u{2029}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
        )
}

/// Whether XML, and so a picture, has no place for a letter other than control characters.
pub fn is_noncharacter(letter: char) -> bool {
    matches!(letter, '\u{fffe}'..='\u{ffff}')
}

/// A text with letters that steer spelt out, as `\u{1b}`; breaks of lines and tabs stay.
pub fn printable(text: &str) -> Cow<'_, str> {
    let spelt_out = |letter: char| steers(letter) && letter != '\n' && letter != '\t';
    spell_out(text, spelt_out, |letter| {
        letter.escape_unicode().to_string()
    })
}

/// The same of a JSON document on one line, where such letters are in strings only.
pub fn printable_json(json: &str) -> Cow<'_, str> {
    spell_out(json, steers, |letter| {
        format!("\\u{:04x}", u32::from(letter))
    })
}

fn spell_out<'a>(
    text: &'a str,
    is_meant: impl Fn(char) -> bool,
    spelling: impl Fn(char) -> String,
) -> Cow<'a, str> {
    if !text.contains(&is_meant) {
        return Cow::Borrowed(text);
    }
    let letters = text.chars().map(|letter| {
        if is_meant(letter) {
            spelling(letter)
        } else {
            letter.to_string()
        }
    });
    Cow::Owned(letters.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_a_terminal_is_spelt_out_and_what_people_read_stays() {
        let text = "μ₀ = 2\n\tאב \u{1b}[31m\u{9b}m\u{202e}gnp.exe\u{7}\r";
        let expected = "μ₀ = 2\n\tאב \\u{1b}[31m\\u{9b}m\\u{202e}gnp.exe\\u{7}\\u{d}";
        assert_eq!(printable(text), expected);
        assert!(matches!(printable("plain\n"), Cow::Borrowed("plain\n")));
    }

    #[test]
    fn a_json_document_stays_one_and_means_the_same() {
        let event = serde_json::json!({ "text": "\u{1b}[0m\u{9b}m\u{2066}\u{7f}é" });
        let text = event.to_string();
        let json = printable_json(&text);
        assert!(!json.contains(steers), "{json}");
        let read: serde_json::Value = serde_json::from_str(&json).expect("JSON");
        assert_eq!(read, event);
    }
}
