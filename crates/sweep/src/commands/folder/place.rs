//! Where results go.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use campaign::plan::Sweep;

/// The folder for a sweep's results.
pub fn results_folder(out: Option<&PathBuf>, sweep: &Sweep) -> PathBuf {
    out.cloned()
        .unwrap_or_else(|| Path::new("results").join(&sweep.name))
}

/// Makes a folder; its error names the folder.
///
/// # Errors
/// Where it cannot be made.
pub fn make_folder(folder: &Path) -> Result<()> {
    std::fs::create_dir_all(folder)
        .with_context(|| format!("the folder {} cannot be made", folder.display()))
}
