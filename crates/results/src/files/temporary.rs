//! Files that are being written, under a name that tells them from all others;
//! and what killed programs left of them.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use fs4::FileExt;
use tempfile::{Builder, NamedTempFile};

use super::lock;

/// How names of files that are being written begin.
const PREFIX: &str = ".tmp-sweep-";

/// A new file in a folder. It is locked as long as it is written: that tells it
/// from one whose writer was killed.
pub(super) fn temporary(folder: &Path) -> io::Result<NamedTempFile> {
    loop {
        let file = readable(Builder::new().prefix(PREFIX)).tempfile_in(folder)?;
        // Where locks are not supported, no other run removes it either.
        let _ = FileExt::lock(file.as_file());
        // Between these two, it may have looked as if it had no writer.
        if file.path().exists() {
            return Ok(file);
        }
    }
}

/// A temporary file is private; a result is for whom the mask of new files lets.
#[cfg(unix)]
fn readable<'a, 'b>(file: &'a mut Builder<'b, 'b>) -> &'a mut Builder<'b, 'b> {
    use std::os::unix::fs::PermissionsExt;
    file.permissions(fs::Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn readable<'a, 'b>(file: &'a mut Builder<'b, 'b>) -> &'a mut Builder<'b, 'b> {
    file
}

/// Whether commands are at work in a folder, or were killed there.
///
/// # Errors
/// Where the folder cannot be read.
pub fn has_left(folder: &Path) -> io::Result<bool> {
    Ok(folder.join(lock::NAME).exists() || !temporaries(folder)?.is_empty())
}

/// Files in a folder that this program began, and has not finished yet or never
/// will.
fn temporaries(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let is_one = entry.file_name().to_string_lossy().starts_with(PREFIX);
        if is_one && entry.file_type()?.is_file() {
            found.push(entry.path());
        }
    }
    Ok(found)
}

/// Removes what killed programs left half written in a folder.
///
/// # Errors
/// Where the folder cannot be read.
pub fn remove_left(folder: &Path) -> io::Result<()> {
    for path in temporaries(folder)? {
        // Files of other users stay, and do no harm.
        let Ok(file) = File::options().write(true).open(&path) else {
            continue;
        };
        if FileExt::try_lock(&file).is_ok() {
            let _ = fs::remove_file(&path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_whose_writer_is_gone_are_removed() {
        let folder = tempfile::tempdir().unwrap();
        let written = temporary(folder.path()).unwrap();
        let (left, path) = temporary(folder.path()).unwrap().keep().unwrap();
        let foreign = folder.path().join(".tmpAbCdEf");
        fs::write(&foreign, "").unwrap();
        remove_left(folder.path()).unwrap();
        assert_eq!(temporaries(folder.path()).unwrap().len(), 2);
        // What the system does for a writer that is killed.
        drop(left);
        remove_left(folder.path()).unwrap();
        assert_eq!(temporaries(folder.path()).unwrap(), [written.path()]);
        assert!(!path.exists() && foreign.exists());
    }
}
