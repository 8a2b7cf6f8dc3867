//! The line of a log with the description of an unfinished run for display, not interpreted here.
//! No run continues from it; the last one counts.

use std::path::Path;

use super::error::{LogError, file_error};
use super::line::{Scan, checked, parse_line};
use crate::files::open_if_there;

/// Its first word.
const ABOUT: &str = "sweep-run";

/// The line.
pub(super) fn about_line(about: &str) -> String {
    checked(&format!("{ABOUT}\t{about}"))
}

/// What a line says, if it is a whole one of this kind.
pub(super) fn parse_about(line: &[u8]) -> Option<String> {
    let about = parse_line(line)?.strip_prefix(ABOUT)?.strip_prefix('\t')?;
    Some(about.to_owned())
}

/// Reads the description of the run of a log; `None` where there is no log, or the run has not
/// written it yet.
///
/// # Errors
/// Where the log cannot be read.
pub fn read_about(path: &Path) -> Result<Option<String>, LogError> {
    let unreadable = |error| file_error(path, "read", error);
    let Some(file) = open_if_there(path).map_err(unreadable)? else {
        return Ok(None);
    };
    let mut about = None;
    let mut scan = Scan::new(&file).map_err(unreadable)?;
    while let Some(line) = scan.next_line().map_err(unreadable)? {
        about = parse_about(line.text).or(about);
    }
    Ok(about)
}
