//! Cases without an answer.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};

use campaign::text_file::unreadable;

/// Failures that are kept to be listed.
const MOST_LISTED: usize = 50;

/// A simulation without an answer: a row of `failures.csv`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FailureRow {
    /// Number of the case.
    pub case: usize,
    /// Name of the method.
    pub method: String,
    /// Why it has no answer.
    pub reason: String,
    /// The command that repeats it.
    pub repeat_with: String,
}

/// What `failures.csv` holds.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Failures {
    /// How many, by method.
    pub by_method: BTreeMap<String, usize>,
    /// The first of them.
    pub listed: Vec<FailureRow>,
}

impl Failures {
    /// Reads a `failures.csv`; only what is listed stays in memory.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub fn read(path: &Path) -> Result<Self> {
        let mut reader = csv::Reader::from_path(path).with_context(|| unreadable(path))?;
        let mut failures = Self::default();
        for failure in reader.deserialize() {
            let failure: FailureRow = failure.with_context(|| unreadable(path))?;
            let method = failure.method.clone();
            *failures.by_method.entry(method).or_default() += 1;
            if failures.listed.len() < MOST_LISTED {
                failures.listed.push(failure);
            }
        }
        Ok(failures)
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.by_method.values().sum()
    }
}
