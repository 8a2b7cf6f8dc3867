//! Text files that people write: UTF-8, or refused with what they are instead.

use std::io;
use std::path::Path;

/// How a file that starts with it says that it is UTF-16.
const UTF_16_MARKS: [[u8; 2]; 2] = [[0xff, 0xfe], [0xfe, 0xff]];

/// The whole text of a file.
///
/// # Errors
/// Where it cannot be read or is not UTF-8.
pub fn read_text(path: &Path) -> io::Result<String> {
    text_of(std::fs::read(path)?)
}

fn text_of(bytes: Vec<u8>) -> io::Result<String> {
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
        io::Error::new(io::ErrorKind::InvalidData, message)
    })
}
