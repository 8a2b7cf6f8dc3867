//! What a results folder holds before a run, and whether the run may go on
//! from it.

use std::io::ErrorKind;
use std::path::Path;

use anyhow::{Context, Result, bail};

use super::UsageError;
use crate::engine::{Header, count_done, read_header};
use crate::output::{Manifest, differences};
use crate::spec::Sweep;

/// The log of a run that is not finished.
pub const LOG: &str = "cases.log";

/// What a run leaves when it is finished, and what was made of that.
const RESULTS: [&str; 7] = [
    "manifest.json",
    "labels.csv",
    "boundary.csv",
    "failures.csv",
    "map.svg",
    "map.png",
    "report.html",
];

/// Differences shown of two sweeps.
const MOST_DIFFERENCES: usize = 8;

/// What is in a folder.
pub enum Found {
    /// Nothing of a run.
    Nothing,
    /// A stopped run of the same sweep.
    Unfinished {
        /// Simulations done.
        done: usize,
    },
    /// The results of the same sweep.
    Complete(Box<Manifest>),
}

/// Looks at a folder.
///
/// # Errors
/// Where it holds the results, or a part of them, of another sweep, shard or
/// program.
pub fn look(folder: &Path, header: &Header, sweep: &Sweep) -> Result<Found> {
    let log = folder.join(LOG);
    if let Some(there) = read_header(&log)? {
        let what = format!("{} holds a stopped run of", folder.display());
        refuse_other(&what, &there, header)?;
        let done = count_done(&log, sweep.design.cases(), sweep.methods.len())?;
        return Ok(Found::Unfinished { done });
    }
    if !folder.join("manifest.json").exists() {
        return Ok(Found::Nothing);
    }
    let manifest = Manifest::read(folder)?;
    let program = manifest.program.clone();
    let there = Header::of(program, manifest.shard(), manifest.meaning()?);
    let what = format!("{} holds the results of", folder.display());
    refuse_other(&what, &there, header)?;
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
    if !folder.join("manifest.json").exists() {
        bail!(UsageError(format!(
            "{folder_name} holds no results: there is no manifest.json in it"
        )));
    }
    Ok(())
}

/// Removes the results of an earlier run.
///
/// # Errors
/// Where a file cannot be removed.
pub fn clear(folder: &Path) -> Result<()> {
    for name in RESULTS {
        let path = folder.join(name);
        match std::fs::remove_file(&path) {
            Err(error) if error.kind() != ErrorKind::NotFound => {
                return Err(error).with_context(|| format!("{} cannot be removed", path.display()));
            }
            _ => {}
        }
    }
    Ok(())
}
