//! One file for each command, and what they share: exit codes, threads,
//! progress.

mod case_lines;
pub mod check;
mod choosing;
mod complete;
mod cost;
mod folder;
mod history;
pub mod inspect;
pub mod merge;
mod motion;
pub mod new;
pub mod plot;
mod progress;
mod raise;
pub mod report;
pub mod run;
pub mod shell;
pub mod simulate;
pub mod stability;
pub mod stop;
mod threads;
pub mod tradeoff;

use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::{Context, Result};
use linear::{BuildError, ResponseError};
use serde_json::json;
use sim::SimulationError;

use crate::cli::WorkArguments;
use crate::engine::{MethodSystem, Survey, survey};
use crate::plan::{Setting, Sweep};
use crate::printable::{printable, printable_json};
use crate::sweep_file::{MethodName, SweepFileError};
use choosing::choose;
use progress::Progress;
use threads::use_threads;

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

/// A request that does not make sense though each of its parts does.
#[derive(Debug)]
pub struct UsageError(pub String);

impl std::fmt::Display for UsageError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for UsageError {}

/// Prints an error and tells which exit code it is.
pub fn report(error: &anyhow::Error) -> Status {
    complain(&format!("error: {error:#}"));
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

/// Prints lines to standard output, and nothing that steers a terminal, whoever
/// wrote the files it comes from. A reader who has seen enough
/// (`sweep inspect FILE | head -1`) is no error, and no reason to panic.
fn say(text: &str) -> Result<()> {
    let mut output = std::io::stdout().lock();
    match output
        .write_all(printable(text).as_bytes())
        .and_then(|()| output.flush())
    {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result.context("standard output cannot be written"),
    }
}

/// Whether what is told on the error stream is one JSON object a line.
static TELLS_JSON: AtomicBool = AtomicBool::new(false);

/// Prints a line to standard error, where anybody listens.
fn complain(line: &str) {
    if TELLS_JSON.load(Ordering::Relaxed) {
        tell(&json!({ "event": "message", "text": line }));
    } else {
        let _ = writeln!(std::io::stderr(), "{}", printable(line));
    }
}

/// Prints an event to standard error.
fn tell(event: &serde_json::Value) {
    let json = event.to_string();
    let _ = writeln!(std::io::stderr(), "{}", printable_json(&json));
}

/// Reads a sweep file and puts the methods asked for in place of its own; or chooses
/// one, where it asks for an accuracy, telling what it tries unless `quiet`.
fn read_sweep(file: &Path, work: &WorkArguments, full: bool, quiet: bool) -> Result<Sweep> {
    let mut methods: Vec<MethodName> = Vec::new();
    for &name in &work.methods {
        if !methods.contains(&name) {
            methods.push(name);
        }
    }
    let sweep = Sweep::read_with_methods(file, &methods)?;
    choose(sweep, full, &work.memory.limit(), quiet)
}

/// The folder for a sweep's results.
fn results_folder(out: Option<&PathBuf>, sweep: &Sweep) -> PathBuf {
    out.cloned()
        .unwrap_or_else(|| Path::new("results").join(&sweep.name))
}

/// Makes a folder, and says which where it cannot be.
fn make_folder(folder: &Path) -> Result<()> {
    std::fs::create_dir_all(folder)
        .with_context(|| format!("the folder {} cannot be made", folder.display()))
}

/// How a site is called in pictures.
fn site_title(distance: f64) -> String {
    if distance == 0.0 {
        "the bit".to_owned()
    } else {
        format!("{distance} m above the bit")
    }
}

/// A look at every case before any is run.
fn survey_cases(file: &Path, sweep: &Sweep) -> Result<Survey> {
    let survey =
        survey(sweep).map_err(|reason| UsageError(format!("{}: {reason}", file.display())))?;
    if let Some((case, end)) = survey.first_end {
        sweep.impulses_are_felt(case, end)?;
    }
    Ok(survey)
}

/// The linear system of every method, for a string and times up to the longest.
fn build_systems(
    file: &Path,
    sweep: &Sweep,
    setting: &Setting,
    longest_time: f64,
) -> Result<Vec<MethodSystem>> {
    MethodSystem::build_all(sweep, setting, longest_time).map_err(|error| {
        // An error in the file names its place already.
        if error.is::<SweepFileError>() {
            error
        } else {
            error.context(file.display().to_string())
        }
    })
}

/// Warns of parts of the string such as none are made.
fn warn_of_string(sweep: &Sweep) {
    for doubt in sweep.doubts_about_string() {
        complain(&format!("warning: {doubt}"));
    }
}

/// Warns of methods that chatter where a site sticks.
fn warn_of_unstable<'a>(systems: impl IntoIterator<Item = &'a MethodSystem>) {
    for instability in systems.into_iter().filter_map(MethodSystem::instability) {
        complain(&format!("warning: {instability}"));
    }
}
