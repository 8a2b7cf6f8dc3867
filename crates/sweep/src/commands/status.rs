//! How the program ends.

use std::process::ExitCode;

use linear::{BuildError, ResponseError};
use sim::SimulationError;
use thiserror::Error;

use campaign::sweep_file::SweepFileError;

/// How the program ended; the numbers are its exit codes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Everything asked for is done.
    Complete = 0,
    /// Something went wrong that is not the user's doing.
    Error = 1,
    /// The command line or the sweep file does not make sense.
    BadInput = 2,
    /// Finished, but some cases gave no answer.
    SomeFailed = 3,
    /// Shards are missing.
    Incomplete = 4,
    /// Labels differ from their reference.
    LabelsDiffer = 5,
    /// Stopped by Ctrl-C; what is done is kept.
    Interrupted = 130,
    /// Stopped by SIGTERM; what is done is kept.
    Terminated = 143,
}

impl Status {
    /// Of a command that ended with an error.
    pub fn of(error: &anyhow::Error) -> Self {
        // What a method cannot treat is what the sweep file asks for.
        let is_asked_for = error.is::<SweepFileError>()
            || error.is::<UsageError>()
            || error.is::<BuildError>()
            || error.is::<ResponseError>()
            || matches!(error.downcast_ref(), Some(SimulationError::Responses(_)));
        if is_asked_for {
            Status::BadInput
        } else {
            Status::Error
        }
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        ExitCode::from(status as u8)
    }
}

/// A request that does not make sense though each of its parts does.
#[derive(Debug, Error)]
#[error("{0}")]
pub struct UsageError(pub String);
