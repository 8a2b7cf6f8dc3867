//! By which a file is known to be the one that was written.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::Path;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// Bytes of a file that are in memory while it is read.
const PIECE: usize = 1 << 16;

/// Length and hash of a file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Checksum {
    /// Length, bytes.
    pub bytes: u64,
    /// SHA-256, hexadecimal.
    pub sha256: String,
}

impl Checksum {
    /// Of a file that is there, however large.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub fn of_file(path: &Path) -> io::Result<Self> {
        let mut file = BufReader::with_capacity(PIECE, File::open(path)?);
        let mut sum = Summing::default();
        io::copy(&mut file, &mut sum)?;
        Ok(sum.finish())
    }
}

/// The checksum of a file while it is written.
#[derive(Debug, Default)]
pub struct Summing {
    bytes: u64,
    hash: Sha256,
}

impl Write for Summing {
    fn write(&mut self, content: &[u8]) -> io::Result<usize> {
        self.bytes += content.len() as u64;
        self.hash.update(content);
        Ok(content.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Summing {
    /// The checksum of all that was added.
    pub fn finish(self) -> Checksum {
        Checksum {
            bytes: self.bytes,
            sha256: hexadecimal(self.hash),
        }
    }
}

/// A hash in writing.
pub fn hexadecimal(hash: Sha256) -> String {
    let bytes = hash.finalize();
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
