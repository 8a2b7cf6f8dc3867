//! What a results folder holds before a run, and whether the run may go on
//! from it.

mod damage;
mod hold;
mod ours;

pub use damage::{in_words, refuse_damaged, tell_if_unverified};
pub use hold::{hold, tidy};
pub use ours::{Ours, written_by};

use std::path::Path;

use anyhow::{Result, bail};

use super::UsageError;
use crate::engine::{Header, LogError, Place};
use crate::output::{Manifest, differences};
use crate::spec::Sweep;

/// The log of a run that is not finished.
pub const LOG: &str = "cases.log";

/// What a run that is finished says of itself.
pub const MANIFEST: &str = "manifest.json";

/// The page about a folder.
pub const REPORT: &str = "report.html";

/// Differences shown of two sweeps.
const MOST_DIFFERENCES: usize = 8;

/// What is in a folder.
pub enum Found {
    /// Nothing that is in the way of a run, or only what it replaces.
    Nothing(Ours),
    /// A stopped run of the same sweep.
    Unfinished,
    /// The results of the same sweep.
    Complete(Box<Manifest>),
}

/// Looks at a folder in which a run is to write; a `fresh` one goes on from nothing.
///
/// # Errors
/// Where it holds the results, or a part of them, of another sweep, shard or
/// program; where its results are damaged; where it holds files of others that the
/// run would replace.
pub fn look(folder: &Path, header: &Header, sweep: &Sweep, fresh: bool) -> Result<Found> {
    let ours = Ours::find(folder, header)?;
    if !fresh {
        let log = folder.join(LOG);
        match &ours.log {
            Place::Log(there) => {
                let what = format!("{} holds a stopped run of", folder.display());
                refuse_other(&what, there, header)?;
                return Ok(Found::Unfinished);
            }
            Place::OtherFormat(format) => {
                bail!(UsageError(
                    LogError::other_format(&log, *format).to_string()
                ))
            }
            Place::Free | Place::Torn => {}
        }
        if folder.join(MANIFEST).exists() {
            return complete(folder, header);
        }
    }
    ours.refuse_foreign(folder, &written_by(sweep, header.shard))?;
    Ok(Found::Nothing(ours))
}

fn complete(folder: &Path, header: &Header) -> Result<Found> {
    let manifest = Manifest::read(folder)?;
    let program = manifest.program.clone();
    let there = Header::of(program, manifest.shard(), manifest.meaning()?);
    let what = format!("{} holds the results of", folder.display());
    refuse_other(&what, &there, header)?;
    damage::refuse_lost(&manifest, folder)?;
    Ok(Found::Complete(Box::new(manifest)))
}

fn refuse_other(what: &str, there: &Header, ours: &Header) -> Result<()> {
    let remedy = "choose another --out, or begin anew with --fresh";
    if there.meaning != ours.meaning {
        let all = differences(&there.meaning, &ours.meaning);
        let more = match all.len().saturating_sub(MOST_DIFFERENCES) {
            0 => String::new(),
            more => format!(", and {more} more"),
        };
        let shown = &all[..all.len().min(MOST_DIFFERENCES)];
        bail!(UsageError(format!(
            "{what} another sweep ({}{more}): {remedy}",
            shown.join("; ")
        )));
    }
    if there.shard != ours.shard {
        bail!(UsageError(format!(
            "{what} shard {} of this sweep, not {}: {remedy}",
            there.shard, ours.shard
        )));
    }
    if there.program != ours.program {
        bail!(UsageError(format!(
            "{what} another program, {}, and this is {}: {remedy}",
            there.program, ours.program
        )));
    }
    Ok(())
}

/// Refuses a folder that has no results, or not all of them yet.
///
/// # Errors
/// What is missing.
pub fn refuse_unfinished(folder: &Path) -> Result<()> {
    let folder_name = folder.display();
    if !folder.is_dir() {
        bail!(UsageError(format!("{folder_name} is not a folder")));
    }
    if folder.join(LOG).exists() {
        bail!(UsageError(format!(
            "{folder_name} holds a stopped run ({LOG}): the same `sweep run` as before finishes it"
        )));
    }
    if !folder.join(MANIFEST).exists() {
        bail!(UsageError(format!(
            "{folder_name} holds no results: there is no manifest.json in it"
        )));
    }
    Ok(())
}
