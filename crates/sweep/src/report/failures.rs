//! Cases without an answer.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result};

use campaign::text_file::unreadable;

/// Failures that are kept to be listed.
const MOST_LISTED: usize = 50;

/// What `failures.csv` holds.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Failures {
    /// How many, by method.
    pub by_method: BTreeMap<String, usize>,
    /// The first of them: case, method, reason, and the command that repeats it.
    pub listed: Vec<[String; 4]>,
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
            let failure: [String; 4] = failure.with_context(|| unreadable(path))?;
            let method = failure[1].clone();
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
