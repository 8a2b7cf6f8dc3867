//! Files that are there whole or not at all, known again by their checksums, in
//! folders that one command at a time writes.
//!
//! ```
//! use results::files::{AtomicFile, Checksum, FolderLock, LockError, write_with_checksum};
//!
//! let folder = tempfile::tempdir()?;
//! let _lock = FolderLock::take(folder.path())?;
//! assert!(matches!(FolderLock::take(folder.path()), Err(LockError::Taken)));
//!
//! let path = folder.path().join("labels.csv");
//! let written = write_with_checksum(&path, b"case,torsion\n0,smooth\n")?;
//! assert_eq!(Checksum::of_file(&path)?, written);
//! // What is not finished leaves the file as it was.
//! let mut unfinished = AtomicFile::create(&path)?;
//! unfinished.write(b"case,")?;
//! drop(unfinished);
//! assert_eq!(Checksum::of_file(&path)?, written);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod checksum;
mod destination;
mod lock;
mod regular;
mod temporary;

pub use checksum::{Checksum, Summing, hexadecimal};
pub use lock::{FolderLock, LockError};
pub use regular::{is_absent, refuse_irregular};
pub use temporary::{has_left, remove_left};

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use destination::{Destination, destination};
use tempfile::NamedTempFile;

/// A file that is written under another name in the same folder, and gets its
/// own when it is whole and on the disk. Names are unique, so that two programs
/// that write the same file do not mix. A link is followed; a device or a pipe is written to as it
/// is.
pub struct AtomicFile {
    /// As the user named it.
    path: PathBuf,
    writer: Writer,
    sum: Summing,
}

enum Writer {
    /// What is to have a name.
    File(PathBuf, BufWriter<NamedTempFile>),
    /// What has one.
    Stream(BufWriter<File>),
}

impl AtomicFile {
    /// Begins a file.
    ///
    /// # Errors
    /// Where its folder cannot be written.
    pub fn create(path: &Path) -> Result<Self> {
        let attempt = || {
            Ok(match destination(path)? {
                Destination::Stream(stream) => Writer::Stream(BufWriter::new(stream)),
                Destination::File(name) => {
                    // What a killed command has left there goes, whichever it was.
                    let _ = remove_left(folder_of(&name));
                    let file = temporary::temporary(folder_of(&name))?;
                    Writer::File(name, BufWriter::new(file))
                }
            })
        };
        let writer: io::Result<Writer> = attempt();
        Ok(Self {
            path: path.to_owned(),
            writer: writer.with_context(|| unwritable(path))?,
            sum: Summing::default(),
        })
    }

    /// Adds to it.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn write(&mut self, content: &[u8]) -> Result<()> {
        Ok(self.write_all(content)?)
    }

    /// Puts it on the disk, without its name yet.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn seal(self) -> Result<SealedFile> {
        let Self { path, writer, sum } = self;
        let attempt = || -> io::Result<Option<(PathBuf, NamedTempFile)>> {
            match writer {
                Writer::File(name, writer) => {
                    let file = writer.into_inner().map_err(|error| error.into_error())?;
                    file.as_file().sync_all()?;
                    Ok(Some((name, file)))
                }
                Writer::Stream(mut stream) => stream.flush().map(|()| None),
            }
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
    /// With its name; nothing, where that is of a device or a pipe.
    file: Option<(PathBuf, NamedTempFile)>,
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
            let Some((name, file)) = self.file else {
                return Ok(());
            };
            file.persist(&name).map_err(|error| error.error)?;
            sync_folder(folder_of(&name))
        };
        attempt().with_context(|| unwritable(&self.path))?;
        Ok(self.checksum)
    }
}

/// Its errors name the file.
impl Write for AtomicFile {
    fn write(&mut self, content: &[u8]) -> io::Result<usize> {
        let written = match &mut self.writer {
            Writer::File(_, file) => file.write(content),
            Writer::Stream(stream) => stream.write(content),
        };
        let written = written.map_err(|error| {
            io::Error::new(error.kind(), format!("{}: {error}", unwritable(&self.path)))
        })?;
        self.sum.write_all(&content[..written])?;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        // It reaches the disk when it is sealed.
        Ok(())
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

/// Opens what is to be a file, if it exists. A path that is no folder is found when the folder is
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

/// The new name itself must survive a power loss.
#[cfg(unix)]
fn sync_folder(folder: &Path) -> std::io::Result<()> {
    File::open(folder)?.sync_all()
}

#[cfg(not(unix))]
fn sync_folder(_: &Path) -> std::io::Result<()> {
    Ok(())
}
