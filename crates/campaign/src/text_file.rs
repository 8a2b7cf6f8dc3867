//! Text files that a user names, read whole: UTF-8, or refused with what they are instead. A pipe
//! is refused, since one without a writer would be waited for, and so is a file that is far too
//! large.

use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

/// Most bytes of a sweep file together with its bases. Every case by hand would be
/// in a list.
pub const LARGEST_SWEEP_FILE: u64 = 16 << 20;

/// Most bytes of a table: a hundred for each of as many cases as there can be.
pub const LARGEST_TABLE: u64 = 1 << 30;

/// Gives the text of a file that has at most a number of bytes: from the disk or, in
/// tests, from memory.
pub type TextOf<'a> = &'a dyn Fn(&Path, u64) -> Result<String>;

/// How a file that starts with it says that it is UTF-16.
const UTF_16_MARKS: [[u8; 2]; 2] = [[0xff, 0xfe], [0xfe, 0xff]];

/// Reads a file of at most a number of bytes.
///
/// # Errors
/// Where it cannot be read, is no file, is larger, or is not UTF-8.
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
    // What the system says of the size need not be true.
    if metadata.len() > most {
        return Err(too_large(most));
    }
    read_to_end(File::open(path)?, most)
}

/// What a sweep file that is read from standard input is called; a command line says `-`.
pub const STANDARD_INPUT: &str = "<standard input>";

/// Whether that is a sweep file's name.
pub fn is_standard_input(path: &Path) -> bool {
    path == Path::new(STANDARD_INPUT)
}

/// Reads a text of at most a number of bytes to its end.
///
/// # Errors
/// Where it cannot be read, is larger, or is not UTF-8.
pub fn read_to_end(source: impl Read, most: u64) -> Result<String> {
    let mut bytes = Vec::new();
    if source.take(most + 1).read_to_end(&mut bytes)? as u64 > most {
        return Err(too_large(most));
    }
    text_of(bytes)
}

fn too_large(most: u64) -> Error {
    let reason = format!("it is larger than {} MiB", most >> 20);
    Error::new(ErrorKind::InvalidInput, reason)
}

/// The message about a file that cannot be read.
pub fn unreadable(path: &Path) -> String {
    format!("{} cannot be read", path.display())
}

fn text_of(bytes: Vec<u8>) -> Result<String> {
    String::from_utf8(bytes).map_err(|error| {
        let bytes = error.as_bytes();
        let message = if UTF_16_MARKS.iter().any(|mark| bytes.starts_with(mark)) {
            "it is UTF-16; save it as UTF-8".to_owned()
        } else {
            let place = error.utf8_error().valid_up_to();
            let line = 1 + bytes[..place].iter().filter(|&&byte| byte == b'\n').count();
            format!(
                "byte 0x{:02X} on line {line} is not UTF-8; if this is text, it may be \
                 Latin-1: save it as UTF-8",
                bytes[place]
            )
        };
        Error::new(ErrorKind::InvalidData, message)
    })
}
