//! The linear systems of a run, and what follows from them alone.

use anyhow::Result;

use super::task::Task;
use crate::commands::prepare::naming_file;
use crate::commands::status::UsageError;
use campaign::engine::MethodSystem;
use campaign::run::{RunError, RunSystems};
use limits::{Boundary, boundary};

/// What is built before the first case.
pub struct Systems {
    /// The linear systems.
    pub built: RunSystems,
    /// The analytic limit.
    pub limit: Boundary,
}

impl Systems {
    /// Builds them, within the memory that is allowed.
    ///
    /// # Errors
    /// Where they take more, or a method cannot treat the string.
    pub fn build(task: &Task) -> Result<Self> {
        let (arguments, campaign) = (task.arguments, &task.campaign);
        let limit = arguments.work.memory.limit();
        let built = campaign.build(&task.survey, arguments.options(), &limit);
        let built = built.map_err(|error| in_words(task, error))?;
        let limit = boundary(&campaign.sweep, &built.methods);
        Ok(Self {
            limit: limit.map_err(|error| UsageError(error.to_string()))?,
            built,
        })
    }
}

/// The linear systems of the sweep, however stable they are.
///
/// # Errors
/// Where a run takes more memory than is allowed, or a method cannot treat the string.
pub fn build_admitted(task: &Task) -> Result<Vec<MethodSystem>> {
    let limit = task.arguments.work.memory.limit();
    let built = RunSystems::admitted(&task.campaign.sweep, &task.survey, &limit);
    Ok(built.map_err(|error| in_words(task, error))?.methods)
}

/// Why a run does not begin, in the words of the command line.
fn in_words(task: &Task, error: RunError) -> anyhow::Error {
    let (arguments, sweep) = (task.arguments, &task.campaign.sweep);
    match error {
        RunError::Memory(error) => error,
        RunError::Systems(error) => naming_file(&arguments.file, error),
        RunError::Unstable(error) if arguments.work.methods.is_empty() => {
            let key = format!("methods[{}]", error.place);
            sweep.source.error(&key, error.to_string()).into()
        }
        RunError::Unstable(error) => UsageError(format!("--methods: {error}")).into(),
    }
}
