//! Only one command at a time writes into a folder.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use fs4::{FileExt, TryLockError};
use thiserror::Error;

use super::regular::refuse_irregular;

/// The file that is locked, there as long as a command writes; a command that is
/// killed leaves it behind, without the lock.
pub(super) const NAME: &str = ".sweep-lock";

/// A folder that is kept from other commands.
#[derive(Debug)]
pub struct FolderLock {
    #[cfg(unix)]
    path: PathBuf,
    /// The lock goes with it.
    _file: File,
    unsupported: Option<io::Error>,
}

/// A folder that cannot be locked.
#[derive(Debug, Error)]
pub enum LockError {
    /// Another command writes there.
    #[error("another command is writing there")]
    Taken,
    /// The folder cannot be written.
    #[error(transparent)]
    File(#[from] io::Error),
}

impl FolderLock {
    /// Locks a folder, or says why not at once. A file system that knows no locks
    /// is no error; see [`FolderLock::unsupported`].
    ///
    /// # Errors
    /// Where another command has it, or it cannot be written.
    pub fn take(folder: &Path) -> Result<Self, LockError> {
        let path = folder.join(NAME);
        loop {
            refuse_irregular(&path)?;
            let file = File::options()
                .write(true)
                .create(true)
                .truncate(false)
                .open(&path)?;
            let unsupported = match FileExt::try_lock(&file) {
                Ok(()) => None,
                Err(TryLockError::WouldBlock) => return Err(LockError::Taken),
                Err(TryLockError::Error(error)) => Some(error),
            };
            // Its last holder may have removed it after it was opened here.
            if is_at(&file, &path)? {
                return Ok(Self {
                    #[cfg(unix)]
                    path,
                    _file: file,
                    unsupported,
                });
            }
        }
    }

    /// Why nothing is locked, where the file system knows no locks.
    pub fn unsupported(&self) -> Option<&io::Error> {
        self.unsupported.as_ref()
    }
}

#[cfg(unix)]
impl Drop for FolderLock {
    /// Removed while it is locked: who opens the name from now on makes a new
    /// file, who has this one open finds that it has no name.
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.path);
    }
}

/// Whether an open file has this name.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt;
    let ours = file.metadata()?;
    match std::fs::symlink_metadata(path) {
        Ok(there) => Ok((ours.dev(), ours.ino()) == (there.dev(), there.ino())),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}

/// The file stays where it is.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> io::Result<bool> {
    Ok(true)
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;

    #[test]
    fn a_folder_is_locked_until_the_lock_goes() {
        let folder = tempfile::tempdir().unwrap();
        let first = FolderLock::take(folder.path()).unwrap();
        let second = FolderLock::take(folder.path());
        assert!(matches!(second, Err(LockError::Taken)));
        drop(first);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
        // As a killed command leaves it.
        File::create(folder.path().join(NAME)).unwrap();
        drop(FolderLock::take(folder.path()).unwrap());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    /// The file comes and goes with each lock, which must not let two in.
    #[test]
    fn threads_that_lock_again_and_again_are_never_in_together() {
        let folder = tempfile::tempdir().unwrap();
        let (inside, taken) = (AtomicUsize::new(0), AtomicUsize::new(0));
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    while taken.load(Ordering::SeqCst) < 400 {
                        let Ok(_lock) = FolderLock::take(folder.path()) else {
                            continue;
                        };
                        assert_eq!(inside.fetch_add(1, Ordering::SeqCst), 0);
                        taken.fetch_add(1, Ordering::SeqCst);
                        std::thread::yield_now();
                        inside.fetch_sub(1, Ordering::SeqCst);
                    }
                });
            }
        });
    }
}
