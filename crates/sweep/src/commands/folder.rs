//! What a results folder holds before a run, and whether the run may go on
//! from it.

use std::io::ErrorKind;
use std::path::Path;

use anyhow::{Context, Result, bail};

use super::UsageError;
use super::raise::with_our_number;
use crate::engine::{Header, LogView, read_header};
use crate::output::{Manifest, Tables, differences};
use crate::spec::Sweep;

/// The log of a run that is not finished.
pub const LOG: &str = "cases.log";

/// What `report` makes of one folder.
pub const REPORT: &str = "report.html";

/// What a run leaves when it is finished, and what was made of that.
const RESULTS: [&str; 7] = [
    "manifest.json",
    "labels.csv",
    "boundary.csv",
    "failures.csv",
    "map.svg",
    "map.png",
    REPORT,
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
        /// Whether it had fewer random cases.
        had_fewer: bool,
    },
    /// The results of the same sweep.
    Complete(Box<Manifest>),
    /// The results of the same sweep with fewer random cases.
    Fewer(Box<Manifest>),
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
        let had = there.meaning.clone();
        let there = with_our_number(&what, there, header)?;
        refuse_other(&what, &there, header)?;
        let view = LogView::open(&log, sweep.design.cases(), sweep.methods.len())?;
        return Ok(Found::Unfinished {
            done: view.count(),
            had_fewer: had != header.meaning,
        });
    }
    if !folder.join("manifest.json").exists() {
        return Ok(Found::Nothing);
    }
    let manifest = Manifest::read(folder)?;
    let program = manifest.program.clone();
    let there = Header::of(program, manifest.shard(), manifest.meaning()?);
    let what = format!("{} holds the results of", folder.display());
    let had = there.meaning.clone();
    let there = with_our_number(&what, there, header)?;
    refuse_other(&what, &there, header)?;
    Ok(if had == header.meaning {
        Found::Complete(Box::new(manifest))
    } else {
        Found::Fewer(Box::new(manifest))
    })
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

/// The tables of a folder: of a finished run, or of one that is not, as far as it is.
///
/// # Errors
/// Where there are none.
pub fn tables_of(folder: &Path) -> Result<Tables> {
    let folder_name = folder.display();
    if !folder.is_dir() {
        bail!(UsageError(format!("{folder_name} is not a folder")));
    }
    let log = folder.join(LOG);
    if log.exists() {
        let Some(tables) = Tables::so_far(&log)? else {
            bail!(UsageError(format!(
                "{folder_name} holds a run that has only just begun ({LOG}): the same `sweep run` \
                 as before goes on with it"
            )));
        };
        return Ok(tables);
    }
    if !folder.join("manifest.json").exists() {
        bail!(UsageError(format!(
            "{folder_name} holds no results: there is no manifest.json in it"
        )));
    }
    Tables::finished(folder)
}

/// Removes the results of an earlier run.
///
/// # Errors
/// Where a file cannot be removed.
pub fn clear(folder: &Path) -> Result<()> {
    RESULTS.iter().try_for_each(|name| remove(folder, name))
}

/// Removes a report, which is of an earlier state of the folder.
///
/// # Errors
/// Where it cannot be removed.
pub fn remove_report(folder: &Path) -> Result<()> {
    remove(folder, REPORT)
}

fn remove(folder: &Path, name: &str) -> Result<()> {
    let path = folder.join(name);
    match std::fs::remove_file(&path) {
        Err(error) if error.kind() != ErrorKind::NotFound => {
            Err(error).with_context(|| format!("{} cannot be removed", path.display()))
        }
        _ => Ok(()),
    }
}
