//! What a cluster allots to a job, in variables of its environment.

use std::env::var_os;
use std::fmt::Display;

use thiserror::Error;

/// A variable that says what it cannot mean.
#[derive(Debug, Error)]
#[error("{name}={text:?} is passed over: {reason}")]
pub struct PassedOver {
    name: &'static str,
    text: String,
    reason: String,
}

/// What a variable means, where it says anything.
///
/// # Errors
/// Where it cannot be meant, with the reason.
pub fn allotted<T, E: Display>(
    name: &'static str,
    meaning: impl FnOnce(&str) -> Result<T, E>,
) -> Result<Option<T>, PassedOver> {
    let text = var_os(name).unwrap_or_default();
    let text = text.to_string_lossy();
    // An empty variable is how a shell script unsets one.
    if text.trim().is_empty() {
        return Ok(None);
    }
    let meaning = meaning(text.trim()).map(Some);
    meaning.map_err(|reason| PassedOver {
        name,
        reason: reason.to_string(),
        text: text.into_owned(),
    })
}
