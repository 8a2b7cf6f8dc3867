//! Files that are there whole or not at all, known again by their checksums, in
//! folders that one command at a time writes.

mod checksum;
mod lock;
mod regular;
mod temporary;

pub use checksum::{Checksum, Summing, hexadecimal};
pub use lock::{FolderLock, LockError};
pub use regular::{is_absent, refuse_irregular};
pub use temporary::{has_left, remove_left};

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use tempfile::NamedTempFile;

/// A file that is written under another name in the same folder, and gets its
/// own when it is whole and on the disk. Names are unique, so that two programs
/// that write the same file do not mix.
pub struct AtomicFile {
    path: PathBuf,
    writer: BufWriter<NamedTempFile>,
    sum: Summing,
}

impl AtomicFile {
    /// Begins a file.
    ///
    /// # Errors
    /// Where its folder cannot be written.
    pub fn create(path: &Path) -> Result<Self> {
        let file = temporary::temporary(folder_of(path)).with_context(|| unwritable(path))?;
        Ok(Self {
            path: path.to_owned(),
            writer: BufWriter::new(file),
            sum: Summing::default(),
        })
    }

    /// Adds to it.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn write(&mut self, content: &[u8]) -> Result<()> {
        let mut attempt = || {
            self.sum.write_all(content)?;
            self.writer.write_all(content)
        };
        attempt().with_context(|| unwritable(&self.path))
    }

    /// Puts it on the disk, without its name yet.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn seal(self) -> Result<SealedFile> {
        let Self { path, writer, sum } = self;
        let attempt = || -> io::Result<NamedTempFile> {
            let file = writer.into_inner().map_err(|error| error.into_error())?;
            make_readable(file.as_file())?;
            file.as_file().sync_all()?;
            Ok(file)
        };
        let file = attempt().with_context(|| unwritable(&path))?;
        Ok(SealedFile {
            path,
            file,
            checksum: sum.finish(),
        })
    }

    /// Puts it on the disk and gives it its name.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn finish(self) -> Result<Checksum> {
        self.seal()?.publish()
    }
}

/// A whole file on the disk that does not have its name yet; without it, it goes.
pub struct SealedFile {
    path: PathBuf,
    file: NamedTempFile,
    checksum: Checksum,
}

impl SealedFile {
    /// What it holds.
    pub fn checksum(&self) -> &Checksum {
        &self.checksum
    }

    /// Gives it its name.
    ///
    /// # Errors
    /// Where its folder cannot be written.
    pub fn publish(self) -> Result<Checksum> {
        let attempt = || -> io::Result<()> {
            self.file.persist(&self.path).map_err(|error| error.error)?;
            sync_folder(folder_of(&self.path))
        };
        attempt().with_context(|| unwritable(&self.path))?;
        Ok(self.checksum)
    }
}

/// The folder of a file; a bare name is in the working folder.
pub fn folder_of(path: &Path) -> &Path {
    let folder = path.parent().filter(|folder| *folder != Path::new(""));
    folder.unwrap_or(Path::new("."))
}

fn unwritable(path: &Path) -> String {
    format!("{} cannot be written", path.display())
}

/// Writes a whole file.
///
/// # Errors
/// Where it cannot be written; what was there before stays.
pub fn write_atomically(path: &Path, content: &[u8]) -> Result<()> {
    write_with_checksum(path, content).map(drop)
}

/// The same of a file that is to be known again.
///
/// # Errors
/// As [`write_atomically`].
pub fn write_with_checksum(path: &Path, content: &[u8]) -> Result<Checksum> {
    let mut file = AtomicFile::create(path)?;
    file.write(content)?;
    file.finish()
}

/// Opens what is to be a file, if it is there. A folder that is none is found when it is
/// to be made.
///
/// # Errors
/// Where it cannot be opened, or is something else.
pub fn open_if_there(path: &Path) -> io::Result<Option<File>> {
    refuse_irregular(path)?;
    match File::open(path) {
        Err(error) if is_absent(&error) => Ok(None),
        file => file.map(Some),
    }
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
