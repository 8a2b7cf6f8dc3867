//! The log of a run: what is done, appended case by case, so that a run continues from where it was
//! stopped, in any way.
//!
//! Each line is `checksum TAB …`, the checksum (CRC-32, eight hexadecimal digits)
//! being that of all that follows the first tab. The first line is the header; each
//! other is the JSON of a record, a case done by one method; or says after
//! `sweep-run TAB` what an unfinished run is shown by. A line that was not written
//! whole, or not as it was meant, does not match its checksum and counts as not
//! there. The file itself appears with its whole header: a file without one is foreign, and is left
//! alone.
//!
//! ```
//! use campaign::engine::Shard;
//! use campaign::records::{Failure, Record};
//! use results::log::{Header, Log, read_header};
//!
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("cases.log");
//! let header = Header::new("example 1.0".to_owned(), Shard::WHOLE, "what is run".into());
//! Log::begin(&path, &header)?;
//! Log::open(&path, 10, 1)?.append(&Record::failed(3, 0, vec![60.0], Failure::new("too long")))?;
//! // A run that continues finds what is done.
//! assert_eq!(read_header(&path)?, Some(header));
//! let log = Log::open(&path, 10, 1)?;
//! let is_done = log.done();
//! assert!(is_done(3, 0) && !is_done(4, 0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod about;
mod content;
mod error;
mod header;
mod line;
#[cfg(test)]
mod tests;

pub use about::read_about;
pub use content::LogView;
pub use error::LogError;
pub use header::{Header, Place, log_place, read_header};
pub use line::{checked, record_line};

use std::fs::File;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use about::about_line;
use content::LogCounts;
use error::file_error;

use crate::files::{refuse_irregular, write_atomically};
use campaign::records::Record;

/// What is written reaches the disk at least this often. Less than this is lost
/// when the power goes; nothing when only the program goes.
const BETWEEN_SYNCS: Duration = Duration::from_secs(1);

/// An open log. The folder is locked for the writing process.
#[derive(Debug)]
pub struct Log {
    state: Mutex<State>,
}

#[derive(Debug)]
struct State {
    synced: Instant,
    content: LogView,
}

impl Log {
    /// Begins a log, in place of what is there. A log exists with its whole header or not at all,
    /// so a file without one is foreign.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn begin(path: &Path, header: &Header) -> anyhow::Result<()> {
        write_atomically(path, header.line()?.as_bytes())
    }

    /// Opens a log to continue it. The caller has compared headers; this is for a sweep with these
    /// numbers of cases and methods.
    ///
    /// # Errors
    /// Where it is no log, or cannot be written.
    pub fn open(path: &Path, cases: usize, methods: usize) -> Result<Self, LogError> {
        let unwritable = |error| file_error(path, "written", error);
        refuse_irregular(path).map_err(unwritable)?;
        let file = (File::options().read(true).append(true).open(path)).map_err(unwritable)?;
        let content = LogView::read(path, file, cases, methods)?;
        // What follows the last whole line is the rest of a torn one.
        content.file.set_len(content.end).map_err(unwritable)?;
        Ok(Self {
            state: Mutex::new(State {
                synced: Instant::now(),
                content,
            }),
        })
    }

    fn state(&self) -> std::sync::MutexGuard<'_, State> {
        // A thread that panicked while it held the state left it whole or the
        // file one line short, which the next run sees.
        self.state
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// Which pairs of case and method (case × methods + method) are done, as of
    /// now.
    pub fn done(&self) -> impl Fn(usize, usize) -> bool + Sync + use<> {
        self.state().content.done()
    }

    /// How much it holds by now.
    pub fn counts(&self) -> LogCounts {
        self.state().content.counts
    }

    /// Says, in a line of text, what the run is shown by as long as it is not finished,
    /// where the log does not say so already.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn describe(&self, about: String) -> Result<(), LogError> {
        let mut state = self.state();
        if state.content.about.as_deref() != Some(&about) {
            let to = state.write(&about_line(&about))?;
            state.content.set_about(about, to);
        }
        Ok(())
    }

    /// Adds a record. When this returns, it outlives the program; within a
    /// second, the machine.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn append(&self, record: &Record) -> Result<(), LogError> {
        let line = record_line(record);
        let mut state = self.state();
        let line = line.map_err(|error| state.unwritable(error.into()))?;
        let from = state.content.end;
        let to = state.write(&line)?;
        state.content.add(record, from, to);
        if state.synced.elapsed() >= BETWEEN_SYNCS {
            state.sync()?;
        }
        Ok(())
    }

    /// Puts what is written on the disk.
    ///
    /// # Errors
    /// Where that fails, or other programs have taken records away.
    pub fn sync(&self) -> Result<(), LogError> {
        self.state().sync()
    }

    /// Pairs that are done and in the file; none where other programs have changed that.
    pub fn kept(&self) -> Option<usize> {
        let content = &self.state().content;
        content.is_whole().then_some(content.counts.done)
    }

    /// For the end of the program while cases are under way: nothing is added any
    /// more, all is put on the disk, and `tell` hears how many pairs are kept.
    pub fn close(&self, tell: impl FnOnce(Option<usize>)) {
        let mut state = self.state();
        let kept = state.sync().ok().map(|()| state.content.counts.done);
        // The program ends.
        tell(kept);
        std::mem::forget(state);
    }

    /// Gives all records to `each`, in the order of cases and methods: a block of whole
    /// cases at a time, so that no more is in memory.
    ///
    /// # Errors
    /// Where the log cannot be read, or what `each` returned.
    pub fn in_order(
        &self,
        each: impl FnMut(&[Record]) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        self.state().content.in_order(each)
    }
}

impl State {
    fn unwritable(&self, error: io::Error) -> LogError {
        file_error(&self.content.path, "written", error)
    }

    fn sync(&mut self) -> Result<(), LogError> {
        self.synced = Instant::now();
        let synced = self.content.file.sync_data();
        synced.map_err(|error| self.unwritable(error))?;
        match self.content.is_whole() {
            true => Ok(()),
            false => Err(LogError::Changed(self.content.path.clone())),
        }
    }

    /// Writes a line at the end; where the log then ends.
    fn write(&mut self, line: &str) -> Result<u64, LogError> {
        // One call a line: a program that is killed has written it, or torn it at the end
        // of a page, or has not.
        let written = self.content.file.write_all(line.as_bytes());
        written.map_err(|error| {
            // A part of a line would run into the next.
            let _ = self.content.file.set_len(self.content.end);
            self.unwritable(error)
        })?;
        Ok(self.content.end + line.len() as u64)
    }
}
