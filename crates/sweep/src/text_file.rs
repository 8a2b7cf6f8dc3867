//! Text files that a user names, read whole: a pipe is refused, for one that nobody
//! writes to would be waited for, and so is what is too large to be meant.

use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

/// Most bytes of a sweep file together with its bases. Every case by hand would be
/// in a list.
pub const LARGEST_SWEEP_FILE: u64 = 16 << 20;

/// Most bytes of a table: a hundred for each of as many cases as there can be.
pub const LARGEST_TABLE: u64 = 1 << 30;

/// Reads a file of at most so many bytes.
///
/// # Errors
/// Where it cannot be read, is none, is larger, or is not UTF-8.
pub fn read_text(path: &Path, most: u64) -> Result<String> {
    // Before it is opened: that alone waits for the other end of a pipe.
    let metadata = std::fs::metadata(path)?;
    let refuse = |reason: String| Err(Error::new(ErrorKind::InvalidInput, reason));
    if metadata.is_dir() {
        return refuse("it is a folder".to_owned());
    }
    if !metadata.is_file() {
        return refuse("it is a pipe or a device, not a file".to_owned());
    }
    let mut text = String::new();
    // What the system says of the size need not be true.
    let mut file = File::open(path)?.take(most + 1);
    if metadata.len() > most || file.read_to_string(&mut text)? as u64 > most {
        return refuse(format!("it is larger than {} MiB", most >> 20));
    }
    Ok(text)
}
