//! The first line of a log: what the log belongs to.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::error::{LogError, file_error};
use super::line::{LONGEST_LINE, checked, parse_line};
use crate::engine::Shard;

/// Version of this format.
const FORMAT: u32 = 2;

/// First word of a header.
const HEADER: &str = "sweep-log";

/// What a log belongs to. Runs with another header do not go on from it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// Version of the format.
    format: u32,
    /// The program with its version.
    pub program: String,
    /// Which part of the sweep.
    pub shard: Shard,
    /// What the sweep means.
    pub meaning: serde_json::Value,
}

impl Header {
    /// The header of a run by this program.
    pub fn new(shard: Shard, meaning: serde_json::Value) -> Self {
        Self::of(crate::PROGRAM.to_owned(), shard, meaning)
    }

    /// The header of a run by any program.
    pub fn of(program: String, shard: Shard, meaning: serde_json::Value) -> Self {
        Self {
            format: FORMAT,
            program,
            shard,
            meaning,
        }
    }

    /// The first line of a log.
    ///
    /// # Errors
    /// None that a sweep that was read could cause.
    pub fn line(&self) -> serde_json::Result<String> {
        let json = serde_json::to_string(self)?;
        Ok(checked(&format!("{HEADER}\t{json}")))
    }

    /// What a line says, if it is a whole header.
    pub(super) fn parse(line: &[u8]) -> Option<Self> {
        let json = parse_line(line)?.strip_prefix(HEADER)?.strip_prefix('\t')?;
        serde_json::from_str(json).ok()
    }
}

/// Reads the header of a log, if there is a whole one.
///
/// # Errors
/// Where the file cannot be read.
pub fn read_header(path: &Path) -> Result<Option<Header>, LogError> {
    let read = || -> io::Result<Option<Header>> {
        let mut line = Vec::new();
        let mut reader = BufReader::new(File::open(path)?).take(LONGEST_LINE);
        reader.read_until(b'\n', &mut line)?;
        Ok(Header::parse(&line))
    };
    match read() {
        // A folder that is none is found when it is to be made.
        Err(error)
            if matches!(
                error.kind(),
                io::ErrorKind::NotFound | io::ErrorKind::NotADirectory
            ) =>
        {
            Ok(None)
        }
        result => result.map_err(|error| file_error(path, "read", error)),
    }
}
