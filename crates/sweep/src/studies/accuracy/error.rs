//! Why an accuracy cannot be chosen for, or a candidate has none.

use linear::BuildError;
use thiserror::Error;

use crate::engine::Instability;
use crate::memory::{Limit, Size};
use crate::plan::Candidate;
use crate::studies::trial::TrialError;
use crate::sweep_file::{SweepFileError, per_cent};

/// Why an accuracy cannot be chosen for, or a candidate has none.
#[derive(Debug, Error)]
pub enum AccuracyError {
    /// A string cannot be.
    #[error(transparent)]
    String(#[from] SweepFileError),
    /// A string cannot be sampled at a frequency.
    #[error("{}", .0.message())]
    Sampling(#[source] SweepFileError),
    /// A case has no answer.
    #[error(transparent)]
    Trial(#[from] TrialError),
    /// A method cannot treat a string.
    #[error("{0:#}")]
    Build(anyhow::Error),
    /// A stuck site chatters.
    #[error("{0}")]
    Unstable(Instability),
    /// The linear responses are not those of the string.
    #[error(transparent)]
    Linear(#[from] BuildError),
    /// Systems take too much memory.
    #[error("is too large for the memory: {bytes}, more than {limit}; --memory changes that")]
    TooLarge {
        /// What they take.
        bytes: Size,
        /// What they may.
        limit: Limit,
    },
    /// A candidate cannot be tried.
    #[error("{candidate} {source}")]
    Untried {
        /// Which.
        candidate: Candidate,
        /// Why.
        source: Box<AccuracyError>,
    },
    /// The reference cannot be built.
    #[error("at {frequency} Hz the reference {source}")]
    NoReference {
        /// Its sampling frequency, Hz.
        frequency: f64,
        /// Why.
        source: Box<AccuracyError>,
    },
    /// The reference has no uncertainty.
    #[error("the reference: {0}")]
    Reference(#[source] Box<AccuracyError>),
    /// There are no answers.
    #[error("there is nothing to compare")]
    NoAnswers,
    /// The uncertainty of a reference takes two doublings.
    #[error("there are not three frequencies to compare")]
    TooFewFrequencies,
    /// Only the reference has a limit.
    #[error("the limit near case {case} is not found")]
    NoLimit {
        /// The case.
        case: usize,
    },
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
    /// No frequency is high enough for a reference.
    #[error(
        "{} % cannot be told: the reference is to be certain to {} %, but {best}",
        per_cent(*asked),
        per_cent(*certain)
    )]
    Uncertain {
        /// The accuracy.
        asked: f64,
        /// What the uncertainty may be.
        certain: f64,
        /// The last change, or why there is none.
        best: String,
    },
    /// Everything tried is too far from the reference.
    #[error("nothing delivers {} %{best}", per_cent(*asked))]
    NothingDelivers {
        /// The accuracy.
        asked: f64,
        /// The best candidate, and why there are no others.
        best: String,
    },
}
