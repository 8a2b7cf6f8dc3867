//! The texts of sweep files and of what they name; standard input, which is read once, where that
//! is the sweep file.

use std::io::{self, Error, ErrorKind};
use std::path::Path;
use std::sync::OnceLock;

use campaign::text_file::{self, is_standard_input, read_to_end};

/// What was read, or why it was not.
static STANDARD_INPUT: OnceLock<Result<String, (ErrorKind, String)>> = OnceLock::new();

/// Reads a file of at most a number of bytes, or standard input.
///
/// # Errors
/// Where it cannot be read, is larger, or is not UTF-8.
pub fn read_text(path: &Path, most: u64) -> io::Result<String> {
    if !is_standard_input(path) {
        return text_file::read_text(path, most);
    }
    let read = || {
        let text = read_to_end(io::stdin().lock(), most);
        text.map_err(|error| (error.kind(), error.to_string()))
    };
    let text = STANDARD_INPUT.get_or_init(read).clone();
    text.map_err(|(kind, reason)| Error::new(kind, reason))
}
