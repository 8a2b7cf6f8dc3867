//! A log that is looked at, whether or not a run is writing it.

use std::fs::File;
use std::path::{Path, PathBuf};

use super::content::Content;
use super::error::{LogError, file_error};
use crate::engine::Record;

/// What a log had when it was opened; it is not locked, and stays as it is.
#[derive(Debug)]
pub struct LogView {
    path: PathBuf,
    file: File,
    content: Content,
}

impl LogView {
    /// Looks at the log of a sweep of so many cases and methods.
    ///
    /// # Errors
    /// Where it cannot be read or is no log.
    pub fn open(path: &Path, cases: usize, methods: usize) -> Result<Self, LogError> {
        let file = File::open(path).map_err(|error| file_error(path, "read", error))?;
        Ok(Self {
            path: path.to_owned(),
            content: Content::read(path, &file, cases, methods)?,
            file,
        })
    }

    /// How many pairs of case and method are done.
    pub fn count(&self) -> usize {
        self.content.count()
    }

    /// Gives all records to `each`, in the order of cases and methods: a block of whole
    /// cases at a time, so that no more is in memory.
    ///
    /// # Errors
    /// Where the log cannot be read, or what `each` returned.
    pub fn in_order(
        &self,
        each: impl FnMut(&[Record]) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        self.content.in_order(&self.path, &self.file, each)
    }
}
