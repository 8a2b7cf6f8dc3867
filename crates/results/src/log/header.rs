//! The first line of a log: what the log belongs to.

use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::error::{FORMAT, LogError, file_error};
use super::line::{LONGEST_LINE, checked, parse_line};
use crate::files::open_if_there;
use campaign::engine::Shard;

/// First word of a header.
const HEADER: &str = "sweep-log";

/// What a log belongs to. Runs with another header do not continue from it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// Version of the format.
    format: u64,
    /// The program with its version.
    pub program: String,
    /// Which part of the sweep.
    pub shard: Shard,
    /// What tells the run from others.
    #[serde(rename = "meaning")]
    pub fingerprint: serde_json::Value,
}

impl Header {
    /// The header of a run by a program, which is named with its version.
    pub fn new(program: String, shard: Shard, fingerprint: serde_json::Value) -> Self {
        Self {
            format: FORMAT,
            program,
            shard,
            fingerprint,
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

    /// What the first line of a log says, if it is a whole header.
    pub(super) fn parse(line: &[u8]) -> Option<Place> {
        let json = parse_line(line)?.strip_prefix(HEADER)?.strip_prefix('\t')?;
        let json: serde_json::Value = serde_json::from_str(json).ok()?;
        match json["format"].as_u64()? {
            FORMAT => Some(Place::Log(serde_json::from_value(json).ok()?)),
            other => Some(Place::OtherFormat(other)),
        }
    }
}

/// What is in the place of a log that is to be written.
#[derive(Debug, PartialEq)]
pub enum Place {
    /// Nothing.
    Free,
    /// The beginning of the very header that is to be written there.
    Torn,
    /// A log.
    Log(Box<Header>),
    /// A log of another version of the format.
    OtherFormat(u64),
}

/// Looks at what is in the place of a log that is to begin with `ours`.
///
/// # Errors
/// Where that is not a log, or cannot be read.
pub fn log_place(path: &Path, ours: &Header) -> Result<Place, LogError> {
    let Some(line) = first_line(path)? else {
        return Ok(Place::Free);
    };
    if let Some(place) = Header::parse(&line) {
        return Ok(place);
    }
    let header = ours.line();
    let header = header.map_err(|error| file_error(path, "read", error.into()))?;
    if header.as_bytes().starts_with(&line) {
        Ok(Place::Torn)
    } else {
        Err(LogError::NotALog(path.to_owned()))
    }
}

/// Reads the header of a log, if there is a whole one.
///
/// # Errors
/// Where the file cannot be read, or is of another version of the format.
pub fn read_header(path: &Path) -> Result<Option<Header>, LogError> {
    match first_line(path)?.and_then(|line| Header::parse(&line)) {
        Some(Place::Log(header)) => Ok(Some(*header)),
        Some(Place::OtherFormat(format)) => {
            let path = path.to_owned();
            Err(LogError::OtherFormat { path, format })
        }
        _ => Ok(None),
    }
}

/// The first line of a file, if it is there.
fn first_line(path: &Path) -> Result<Option<Vec<u8>>, LogError> {
    let read = || {
        let Some(file) = open_if_there(path)? else {
            return Ok(None);
        };
        let mut line = Vec::new();
        (BufReader::new(file).take(LONGEST_LINE)).read_until(b'\n', &mut line)?;
        Ok(Some(line))
    };
    read().map_err(|error| file_error(path, "read", error))
}
