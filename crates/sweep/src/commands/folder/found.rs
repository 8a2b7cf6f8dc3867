//! What a results folder holds before a run, and whether the run may continue from it.

use std::path::Path;

use anyhow::{Result, bail};

use super::damage::refuse_lost;
use super::names::{LOG, MANIFEST};
use super::owned_files::OwnedFiles;
use super::raise::with_our_number;
use crate::commands::status::UsageError;
use campaign::design::Design;
use campaign::engine::pairs_of;
use campaign::plan::Sweep;
use results::folder::{Manifest, differences};
use results::log::{Header, LogError, Place};

/// Differences shown of two sweeps.
const MOST_DIFFERENCES: usize = 8;

/// What is in a folder.
pub enum FolderState {
    /// Nothing that is in the way of a run, or only what it replaces.
    Nothing(OwnedFiles),
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

/// Examines the folder in which a run is to write; a `fresh` run ignores what is there.
///
/// # Errors
/// Where it holds the results, or a part of them, of another sweep, shard or
/// program; where its results are damaged; where it holds files of others that the
/// run would replace.
pub fn look(folder: &Path, header: &Header, sweep: &Sweep, fresh: bool) -> Result<FolderState> {
    let owned = OwnedFiles::find(folder, header)?;
    if !fresh {
        let log = folder.join(LOG);
        match &owned.log {
            Place::Log(there) => {
                let what = format!("{} holds a stopped run of", folder.display());
                refuse_other(&what, &with_our_number(&what, there, header)?, header)?;
                return Ok(FolderState::Unfinished {
                    had_fewer: there.fingerprint != header.fingerprint,
                });
            }
            Place::OtherFormat(format) => {
                bail!(UsageError(
                    LogError::OtherFormat {
                        path: log,
                        format: *format
                    }
                    .to_string()
                ))
            }
            Place::Free | Place::Torn => {}
        }
        if folder.join(MANIFEST).exists() {
            return complete(folder, header, sweep);
        }
    }
    let with_map = header.shard.is_whole() && sweep.map.is_some();
    let is_trace = matches!(sweep.design, Design::Trace(_));
    owned.refuse_foreign(folder, with_map, is_trace)?;
    Ok(FolderState::Nothing(owned))
}

fn complete(folder: &Path, header: &Header, sweep: &Sweep) -> Result<FolderState> {
    let manifest = Manifest::read(folder)?;
    let there = header_of(&manifest)?;
    let what = format!("{} holds the results of", folder.display());
    refuse_other(&what, &with_our_number(&what, &there, header)?, header)?;
    refuse_lost(&manifest, folder)?;
    let manifest = Box::new(manifest);
    if there.fingerprint != header.fingerprint {
        return Ok(FolderState::Fewer(manifest));
    }
    let (rows, all) = (manifest.tally.rows, pairs_of(sweep, header.shard));
    if rows != all && !manifest.is_trace() {
        bail!(
            "{} holds {rows} of {all} rows: begin anew with --fresh, or choose another --out",
            folder.display()
        );
    }
    Ok(FolderState::Complete(manifest))
}

/// The header that the log of finished results had.
///
/// # Errors
/// Where the manifest is damaged.
pub fn header_of(manifest: &Manifest) -> Result<Header> {
    let (program, shard) = (manifest.program.clone(), manifest.shard());
    Ok(Header::new(program, shard, manifest.fingerprint()?))
}

fn refuse_other(what: &str, there: &Header, owned: &Header) -> Result<()> {
    let other = if there.fingerprint != owned.fingerprint {
        let all = differences(&there.fingerprint, &owned.fingerprint);
        let more = match all.len().saturating_sub(MOST_DIFFERENCES) {
            0 => String::new(),
            more => format!(", and {more} more"),
        };
        let shown = all[..all.len().min(MOST_DIFFERENCES)].join("; ");
        format!("another sweep ({shown}{more})")
    } else if there.shard != owned.shard {
        format!("shard {} of this sweep, not {}", there.shard, owned.shard)
    } else if there.program != owned.program {
        format!(
            "another program, {}, and this is {}",
            there.program, owned.program
        )
    } else {
        return Ok(());
    };
    bail!(UsageError(format!(
        "{what} {other}: choose another --out, or begin anew with --fresh"
    )))
}
