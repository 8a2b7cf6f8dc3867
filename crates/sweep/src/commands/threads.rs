//! How many threads a command uses: as many as asked for, or as the cluster
//! allots, or as there are cores.

use std::num::NonZero;
use std::thread::available_parallelism;

use anyhow::{Context, Result};
use thiserror::Error;

use super::status::UsageError;
use super::terminal::Terminal;
use campaign::allotted::allotted;

/// More threads than this for each core only cost memory, and the machine its
/// answer to anybody else.
const MOST_PER_CORE: usize = 8;

/// Variables in which a cluster says how many cores it allots, the most particular
/// first.
const ALLOTTED: [&str; 2] = ["SLURM_CPUS_PER_TASK", "SLURM_CPUS_ON_NODE"];

/// Uses as many threads as asked for, or as the cluster allots. A number that the
/// cluster's variables cannot mean is told and passed over.
///
/// # Errors
/// Where `jobs` is none, or more than makes sense.
pub fn use_threads(jobs: Option<usize>, terminal: Terminal) -> Result<()> {
    let cores = available_parallelism().map_or(1, NonZero::get);
    let threads = match jobs {
        Some(jobs) => {
            check(jobs, cores).map_err(|reason| UsageError(format!("--jobs {jobs}: {reason}")))?;
            jobs
        }
        None => (ALLOTTED.iter())
            .find_map(|name| allotted_threads(name, cores, terminal))
            .unwrap_or(cores),
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global()
        .context("the threads cannot be started")
}

fn allotted_threads(name: &'static str, cores: usize, terminal: Terminal) -> Option<usize> {
    let threads = allotted(name, |text| {
        let threads = text.parse().map_err(|_| ThreadsError::NoNumber)?;
        check(threads, cores).map(|()| threads)
    });
    threads.unwrap_or_else(|doubt| {
        terminal.complain(&format!("warning: {doubt}"));
        None
    })
}

/// Why no command uses so many threads.
#[derive(Debug, Error)]
enum ThreadsError {
    #[error("it is not a number of threads")]
    NoNumber,
    #[error("at least one thread is needed")]
    TooFew,
    #[error(
        "more than {most} threads, which are {} for each of {cores} cores here",
        MOST_PER_CORE
    )]
    TooMany { most: usize, cores: usize },
}

fn check(threads: usize, cores: usize) -> Result<(), ThreadsError> {
    let most = cores.saturating_mul(MOST_PER_CORE);
    match threads {
        0 => Err(ThreadsError::TooFew),
        threads if threads > most => Err(ThreadsError::TooMany { most, cores }),
        _ => Ok(()),
    }
}
