//! Whether the files of a results folder are those that its manifest lists.

use std::path::Path;

use anyhow::{Context, Result};

use super::manifest::Manifest;
use crate::files::{Checksum, is_absent};
use campaign::text_file::unreadable;

/// The tables of a results folder.
pub const TABLES: [&str; 3] = ["labels.csv", "failures.csv", "boundary.csv"];

/// Its map.
pub const PICTURES: [&str; 2] = ["map.svg", "map.png"];

/// Its map for paper, which `plot` draws where it is asked for.
pub const PAPER_MAP: &str = "map.pdf";

/// What follows from the labels of a traced design.
pub const OF_TRACE: [&str; 2] = ["limits.csv", "bands.csv"];

/// A file that is not the one that was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Damage {
    /// The file's name.
    pub name: String,
    /// Its path, and what is wrong with it.
    pub words: String,
}

impl Manifest {
    /// Whether there are checksums, as version 0.1.0 kept none.
    pub fn has_checksums(&self) -> bool {
        !self.files.is_empty()
    }

    /// Which of these files of its folder are missing or damaged. Without checksums
    /// only what is missing is found.
    ///
    /// # Errors
    /// Where a file cannot be read.
    pub fn damage(&self, folder: &Path, names: &[&str]) -> Result<Vec<Damage>> {
        let mut found = Vec::new();
        for &name in names {
            let path = folder.join(name);
            let how = damage_of(&path, self.files.get(name), self.has_checksums());
            let how = how.with_context(|| unreadable(&path))?;
            found.extend(how.map(|how| Damage {
                name: name.to_owned(),
                words: format!("{} {how}", path.display()),
            }));
        }
        Ok(found)
    }

    /// Notes the checksums of files that were just written.
    ///
    /// # Errors
    /// Where one cannot be read back.
    pub fn note(&mut self, folder: &Path, names: &[&str]) -> Result<()> {
        for &name in names {
            let path = folder.join(name);
            let checksum = Checksum::of_file(&path).with_context(|| unreadable(&path))?;
            self.files.insert(name.to_owned(), checksum);
        }
        Ok(())
    }
}

/// How a file differs from what was noted of it, in words. Where others were noted and
/// it was not, it was never finished.
fn damage_of(
    path: &Path,
    expected: Option<&Checksum>,
    has_checksums: bool,
) -> std::io::Result<Option<String>> {
    let missing = || "is missing".to_owned();
    let bytes = match std::fs::metadata(path) {
        Err(error) if is_absent(&error) => return Ok(Some(missing())),
        found => found?.len(),
    };
    let Some(expected) = expected else {
        return Ok(has_checksums.then(missing));
    };
    if bytes != expected.bytes {
        return Ok(Some(format!(
            "is damaged: it has {bytes} bytes, and the one that was written {}",
            expected.bytes
        )));
    }
    let is_same = Checksum::of_file(path)? == *expected;
    let other = "is damaged: its SHA-256 is not that of the one that was written";
    Ok((!is_same).then(|| other.to_owned()))
}
