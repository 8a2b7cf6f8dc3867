//! The results that are in a folder, for who would read them.

use std::path::{Path, PathBuf};

use thiserror::Error;

use super::integrity::{Damage, PICTURES, TABLES};
use super::manifest::Manifest;
use super::tables::ResultTables;

/// The log of a run that is not finished.
pub const LOG: &str = "cases.log";

/// What a run that is finished says of itself.
pub const MANIFEST: &str = "manifest.json";

/// Why a folder has no results to read.
#[derive(Debug, Error)]
pub enum NoResults {
    /// There is no such folder.
    #[error("{} is not a folder", .0.display())]
    NoFolder(PathBuf),
    /// It has neither results nor a log.
    #[error("{} holds no results: there is no {MANIFEST} in it", .0.display())]
    Nothing(PathBuf),
    /// Its run has no case yet.
    #[error(
        "{} holds a run that has only just begun ({LOG}): the same `sweep run` as before \
         continues it",
        .0.display()
    )]
    JustBegun(PathBuf),
    /// A table cannot be read, or is not the one that was written.
    #[error("{0:#}")]
    Unreadable(anyhow::Error),
}

/// Refuses a path that is no folder, or a folder with neither results nor a log.
///
/// # Errors
/// What is missing.
pub fn refuse_empty(folder: &Path) -> Result<(), NoResults> {
    if !folder.is_dir() {
        return Err(NoResults::NoFolder(folder.to_owned()));
    }
    if !folder.join(LOG).exists() && !folder.join(MANIFEST).exists() {
        return Err(NoResults::Nothing(folder.to_owned()));
    }
    Ok(())
}

impl ResultTables {
    /// The tables of a folder: of a finished run, or of one that is not, as far as it is. `note`
    /// hears where they cannot be verified.
    ///
    /// # Errors
    /// Where there are none, or they are not those that were written.
    pub fn open(folder: &Path, note: impl FnOnce(String)) -> Result<Self, NoResults> {
        refuse_empty(folder)?;
        let log = folder.join(LOG);
        if log.exists() {
            let tables = ResultTables::so_far(&log).map_err(NoResults::Unreadable)?;
            return tables.ok_or_else(|| NoResults::JustBegun(folder.to_owned()));
        }
        let tables = ResultTables::finished(folder).map_err(NoResults::Unreadable)?;
        tables.manifest.unverified(folder).map(note);
        let damage = tables.manifest.damage(folder, &TABLES);
        let damage = damage.map_err(NoResults::Unreadable)?;
        if damage.is_empty() {
            return Ok(tables);
        }
        let is_lost = |damage: &Damage| !tables.manifest.can_make_again(&damage.name);
        Err(NoResults::Unreadable(damaged(
            &damage,
            damage.iter().any(is_lost),
        )))
    }
}

impl Manifest {
    /// That the tables of its folder are taken as they are, where nothing is known of them.
    pub fn unverified(&self, folder: &Path) -> Option<String> {
        (!self.has_checksums()).then(|| {
            format!(
                "{} was written by {}, which kept no checksums: its tables are not verified",
                folder.display(),
                self.program
            )
        })
    }

    /// Whether a file follows from the sweep and the labels: the limit, the map, and the
    /// list of failures where there is none.
    pub fn can_make_again(&self, name: &str) -> bool {
        match name {
            "failures.csv" => self.tally.failed == 0,
            _ => name == "boundary.csv" || PICTURES.contains(&name),
        }
    }
}

/// What is damaged, and what to do: whether something `is_lost` that only a new run would bring.
pub fn damaged(damage: &[Damage], is_lost: bool) -> anyhow::Error {
    let words: Vec<&str> = damage.iter().map(|damage| damage.words.as_str()).collect();
    let remedy = if is_lost {
        "put back a copy, or begin anew with --fresh"
    } else {
        "the same `sweep run` as before makes it again"
    };
    anyhow::anyhow!("{}: {remedy}", words.join("; "))
}
