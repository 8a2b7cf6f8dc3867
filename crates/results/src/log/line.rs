//! Lines with a checksum, what they say, and where they are in a file.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};

use campaign::records::Record;

/// A longer line was not written by this program, bytes.
pub(super) const LONGEST_LINE: u64 = 1 << 26;

/// The line of a text, such as the JSON of a record: with its checksum.
pub fn checked(text: &str) -> String {
    format!("{:08x}\t{text}\n", crc32fast::hash(text.as_bytes()))
}

/// What a line says, if it is whole.
pub(super) fn parse_line(line: &[u8]) -> Option<&str> {
    let line = std::str::from_utf8(line).ok()?.strip_suffix('\n')?;
    let (checksum, text) = line.split_once('\t')?;
    let digits = |byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f');
    let is_whole = checksum.len() == 8
        && checksum.bytes().all(digits)
        && u32::from_str_radix(checksum, 16) == Ok(crc32fast::hash(text.as_bytes()));
    is_whole.then_some(text)
}

/// The line of a record. Its numbers are read back to the last bit, for every one of them
/// is finite: a case with another has no answer.
///
/// # Errors
/// None that a case could cause.
pub fn record_line(record: &Record) -> serde_json::Result<String> {
    Ok(checked(&serde_json::to_string(record)?))
}

/// What a line says, if it is a whole record.
pub(super) fn parse_record(line: &[u8]) -> Option<Record> {
    serde_json::from_str(parse_line(line)?).ok()
}

/// Lines of a part of a file.
pub(super) struct Scan<'a> {
    reader: io::Take<BufReader<&'a File>>,
    line: Vec<u8>,
    at: u64,
}

/// A line and its bytes of the file.
pub(super) struct Line<'a> {
    pub text: &'a [u8],
    pub from: u64,
    pub to: u64,
}

impl<'a> Scan<'a> {
    pub fn new(file: &'a File) -> io::Result<Self> {
        let length = file.metadata()?.len();
        Self::between(file, 0, length)
    }

    pub fn between(mut file: &'a File, from: u64, to: u64) -> io::Result<Self> {
        file.seek(SeekFrom::Start(from))?;
        Ok(Self {
            reader: BufReader::with_capacity(1 << 16, file).take(to - from),
            line: Vec::new(),
            at: from,
        })
    }

    pub fn next_line(&mut self) -> io::Result<Option<Line<'_>>> {
        self.line.clear();
        let from = self.at;
        let read = self
            .reader
            .by_ref()
            .take(LONGEST_LINE)
            .read_until(b'\n', &mut self.line)?;
        if read == 0 {
            return Ok(None);
        }
        self.at += read as u64;
        Ok(Some(Line {
            text: &self.line,
            from,
            to: self.at,
        }))
    }
}
