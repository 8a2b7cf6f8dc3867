//! What a cluster allots to a job, in variables of its environment.

use std::env::var_os;
use std::fmt::Display;

use thiserror::Error;

/// A variable with an impossible value.
#[derive(Debug, Error)]
#[error("{name}={text:?} is ignored: {reason}")]
pub struct IgnoredSetting {
    name: &'static str,
    text: String,
    reason: String,
}

/// What a variable means, where it says anything.
///
/// # Errors
/// Where the value is impossible, with the reason.
pub fn allotted<T, E: Display>(
    name: &'static str,
    meaning: impl FnOnce(&str) -> Result<T, E>,
) -> Result<Option<T>, IgnoredSetting> {
    let text = var_os(name).unwrap_or_default();
    let text = text.to_string_lossy();
    // An empty variable is how a shell script unsets one.
    if text.trim().is_empty() {
        return Ok(None);
    }
    let meaning = meaning(text.trim()).map(Some);
    meaning.map_err(|reason| IgnoredSetting {
        name,
        reason: reason.to_string(),
        text: text.into_owned(),
    })
}
