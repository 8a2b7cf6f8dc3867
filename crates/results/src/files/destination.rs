//! Where what is written goes: a file, the one that a link leads to, or a device or a pipe, which
//! stays what it is.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use super::regular::is_absent;

/// Most links that lead to one another.
const MOST_LINKS: usize = 40;

/// Where a name leads.
pub enum Destination {
    /// To a file, or to where one is to be.
    File(PathBuf),
    /// To what takes bytes and has no other end: a device, a pipe, an open file of the program.
    Stream(File),
}

/// Where a name leads.
///
/// # Errors
/// Where it is a folder, or a pipe without a reader.
pub fn destination(path: &Path) -> io::Result<Destination> {
    let kind = match fs::metadata(path) {
        Err(error) if is_absent(&error) => return end_of_links(path).map(Destination::File),
        Err(error) => return Err(error),
        Ok(there) => there.file_type(),
    };
    if kind.is_dir() {
        return Err(io::Error::other("it is a folder, not a file"));
    }
    let real = fs::canonicalize(path);
    match real {
        Ok(real) if kind.is_file() && !is_of_system(path) && !is_of_system(&real) => {
            Ok(Destination::File(real))
        }
        _ => open_stream(path, kind.is_file()).map(Destination::Stream),
    }
}

/// Whether a name is one of an open file or a device: `/dev/stdout` may lead to a file, which a new
/// one of its name would not be.
fn is_of_system(path: &Path) -> bool {
    cfg!(unix)
        && ["/dev", "/proc"]
            .iter()
            .any(|folder| path.starts_with(folder))
}

/// Where the last of the links that begin with a name leads, to nothing yet.
fn end_of_links(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(target) = fs::read_link(&path) else {
            return Ok(path);
        };
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        path = folder.join(target);
    }
    Err(io::Error::other("it is a link that leads in a circle"))
}

#[cfg(unix)]
fn open_stream(path: &Path, is_file: bool) -> io::Result<File> {
    use std::os::unix::fs::{FileTypeExt, OpenOptionsExt};
    let is_pipe = fs::metadata(path)?.file_type().is_fifo();
    // Opened otherwise, a pipe without a reader is waited for.
    let reader = is_pipe.then(|| {
        let options = &mut File::options();
        options.write(true).custom_flags(NOT_WAITING).open(path)
    });
    if let Some(Err(error)) = reader {
        let message = format!("it is a pipe without a reader: {error}");
        return Err(io::Error::other(message));
    }
    File::options().write(true).append(is_file).open(path)
}

/// `O_NONBLOCK`.
#[cfg(any(target_os = "linux", target_os = "android"))]
const NOT_WAITING: i32 = 0o4000;
#[cfg(all(unix, not(any(target_os = "linux", target_os = "android"))))]
const NOT_WAITING: i32 = 0x4;

#[cfg(not(unix))]
fn open_stream(path: &Path, is_file: bool) -> io::Result<File> {
    File::options().write(true).append(is_file).open(path)
}
