//! How many threads a run uses: as many as asked for, or as the cluster allots, or as there
//! are cores.

use std::num::NonZero;
use std::thread::available_parallelism;

use thiserror::Error;

use crate::allotted::{IgnoredSetting, allotted};

/// More threads than this for each core only cost memory, and the machine its
/// answer to anybody else.
const MOST_PER_CORE: usize = 8;

/// Variables in which a cluster says how many cores it allots, the most particular
/// first.
const ALLOTTED: [&str; 2] = ["SLURM_CPUS_PER_TASK", "SLURM_CPUS_ON_NODE"];

/// As many threads as the cluster allots, or as there are cores; with the variables of the cluster
/// that are ignored, because they are not a number of threads.
pub fn allotted_threads() -> (usize, Vec<IgnoredSetting>) {
    let cores = cores();
    let mut ignored = Vec::new();
    for name in ALLOTTED {
        let threads = allotted(name, |text| {
            let threads = text.parse().map_err(|_| ThreadsError::NoNumber)?;
            check(threads, cores)
        });
        match threads {
            Ok(Some(threads)) => return (threads, ignored),
            Ok(None) => {}
            Err(doubt) => ignored.push(doubt),
        }
    }
    (cores, ignored)
}

/// As many threads as asked for.
///
/// # Errors
/// Where their number is zero, or more than makes sense.
pub fn asked_threads(threads: usize) -> Result<usize, ThreadsError> {
    check(threads, cores())
}

fn cores() -> usize {
    available_parallelism().map_or(1, NonZero::get)
}

fn check(threads: usize, cores: usize) -> Result<usize, ThreadsError> {
    let most = cores.saturating_mul(MOST_PER_CORE);
    match threads {
        0 => Err(ThreadsError::TooFew),
        threads if threads > most => Err(ThreadsError::TooMany { most, cores }),
        threads => Ok(threads),
    }
}

/// Why no run uses this number of threads.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ThreadsError {
    /// What stands there is no number.
    #[error("it is not a number of threads")]
    NoNumber,
    /// None.
    #[error("at least one thread is needed")]
    TooFew,
    /// More than makes sense.
    #[error(
        "more than {most} threads, which are {} for each of {cores} cores here",
        MOST_PER_CORE
    )]
    TooMany {
        /// As many would do.
        most: usize,
        /// What the machine has for this process.
        cores: usize,
    },
}
