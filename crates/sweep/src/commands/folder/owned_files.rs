//! Which files of a folder a run of this program left there, by what its log and
//! its manifest say. No other is replaced or removed.

use std::collections::BTreeSet;
use std::io::ErrorKind;
use std::path::Path;

use anyhow::{Context, Result, bail};

use super::names::{LOG, MANIFEST, REPORT};
use crate::commands::status::UsageError;
use crate::report::is_page;
use campaign::text_file::unreadable;
use results::folder::{Manifest, OF_TRACE, PAPER_MAP, PICTURES, RECORDS, TABLES};
use results::log::{Header, Place, log_place};

/// The traces of an earlier run in a folder: which files are its own.
pub struct OwnedFiles {
    /// Its log.
    pub log: Place,
    /// The files that its manifest lists.
    of_manifest: BTreeSet<String>,
}

impl OwnedFiles {
    /// Looks for a log, which would begin with `header`, and a manifest.
    ///
    /// # Errors
    /// Where there is something else in the place of the log.
    pub fn find(folder: &Path, header: &Header) -> Result<Self> {
        Ok(Self {
            log: log_place(&folder.join(LOG), header)?,
            // A file that is no manifest lists nothing, and is foreign itself.
            of_manifest: Manifest::read(folder).map_or_else(|_| BTreeSet::new(), names_of),
        })
    }

    /// Refuses to write a run's files where others have files of these names.
    ///
    /// # Errors
    /// Which they are.
    pub fn refuse_foreign(&self, folder: &Path, with_map: bool, is_trace: bool) -> Result<()> {
        let foreign: Vec<&str> = promised(with_map, is_trace)
            .filter(|name| folder.join(name).symlink_metadata().is_ok())
            .filter(|name| self.log == Place::Free && !self.of_manifest.contains(*name))
            .collect();
        if foreign.is_empty() {
            return Ok(());
        }
        bail!(UsageError(format!(
            "{} holds {}, and nothing there says that a run of this program wrote that: choose \
             another --out, or move it away",
            folder.display(),
            foreign.join(", ")
        )))
    }

    /// Removes the results of an earlier run, and the page about them.
    ///
    /// # Errors
    /// Where a file cannot be removed.
    pub fn remove_results(&self, folder: &Path) -> Result<()> {
        // A run that was killed while it finished has left some of its tables.
        let may_be_half = matches!(self.log, Place::Log(_) | Place::OtherFormat(_));
        let derived = PICTURES.into_iter().chain([PAPER_MAP]).chain(OF_TRACE);
        let all = [MANIFEST, RECORDS].into_iter().chain(TABLES).chain(derived);
        for name in all {
            let is_table = [MANIFEST, RECORDS].contains(&name) || TABLES.contains(&name);
            if self.of_manifest.contains(name) || may_be_half && is_table {
                remove(&folder.join(name))?;
            }
        }
        remove_page(folder)
    }
}

/// Removes the page about a folder, which is of an earlier state of it.
///
/// # Errors
/// Where it cannot be removed.
pub fn remove_page(folder: &Path) -> Result<()> {
    let page = folder.join(REPORT);
    let is_ours = is_page(&page);
    if is_ours.with_context(|| unreadable(&page))? {
        remove(&page)?;
    }
    Ok(())
}

/// The files of a folder with this manifest, itself among them.
fn names_of(manifest: Manifest) -> BTreeSet<String> {
    let promised = promised(manifest.draws(), manifest.is_trace()).map(str::to_owned);
    promised.chain(manifest.files.into_keys()).collect()
}

/// The files that a run leaves in its folder.
fn promised(with_map: bool, is_trace: bool) -> impl Iterator<Item = &'static str> {
    let pictures = PICTURES.into_iter().filter(move |_| with_map);
    let of_trace = OF_TRACE.into_iter().filter(move |_| is_trace);
    [MANIFEST, RECORDS]
        .into_iter()
        .chain(TABLES)
        .chain(pictures)
        .chain(of_trace)
}

fn remove(path: &Path) -> Result<()> {
    match std::fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => {
            Err(error).with_context(|| format!("{} cannot be removed", path.display()))
        }
        _ => Ok(()),
    }
}
