//! How many threads a command uses: as many as asked for, or as the cluster
//! allots, or as there are cores.

use std::num::NonZero;
use std::thread::available_parallelism;

use anyhow::{Context, Result};

use super::status::UsageError;
use super::terminal::Terminal;

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
            .find_map(|name| allotted(name, cores, terminal))
            .unwrap_or(cores),
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global()
        .context("the threads cannot be started")
}

fn allotted(name: &str, cores: usize, terminal: Terminal) -> Option<usize> {
    let value = std::env::var_os(name)?;
    let text = value.to_string_lossy();
    // An empty variable is how a shell script unsets one.
    if text.trim().is_empty() {
        return None;
    }
    let threads = (text.trim().parse::<usize>())
        .map_err(|_| "it is not a number of threads".to_owned())
        .and_then(|threads| check(threads, cores).map(|()| threads));
    match threads {
        Ok(threads) => Some(threads),
        Err(reason) => {
            terminal.complain(&format!(
                "warning: {name}={text:?} is passed over: {reason}"
            ));
            None
        }
    }
}

/// The error is a sentence.
fn check(threads: usize, cores: usize) -> Result<(), String> {
    let most = cores.saturating_mul(MOST_PER_CORE);
    match threads {
        0 => Err("at least one thread is needed".to_owned()),
        threads if threads > most => Err(format!(
            "more than {most} threads, which are {MOST_PER_CORE} for each of {cores} cores here"
        )),
        _ => Ok(()),
    }
}
