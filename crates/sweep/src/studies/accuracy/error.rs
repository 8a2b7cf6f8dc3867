//! Why nothing is chosen for an accuracy, or a candidate has none.

use linear::BuildError;
use thiserror::Error;

use crate::engine::Instability;
use crate::memory::{Limit, Size};
use crate::plan::Candidate;
use crate::studies::trial::TrialError;
use crate::sweep_file::{SweepFileError, per_cent};

/// Why nothing is chosen for an accuracy, or a candidate has none.
#[derive(Debug, Error)]
pub enum AccuracyError {
    /// A string is refused.
    #[error(transparent)]
    String(#[from] SweepFileError),
    /// A sampling frequency is refused for a string.
    #[error("{}", .0.message())]
    Sampling(#[source] SweepFileError),
    /// A case has no answer.
    #[error(transparent)]
    Trial(#[from] TrialError),
    /// A method has no responses of a string.
    #[error("{0:#}")]
    Build(anyhow::Error),
    /// A stuck site chatters.
    #[error("{0}")]
    Unstable(Instability),
    /// The linear responses are not those of the string.
    #[error(transparent)]
    Linear(#[from] BuildError),
    /// Systems take this much memory, more than the limit.
    #[error("is too large for the memory: {0}, more than {1}; --memory changes that")]
    TooLarge(Size, Limit),
    /// A candidate is not tried.
    #[error("{0} {1}")]
    Untried(Candidate, #[source] Box<AccuracyError>),
    /// There is no reference at a frequency, Hz.
    #[error("at {0} Hz the reference {1}")]
    NoReference(f64, #[source] Box<AccuracyError>),
    /// The reference has no uncertainty.
    #[error("the reference: {0}")]
    Reference(#[source] Box<AccuracyError>),
    /// There are no answers.
    #[error("there is nothing to compare")]
    NoAnswers,
    /// Only the reference has a limit near a case.
    #[error("the limit near case {0} is not found")]
    NoLimit(usize),
    /// The regimes of a case differ.
    #[error("case {case} is {found} instead of {expected}")]
    OtherRegimes {
        /// The case.
        case: usize,
        /// Its regimes.
        found: String,
        /// Those of the reference.
        expected: String,
    },
    /// No frequency is high enough for a reference of the accuracy asked for.
    #[error("{} % cannot be told: the reference is to be {best}", per_cent(*asked))]
    Uncertain {
        /// The accuracy.
        asked: f64,
        /// How certain the reference has to be, and what it is at best.
        best: String,
    },
    /// Everything tried is further from the reference than the accuracy asked for.
    #[error("nothing delivers {} %{best}", per_cent(*asked))]
    NothingDelivers {
        /// The accuracy.
        asked: f64,
        /// The best candidate, and why there are no others.
        best: String,
    },
}
