//! What is wrong with a sweep file, and where.

use std::borrow::Cow;
use std::fmt;
use std::path::{Path, PathBuf};

use crate::printable::steers;

/// One clear sentence about a sweep file that is refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweepFileError {
    pub(super) file: PathBuf,
    pub(super) line: Option<usize>,
    pub(super) key: Option<String>,
    pub(super) message: String,
}

impl SweepFileError {
    /// The file.
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// The line of it, from 1, where it is about one.
    pub fn line(&self) -> Option<usize> {
        self.line
    }

    /// The key as it is written there, where it is about one.
    pub fn key(&self) -> Option<&str> {
        self.key.as_deref()
    }

    /// What is wrong, without the place.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for SweepFileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let file = self.file.display();
        let line = self
            .line
            .map_or_else(String::new, |line| format!(":{line}"));
        let key = (self.key.as_deref()).map_or_else(String::new, |key| {
            format!(": `{}`", shortened(key, MOST_OF_KEY))
        });
        let message = shortened(&self.message, MOST_OF_MESSAGE);
        let text = format!("{file}{line}{key}: {message}");
        // What the file says in quotes may not break the line or steer a terminal.
        f.write_str(&text.replace(steers, " "))
    }
}

/// Letters of a key and of a message that are shown; those of the program are shorter.
const MOST_OF_KEY: usize = 200;
const MOST_OF_MESSAGE: usize = 8000;

/// The beginning of a text that is longer than a number of letters.
fn shortened(text: &str, most: usize) -> Cow<'_, str> {
    match text.char_indices().nth(most) {
        None => Cow::Borrowed(text),
        Some((end, _)) => Cow::Owned(format!("{}…", &text[..end])),
    }
}

impl std::error::Error for SweepFileError {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep_file::wording::nearest;

    #[test]
    fn a_key_of_any_length_is_refused_in_a_line() {
        let key = "friction".repeat(1_000_000);
        assert_eq!(nearest(&key, &["friction", "frictions"]), None);
        assert_eq!(nearest("frictoin", &["friction"]), Some("friction"));
        let error = SweepFileError {
            file: "sweep.toml".into(),
            line: Some(3),
            message: format!("unknown key `{key}`"),
            key: Some(key),
        };
        let said = error.to_string();
        assert!(
            said.len() < MOST_OF_KEY + MOST_OF_MESSAGE + 100,
            "{}",
            said.len()
        );
        assert!(said.starts_with("sweep.toml:3: `frictionfriction"));
    }
}
