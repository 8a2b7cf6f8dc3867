//! Files that are there whole or not at all.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use tempfile::NamedTempFile;

/// A file that is written under another name in the same folder, and gets its
/// own when it is whole and on the disk. Names are unique, so that two programs
/// that write the same file do not mix.
pub struct AtomicFile {
    path: PathBuf,
    writer: BufWriter<NamedTempFile>,
}

impl AtomicFile {
    /// Begins a file.
    ///
    /// # Errors
    /// Where its folder cannot be written.
    pub fn create(path: &Path) -> Result<Self> {
        let file = NamedTempFile::new_in(folder_of(path)).with_context(|| unwritable(path))?;
        Ok(Self {
            path: path.to_owned(),
            writer: BufWriter::new(file),
        })
    }

    /// Adds to it.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn write(&mut self, content: &[u8]) -> Result<()> {
        (self.writer.write_all(content)).with_context(|| unwritable(&self.path))
    }

    /// Gives it its name.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn finish(self) -> Result<()> {
        let Self { path, writer } = self;
        let attempt = || -> std::io::Result<()> {
            let file = writer.into_inner().map_err(|error| error.into_error())?;
            make_readable(file.as_file())?;
            file.as_file().sync_all()?;
            file.persist(&path).map_err(|error| error.error)?;
            sync_folder(folder_of(&path))
        };
        attempt().with_context(|| unwritable(&path))
    }
}

/// The folder a file is in; a bare name has an empty one, which is the present.
fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

fn unwritable(path: &Path) -> String {
    format!("{} cannot be written", path.display())
}

/// Writes a whole file.
///
/// # Errors
/// Where it cannot be written; what was there before stays.
pub fn write_atomically(path: &Path, content: &[u8]) -> Result<()> {
    let mut file = AtomicFile::create(path)?;
    file.write(content)?;
    file.finish()
}

/// A temporary file is private; a result is for everybody the folder is for.
#[cfg(unix)]
fn make_readable(file: &File) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.set_permissions(fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn make_readable(_: &File) -> std::io::Result<()> {
    Ok(())
}

/// The new name itself must survive a power loss.
#[cfg(unix)]
fn sync_folder(folder: &Path) -> std::io::Result<()> {
    File::open(folder)?.sync_all()
}

#[cfg(not(unix))]
fn sync_folder(_: &Path) -> std::io::Result<()> {
    Ok(())
}
