//! What is no file, though it has a file's name.

use std::fs;
use std::io;
use std::path::Path;

/// Refuses what is neither a file nor nothing: a link would lead elsewhere, a
/// device or a pipe would not end.
///
/// # Errors
/// What it is instead.
pub fn refuse_irregular(path: &Path) -> io::Result<()> {
    let what = match fs::symlink_metadata(path) {
        Err(error) if is_absent(&error) => return Ok(()),
        Err(error) => return Err(error),
        Ok(there) if there.is_file() => return Ok(()),
        Ok(there) if there.is_symlink() => "a symbolic link",
        Ok(there) if there.is_dir() => "a folder",
        Ok(_) => "a device or a pipe",
    };
    Err(io::Error::other(format!("it is {what}, not a file")))
}

/// Whether an error says that no file has this name, also because its folder is no folder.
pub fn is_absent(error: &io::Error) -> bool {
    use io::ErrorKind::{NotADirectory, NotFound};
    matches!(error.kind(), NotFound | NotADirectory)
}
