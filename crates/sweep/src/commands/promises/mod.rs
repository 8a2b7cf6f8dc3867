//! `sweep promises`: how often an accuracy asked for is kept, or a label that is certain is
//! right, on strings drawn at random.

mod labels;
mod table;

use anyhow::Result;

use super::csv_table::csv_table;
use super::folder::make_folder;
use super::progress::Progress;
use super::status::Status;
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use crate::cli::PromisesArguments;
use crate::output::write_atomically;
use crate::studies::promises::{Motion, run, test_labels};
use table::{columns, summary};

/// Puts promises to the test and writes their table.
pub fn promises(arguments: &PromisesArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.jobs, terminal)?;
    make_folder(&arguments.out)?;
    let is_wanted =
        |motion: &Motion| arguments.motion.is_empty() || arguments.motion.contains(motion);
    let motions: Vec<Motion> = Motion::ALL.into_iter().filter(is_wanted).collect();
    let limit = arguments.memory.limit();
    let strings = arguments.strings.get();
    let progress = Progress::new(motions.len() * strings, 0, arguments.quiet, terminal);
    let tick = || progress.tick();
    let (name, table, text) = if arguments.labels {
        let found = test_labels(&motions, strings, arguments.seed, &tick);
        progress.finish();
        let tested = found?;
        let table = csv_table(tested.iter().map(labels::columns))?;
        ("labels.csv", table, labels::summary(&tested))
    } else {
        let found = run(&motions, strings, arguments.seed, &limit, &tick);
        progress.finish();
        let promises = found?;
        let table = csv_table(promises.iter().map(columns))?;
        ("promises.csv", table, summary(&promises))
    };
    write_atomically(&arguments.out.join(name), &table)?;
    if !arguments.quiet {
        say(&text)?;
    }
    Ok(Status::Complete)
}
