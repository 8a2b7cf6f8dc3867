//! One case of a study: a sweep's scene under given conditions, stepped against one
//! method's system.

use sim::{Outcome, SimulationError, Stopping};
use thiserror::Error;

use crate::engine::{Case, CaseError, MethodSystem};
use crate::plan::{Conditions, Setting, Sweep};

/// Why a case has no answer.
#[derive(Debug, Error)]
pub enum TrialError {
    /// There is none.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// Its simulation gives up.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
}

/// The case of a sweep under given conditions, whose string is that of `setting`.
///
/// # Errors
/// Where the conditions say too little, or a rock's table does not reach them.
pub fn case(sweep: &Sweep, setting: &Setting, under: &Conditions) -> Result<Case, TrialError> {
    Ok(Case::under(sweep, setting, 0, Vec::new(), under)?)
}

/// What comes of that case by one method.
///
/// # Errors
/// Where the case gives no answer.
pub fn outcome(
    sweep: &Sweep,
    system: &MethodSystem,
    under: &Conditions,
    stopping: Stopping,
) -> Result<Outcome, TrialError> {
    let case = case(sweep, &system.setting, under)?;
    Ok(system.simulate(&case, stopping, None)?)
}
