//! One case of a study: a sweep's scene under given conditions, stepped against one
//! method's system.

use anyhow::Result;
use sim::{Outcome, Stopping};

use crate::engine::{Case, CaseError, MethodSystem};
use crate::plan::{Conditions, Setting, Sweep};

/// The case of a sweep under given conditions, whose string is that of `setting`.
///
/// # Errors
/// Where the conditions say too little, or a rock's table does not reach them.
pub fn case(sweep: &Sweep, setting: &Setting, under: &Conditions) -> Result<Case, CaseError> {
    Case::under(sweep, setting, 0, Vec::new(), under)
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
) -> Result<Outcome> {
    let case = case(sweep, &system.setting, under)?;
    Ok(system.simulate(&case, stopping, None)?)
}
