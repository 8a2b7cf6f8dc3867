//! Why a log is of no use.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

/// Version of the format of logs.
pub(super) const FORMAT: u64 = 3;

/// A log that cannot be used.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LogError {
    /// It has no header of this program.
    #[error(
        "{0} is not a log of this program, or its first line is damaged: move it away, or choose \
         another --out"
    )]
    NotALog(PathBuf),
    /// It is written in another way.
    #[error(
        "{path} is a log of format {format}, by another version of this program, and this one \
         reads format {FORMAT}: continue with that version, choose another --out, or begin anew with \
         --fresh"
    )]
    OtherFormat {
        /// The log.
        path: PathBuf,
        /// Its format.
        format: u64,
    },
    /// Records that were in it are gone.
    #[error("{0} was emptied, replaced or damaged by another program, and records in it are lost")]
    Changed(PathBuf),
    /// It cannot be read or written.
    #[error("{path} cannot be {what}: {error}")]
    File {
        /// The log.
        path: PathBuf,
        /// `read` or `written`.
        what: &'static str,
        /// What the system says.
        error: io::Error,
    },
}

pub(super) fn file_error(path: &Path, what: &'static str, error: io::Error) -> LogError {
    LogError::File {
        path: path.to_owned(),
        what,
        error,
    }
}
