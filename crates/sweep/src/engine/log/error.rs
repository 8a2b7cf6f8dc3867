//! Why a log is of no use.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

/// A log that cannot be used.
#[derive(Debug, Error)]
pub enum LogError {
    /// Another run writes it.
    #[error("another run is writing {0}; wait for it, or choose another --out")]
    Locked(PathBuf),
    /// It has no header of this program.
    #[error("{0} is not a log of this program; replace it with --fresh")]
    NotALog(PathBuf),
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
