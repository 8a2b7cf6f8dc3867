//! A line of a log after its first: a case done by one method.

use super::line::{checked, parse_line};
use crate::engine::Record;

/// The line. Its numbers are read back to the last bit, for every one of them is
/// finite: a case with another has no answer.
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
