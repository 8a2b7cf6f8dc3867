//! `sweep simulate`: a case in full (Figs. 7, 8, 10–13, 15 and 16), or a few together. A case of
//! the sweep is the case that `run` runs: the same linear systems, built for as long, and the same
//! row; its history is followed to the end of its time.

mod film;
mod found;
mod systems;
mod writing;

use std::path::Path;

use anyhow::Result;

use super::drawing::Drawing;
use super::folder::results_folder;
use super::prepare::{read_sweep, unique};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use super::warnings::warn_of_sweep;
use crate::cli::SimulateArguments;
use campaign::engine::{Case, Survey};
use campaign::engine::{Choice, ChoiceError, ChosenCase, common_setting};
use campaign::memory::{Limit, Purpose, admit};
use campaign::plan::Sweep;
use campaign::records::{Failure, Record};
use campaign::sweep_file::SweepFileError;
use found::{at_found_sites, find_sites};
use systems::simulate_all;
use writing::Written;

/// Simulates the chosen cases with every method and keeps their time histories.
pub fn simulate(arguments: &SimulateArguments, terminal: Terminal) -> Result<Status> {
    let SimulateArguments {
        file, work, full, ..
    } = arguments;
    let drawing = Drawing::of(&arguments.picture)?.over(&arguments.ranges);
    use_threads(work.jobs, terminal)?;
    let sweep = read_sweep(file, work, *full, false, terminal)?;
    warn_of_sweep(&sweep, terminal);
    let asked_for = |error| in_words(error, file);
    let choices = (unique(&arguments.case).into_iter())
        .map(|index| Choice::new(&sweep, index, &arguments.set))
        .collect::<Result<Vec<_>, _>>()
        .map_err(asked_for)?;
    let sweep = match common_setting(&sweep, &choices).map_err(asked_for)? {
        Ok(setting) => Sweep { setting, ..sweep },
        Err(reason) => {
            let rows = failed_rows(&sweep, &choices, &reason);
            return Ok(tell_of_failures(&sweep, &rows, terminal));
        }
    };
    let cases = (choices.into_iter())
        .map(|choice| choice.case(&sweep))
        .collect::<Result<Vec<_>, _>>()
        .map_err(asked_for)?;
    film::refuse_idle(&sweep, &cases, &arguments.film)?;
    let shapes = arguments.film.frames_asked();
    admit_histories(&sweep, &cases, shapes, &work.memory.limit())?;
    let (sweep, cases, rows_found) = match find_sites(&sweep, arguments, &cases, terminal)? {
        None => (sweep, cases, None),
        Some(rows) if rows.iter().any(|row| row.outcome.is_err()) => {
            return Ok(tell_of_failures(&sweep, &rows, terminal));
        }
        Some(rows) => {
            let (sweep, cases) = at_found_sites(sweep, cases, &rows)?;
            admit_histories(&sweep, &cases, shapes, &work.memory.limit())?;
            (sweep, cases, Some(rows))
        }
    };
    let (rows, simulations) = simulate_all(&sweep, arguments, &cases, terminal)?;
    // Those of a run, which say in how many rounds sites were found.
    let rows = rows_found.unwrap_or(rows);
    let cases: Vec<Case> = cases.into_iter().map(|chosen| chosen.case).collect();
    if !simulations.is_empty() {
        let folder = results_folder(arguments.out.as_ref(), &sweep);
        let written = Written {
            sweep: &sweep,
            cases: &cases,
            rows: &rows,
            simulations: &simulations,
            folder: &folder,
            drawing: &drawing,
        };
        say(&written.write(&arguments.film)?)?;
    }
    Ok(tell_of_failures(&sweep, &rows, terminal))
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
        ChoiceError::Beside(reason) => format!("{}: {reason}", file.display()),
        ChoiceError::WeightWithoutRock | ChoiceError::Case(_) => error.to_string(),
    };
    UsageError(message).into()
}

/// Refuses what would take more memory than is allowed.
fn admit_histories(
    sweep: &Sweep,
    cases: &[ChosenCase],
    shapes: usize,
    limit: &Limit,
) -> Result<()> {
    let longest = cases.iter().map(|chosen| chosen.longest);
    let survey = Survey {
        longest: longest.fold(0.0, f64::max),
        ..Survey::default()
    };
    let purpose = Purpose::Histories {
        cases: cases.len(),
        shapes,
    };
    admit(sweep, &sweep.setting, &survey, purpose, limit)?;
    Ok(())
}

/// Rows of cases whose values make no string.
fn failed_rows(sweep: &Sweep, choices: &[Choice], reason: &SweepFileError) -> Vec<Record> {
    let of_choice = |choice: &Choice| -> Vec<Record> {
        let row = |method| {
            let values = choice.values.clone();
            Record::failed(choice.index, method, values, Failure::new(reason))
        };
        (0..sweep.methods.len()).map(row).collect()
    };
    choices.iter().flat_map(of_choice).collect()
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
