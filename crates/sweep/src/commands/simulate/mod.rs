//! `sweep simulate`: a case in full (Figs. 7, 8, 10–13, 15 and 16), or a few together. A case of
//! the sweep is the case that `run` runs: the same linear systems, built for as long, and the same
//! row; its history is followed to the end of its time.

mod film;
mod writing;

use std::path::Path;

use anyhow::Result;

use super::drawing::Drawing;
use super::folder::results_folder;
use super::prepare::{naming_file, open, unique};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use super::warnings::{warn_of_few_sites, warn_of_sweep};
use crate::cli::SimulateArguments;
use campaign::engine::{ChoiceError, Instability, RunOptions};
use campaign::follow::{FollowError, Following, KeptSystems};
use campaign::plan::Sweep;
use campaign::records::Record;
use writing::Written;

/// Simulates the chosen cases with every method and keeps their time histories.
pub fn simulate(arguments: &SimulateArguments, terminal: Terminal) -> Result<Status> {
    let SimulateArguments {
        file, work, full, ..
    } = arguments;
    let drawing = Drawing::of(&arguments.picture)?.over(&arguments.ranges);
    use_threads(work.jobs, terminal)?;
    let campaign = open(file, work, *full, false, terminal)?;
    let sweep = &campaign.sweep;
    warn_of_sweep(sweep, terminal);
    warn_of_few_sites(sweep, terminal);
    let methods: Vec<usize> = (0..sweep.methods.len()).collect();
    let cases = unique(&arguments.case);
    let chosen = campaign.cases(&cases, &arguments.set, &methods);
    let chosen = match chosen.map_err(|error| in_words(error, file))? {
        Ok(chosen) => chosen,
        Err(rows) => return Ok(tell_of_failures(sweep, &rows, terminal)),
    };
    film::refuse_idle(&chosen.sweep, &chosen.cases, &arguments.film)?;
    let memory = work.memory.limit();
    let following = Following {
        options: RunOptions {
            full: *full,
            allow_unstable: arguments.allow_unstable,
        },
        memory: Some((&memory, arguments.film.frames_asked())),
        warn: &|instability: &Instability| terminal.complain(&format!("warning: {instability}")),
    };
    let followed = chosen.follow(&following, &mut KeptSystems::default());
    let followed = followed.map_err(|error| not_followed(error, file))?;
    if !followed.simulations.is_empty() {
        let folder = results_folder(arguments.out.as_ref(), &followed.sweep);
        let written = Written {
            followed: &followed,
            folder: &folder,
            drawing: &drawing,
        };
        say(&written.write(&arguments.film)?)?;
    }
    Ok(tell_of_failures(&followed.sweep, &followed.rows, terminal))
}

/// Why cases cannot be chosen as they are asked for, in the words of the command line.
fn in_words(error: ChoiceError, file: &Path) -> anyhow::Error {
    let message = match error {
        ChoiceError::File(error) => return error.into(),
        ChoiceError::NoCase { index, last } => {
            format!("--case {index}: {} has cases 0 to {last}", file.display())
        }
        ChoiceError::Set { .. } => format!("--set {error}"),
        ChoiceError::DifferentStrings => format!("--case: {error}"),
        ChoiceError::SharedString(reason) => format!("{}: {reason}", file.display()),
        ChoiceError::WeightWithoutRock | ChoiceError::Case(_) => error.to_string(),
    };
    UsageError(message).into()
}

/// Why cases are not followed, in the words of the command line.
pub fn not_followed(error: FollowError, file: &Path) -> anyhow::Error {
    let message = match error {
        FollowError::Systems(error) => return naming_file(file, error),
        FollowError::Memory(error) | FollowError::Motion(error) => return error,
        FollowError::Sites(error) => return error.into(),
        FollowError::DifferentSites => {
            format!("{error}: simulate one --case by one of --methods at a time")
        }
        FollowError::Case(_) => error.to_string(),
    };
    UsageError(message).into()
}

/// Says which cases have no answer, and why.
fn tell_of_failures(sweep: &Sweep, rows: &[Record], terminal: Terminal) -> Status {
    let mut status = Status::Complete;
    for row in rows {
        if let Err(reason) = &row.outcome {
            let (case, method) = (row.case, sweep.methods[row.method].name());
            terminal.complain(&format!(
                "error: case {case} by {method} has no answer: {reason}"
            ));
            status = Status::SomeFailed;
        }
    }
    status
}
