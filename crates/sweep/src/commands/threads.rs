//! How many threads a command uses.

use anyhow::{Context, Result};
use campaign::threads::{allotted_threads, asked_threads};

use super::status::UsageError;
use super::terminal::Terminal;

/// Uses as many threads as asked for, or as the cluster allots, or as there are cores. An
/// impossible number in the cluster's variables is ignored with a warning.
///
/// # Errors
/// Where `jobs` is zero, or more than makes sense.
pub fn use_threads(jobs: Option<usize>, terminal: Terminal) -> Result<()> {
    let threads = match jobs {
        Some(jobs) => {
            asked_threads(jobs).map_err(|reason| UsageError(format!("--jobs {jobs}: {reason}")))?
        }
        None => {
            let (threads, ignored) = allotted_threads();
            for doubt in ignored {
                terminal.complain(&format!("warning: {doubt}"));
            }
            threads
        }
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global()
        .context("the threads cannot be started")
}
