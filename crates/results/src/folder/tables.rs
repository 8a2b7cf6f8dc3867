//! The tables of a results folder, of a run that is finished or of one that is not.
//!
//! A run that is not finished has its rows in its log, in the order in which they were
//! done. They are sorted into tables of a temporary folder: the run's own folder does not
//! change, and memory does not grow with the rows.

use std::fmt;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use serde::Serialize;
use tempfile::TempDir;

use super::about::About;
use super::manifest::Manifest;
use super::results::TableWriter;
use super::tally::Tally;
use crate::log::{LogView, read_about};
use limits::{Boundary, read_boundary};

/// A results folder, ready to be shown.
pub struct ResultTables {
    /// What was run.
    pub manifest: Manifest,
    /// How far it is, where it is not finished.
    pub so_far: Option<SoFar>,
    /// Where they are.
    pub folder: PathBuf,
    /// Holds the tables of a run that is not finished.
    _temporary: Option<TempDir>,
}

/// How far a run is that is not finished.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct SoFar {
    /// Simulations done.
    pub done: usize,
    /// Simulations in all, where that is known beforehand.
    pub of: Option<usize>,
}

impl fmt::Display for SoFar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = self.of.map_or_else(String::new, |of| format!(" of {of}"));
        write!(f, "unfinished: {}{of} simulations", self.done)
    }
}

impl ResultTables {
    /// Those of a finished run.
    ///
    /// # Errors
    /// Where the manifest cannot be read.
    pub fn finished(folder: &Path) -> Result<Self> {
        Ok(Self {
            manifest: Manifest::read(folder)?,
            so_far: None,
            folder: folder.to_owned(),
            _temporary: None,
        })
    }

    /// Those of a run that has the given log, up to now; none where there is no such log,
    /// or the run has only just begun. Cases that some method has not
    /// answered yet are left out.
    ///
    /// # Errors
    /// Where the log cannot be read, or the temporary folder cannot be written.
    pub fn so_far(log: &Path) -> Result<Option<Self>> {
        let Some(text) = read_about(log)? else {
            return Ok(None);
        };
        let mut about = serde_json::from_str::<About>(&text)
            .with_context(|| format!("{} is of another version of this program", log.display()))?;
        let methods = about.manifest.methods.len();
        let view = LogView::open(log, about.manifest.cases, methods)?;
        let temporary = tempfile::tempdir().context("a temporary folder cannot be made")?;
        let folder = temporary.path().to_owned();
        about.manifest.tally = write_so_far(&about, &view, &folder)?;
        Ok(Some(Self {
            so_far: Some(SoFar {
                done: view.counts.done,
                of: about.simulations,
            }),
            manifest: about.manifest,
            folder,
            _temporary: Some(temporary),
        }))
    }

    /// The limit; it is written when a run is finished, and has no point before.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub fn boundary(&self) -> Result<Boundary> {
        match self.so_far {
            None => read_boundary(&self.folder.join("boundary.csv")),
            Some(_) => Ok(Boundary::StickSlip(Vec::new())),
        }
    }
}

fn write_so_far(about: &About, view: &LogView, folder: &Path) -> Result<Tally> {
    let mut tables = TableWriter::create(about, folder)?;
    let methods = about.manifest.methods.len();
    view.in_order(|records| {
        let cases = records.chunk_by(|one, next| one.case == next.case);
        let answered = cases.filter(|case| case.len() == methods);
        tables.add(&answered.flatten().cloned().collect::<Vec<_>>())
    })?;
    Ok(tables.finish()?.0)
}
