//! `sweep study`: the studies of the program itself.

use anyhow::Result;

use super::status::Status;
use super::terminal::Terminal;
use super::{contacts, promises, stability, tradeoff};
use crate::cli::Study;

/// Makes a study.
///
/// # Errors
/// Where that study has one.
pub fn study(study: &Study, terminal: Terminal) -> Result<Status> {
    match study {
        Study::Tradeoff(arguments) => tradeoff::tradeoff(arguments, terminal),
        Study::Stability(arguments) => stability::stability(arguments, terminal),
        Study::Promises(arguments) => promises::promises(arguments, terminal),
        Study::Contacts(arguments) => contacts::contacts(arguments, terminal),
    }
}
