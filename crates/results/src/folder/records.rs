//! The records of a finished run: what its log held, compressed, in the order of its cases. A run
//! with more cases begins with them.

use std::fs::File;
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Write};
use std::path::Path;

use anyhow::{Context, Result};
use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;

use crate::files::{AtomicFile, SealedFile};
use campaign::text_file::unreadable;

/// The file of a results folder: the JSON of a record a line.
pub const RECORDS: &str = "records.jsonl.gz";

/// What is compressed at once, bytes: how lines are handed over must not show in the file.
const BLOCK: usize = 1 << 16;

/// Records being written. The same records give the same bytes.
pub struct RecordWriter {
    encoder: GzEncoder<AtomicFile>,
    /// Less than a block.
    pending: Vec<u8>,
}

impl RecordWriter {
    /// A file without a record, in a folder.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn create(folder: &Path) -> Result<Self> {
        let file = AtomicFile::create(&folder.join(RECORDS))?;
        Ok(Self {
            encoder: GzEncoder::new(file, Compression::fast()),
            pending: Vec::with_capacity(BLOCK),
        })
    }

    /// Adds lines, each the JSON of a record.
    ///
    /// # Errors
    /// Where they cannot be written.
    pub fn write(&mut self, lines: &str) -> Result<()> {
        self.pending.extend_from_slice(lines.as_bytes());
        let whole = self.pending.len() / BLOCK * BLOCK;
        for block in self.pending[..whole].chunks_exact(BLOCK) {
            self.encoder.write_all(block)?;
        }
        self.pending.drain(..whole);
        Ok(())
    }

    /// Puts it on the disk, without its name yet.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn seal(mut self) -> Result<SealedFile> {
        self.encoder.write_all(&self.pending)?;
        self.encoder.finish()?.seal()
    }
}

/// A longer line is no record, bytes: a compressed file of some megabytes may hold one of gigabytes.
const LONGEST_RECORD: u64 = 1 << 22;

/// The lines of the records of a folder; only a few are in memory at a time.
///
/// # Errors
/// Where they cannot be read.
pub fn read_records(folder: &Path) -> Result<impl Iterator<Item = Result<String>> + use<>> {
    let path = folder.join(RECORDS);
    let cannot_be_read = unreadable(&path);
    let file = File::open(&path).with_context(|| cannot_be_read.clone())?;
    let mut reader = BufReader::new(GzDecoder::new(BufReader::new(file)));
    let mut number = 0;
    let mut next_line = move || -> io::Result<Option<String>> {
        let mut line = String::new();
        number += 1;
        reader.by_ref().take(LONGEST_RECORD).read_line(&mut line)?;
        if line.len() as u64 == LONGEST_RECORD {
            let message = format!("line {number} is longer than any record");
            return Err(io::Error::new(ErrorKind::InvalidData, message));
        }
        let ends = line.is_empty();
        line.truncate(line.trim_end_matches('\n').len());
        Ok((!ends).then_some(line))
    };
    let lines = std::iter::from_fn(move || next_line().transpose()).fuse();
    Ok(lines.map(move |line| line.with_context(|| cannot_be_read.clone())))
}
