//! From a sweep file to what its cases need, as every command that simulates does it.

use std::path::Path;

use anyhow::Result;

use super::choosing::choose;
use super::input::read_text;
use super::status::UsageError;
use super::terminal::Terminal;
use super::warnings::warn_of_memory;
use crate::cli::WorkArguments;
use campaign::engine::{MethodSystem, Recipe, Survey};
use campaign::plan::{Setting, Sweep};
use campaign::sweep_file::SweepFileError;
use campaign::{Campaign, SurveyError};

/// Opens a sweep file and replaces its methods by those asked for; or chooses one, where it asks
/// for an accuracy, reporting what it tries unless `quiet`.
///
/// # Errors
/// Where the file does not make sense, or no method is accurate enough.
pub fn open(
    file: &Path,
    work: &WorkArguments,
    full: bool,
    quiet: bool,
    terminal: Terminal,
) -> Result<Campaign> {
    warn_of_memory(&work.memory, terminal);
    let methods = unique(&work.methods);
    let campaign = Campaign::open(file, &methods, &read_text)?;
    choose(campaign, full, &work.memory.limit(), quiet, terminal)
}

/// What is named in a list, once each.
pub fn unique<T: Copy + PartialEq>(list: &[T]) -> Vec<T> {
    let is_first = |&(place, item): &(usize, &T)| !list[..place].contains(item);
    let first = list.iter().enumerate().filter(is_first);
    first.map(|(_, item)| *item).collect()
}

/// A look at every case before any is run.
///
/// # Errors
/// Where a case is refused, or an impulse of it is not felt.
pub fn survey_cases(file: &Path, campaign: &Campaign) -> Result<Survey> {
    campaign.survey().map_err(|error| match error {
        SurveyError::Case(reason) => UsageError(format!("{}: {reason}", file.display())).into(),
        SurveyError::File(error) => error.into(),
    })
}

/// The linear system of every method, for a string and times up to the longest.
///
/// # Errors
/// What a method cannot treat.
pub fn build_systems(
    file: &Path,
    sweep: &Sweep,
    setting: &Setting,
    longest_time: f64,
) -> Result<Vec<MethodSystem>> {
    let systems = Recipe::build_each(sweep, setting, longest_time, &[]);
    let systems: Result<_> = systems.into_iter().collect();
    systems.map_err(|error| naming_file(file, error))
}

/// An error of a sweep file's systems, which names the file.
pub fn naming_file(file: &Path, error: anyhow::Error) -> anyhow::Error {
    // An error in the file names its place already.
    if error.is::<SweepFileError>() {
        error
    } else {
        error.context(file.display().to_string())
    }
}
