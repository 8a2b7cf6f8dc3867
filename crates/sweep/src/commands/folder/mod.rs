//! What a results folder holds before a run, and whether the run may go on
//! from it.

mod damage;
mod hold;
mod ours;

pub use damage::{in_words, refuse_damaged, tell_if_unverified};
pub use hold::{hold, tidy};
pub use ours::{Ours, remove_page, written_by};

use std::path::Path;

use anyhow::{Result, bail};

use super::UsageError;
use super::raise::with_our_number;
use crate::engine::{Header, LogError, Place};
use crate::output::{Manifest, ResultTables, differences};
use crate::plan::Sweep;

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
    Unfinished {
        /// Whether it had fewer random cases.
        had_fewer: bool,
    },
    /// The results of the same sweep.
    Complete(Box<Manifest>),
    /// The results of the same sweep with fewer random cases.
    Fewer(Box<Manifest>),
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
                refuse_other(&what, &with_our_number(&what, there, header)?, header)?;
                return Ok(Found::Unfinished {
                    had_fewer: there.fingerprint != header.fingerprint,
                });
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
    let there = Header::of(program, manifest.shard(), manifest.fingerprint()?);
    let what = format!("{} holds the results of", folder.display());
    refuse_other(&what, &with_our_number(&what, &there, header)?, header)?;
    let had_fewer = there.fingerprint != header.fingerprint;
    damage::refuse_lost(&manifest, folder)?;
    Ok(if had_fewer {
        Found::Fewer(Box::new(manifest))
    } else {
        Found::Complete(Box::new(manifest))
    })
}

fn refuse_other(what: &str, there: &Header, ours: &Header) -> Result<()> {
    let remedy = "choose another --out, or begin anew with --fresh";
    if there.fingerprint != ours.fingerprint {
        let all = differences(&there.fingerprint, &ours.fingerprint);
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

/// Refuses a folder that is none, or has neither results nor a log.
///
/// # Errors
/// What is missing.
pub fn refuse_empty(folder: &Path) -> Result<()> {
    let folder_name = folder.display();
    if !folder.is_dir() {
        bail!(UsageError(format!("{folder_name} is not a folder")));
    }
    if !folder.join(LOG).exists() && !folder.join(MANIFEST).exists() {
        bail!(UsageError(format!(
            "{folder_name} holds no results: there is no manifest.json in it"
        )));
    }
    Ok(())
}

/// The tables of a folder: of a finished run, or of one that is not, as far as it is.
///
/// # Errors
/// Where there are none, or they are not those that were written.
pub fn tables_of(folder: &Path) -> Result<ResultTables> {
    refuse_empty(folder)?;
    let log = folder.join(LOG);
    if log.exists() {
        let Some(tables) = ResultTables::so_far(&log)? else {
            bail!(UsageError(format!(
                "{} holds a run that has only just begun ({LOG}): the same `sweep run` as before \
                 goes on with it",
                folder.display()
            )));
        };
        return Ok(tables);
    }
    let tables = ResultTables::finished(folder)?;
    refuse_damaged(&tables.manifest, folder)?;
    Ok(tables)
}
