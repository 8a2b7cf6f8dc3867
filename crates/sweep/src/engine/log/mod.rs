//! The log of a run: what is done, appended case by case, so that a run goes on
//! from where it was stopped, however it was.
//!
//! Each line is `checksum TAB …`, the checksum (CRC-32, eight hexadecimal digits)
//! being that of all that follows the first tab. The first line is the header; each
//! other is the JSON of a record, a case done by one method; or says after
//! `sweep-run TAB` what an unfinished run is shown by. A line that was not written
//! whole, or not as it was meant, does not match its checksum and counts as not
//! there. The file itself appears with its whole header: one without is none of this
//! program's, and is left alone.

mod about;
mod content;
mod error;
mod header;
mod line;
mod record;
#[cfg(test)]
mod tests;
mod view;

pub use about::read_about;
pub use error::LogError;
pub use header::{Header, Place, log_place, read_header};
pub use record::record_line;
pub use view::LogView;

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use about::about_line;
use content::Content;
use error::file_error;

use crate::engine::Record;
use crate::files::{refuse_irregular, write_atomically};

/// What is written reaches the disk at least this often. Less than this is lost
/// when the power goes; nothing when only the program goes.
const BETWEEN_SYNCS: Duration = Duration::from_secs(1);

/// An open log. The folder is locked for whoever writes it.
#[derive(Debug)]
pub struct Log {
    path: PathBuf,
    state: Mutex<State>,
}

#[derive(Debug)]
struct State {
    file: File,
    synced: Instant,
    content: Content,
}

impl Log {
    /// Begins a log, in place of what is there. A log is there with its whole header
    /// or not at all, so that one without is none of this program.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn begin(path: &Path, header: &Header) -> anyhow::Result<()> {
        write_atomically(path, header.line()?.as_bytes())
    }

    /// Opens a log to go on with it. The caller has compared headers; this is for a
    /// sweep of so many cases and methods.
    ///
    /// # Errors
    /// Where it is no log, or cannot be written.
    pub fn open(path: &Path, cases: usize, methods: usize) -> Result<Self, LogError> {
        let unwritable = |error| file_error(path, "written", error);
        refuse_irregular(path).map_err(unwritable)?;
        let file = (File::options().read(true).append(true).open(path)).map_err(unwritable)?;
        let content = Content::read(path, &file, cases, methods)?;
        // What follows the last whole line is the rest of a torn one.
        file.set_len(content.end()).map_err(unwritable)?;
        Ok(Self {
            path: path.to_owned(),
            state: Mutex::new(State {
                file,
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

    /// How many pairs are done.
    pub fn count(&self) -> usize {
        self.state().content.count()
    }

    /// How many of them have no answer.
    pub fn failed(&self) -> usize {
        self.state().content.failed()
    }

    /// Lines that do not match their checksum: a torn last one, or damage.
    pub fn broken_lines(&self) -> usize {
        self.state().content.broken_lines()
    }

    /// Says, in a line of text, what the run is shown by as long as it is not finished,
    /// where the log does not say so already.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn describe(&self, about: String) -> Result<(), LogError> {
        let mut state = self.state();
        if state.content.about() != Some(about.as_str()) {
            let to = self.write(&mut state, &about_line(&about))?;
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
        let line =
            record_line(record).map_err(|error| file_error(&self.path, "written", error.into()))?;
        let mut state = self.state();
        let from = state.content.end();
        let to = self.write(&mut state, &line)?;
        state.content.add(record, from, to);
        if state.synced.elapsed() >= BETWEEN_SYNCS {
            self.sync_state(&mut state)?;
        }
        Ok(())
    }

    /// Puts what is written on the disk.
    ///
    /// # Errors
    /// Where that fails.
    pub fn sync(&self) -> Result<(), LogError> {
        self.sync_state(&mut self.state())
    }

    /// For the end of the program while cases are under way: nothing is added any
    /// more, `tell` hears how many pairs are done, and they are put on the disk.
    pub fn close(&self, tell: impl FnOnce(usize)) {
        let mut state = self.state();
        tell(state.content.count());
        // The program ends whether this succeeds or not.
        let _ = self.sync_state(&mut state);
        std::mem::forget(state);
    }

    fn sync_state(&self, state: &mut State) -> Result<(), LogError> {
        state.synced = Instant::now();
        (state.file.sync_data()).map_err(|error| file_error(&self.path, "written", error))
    }

    /// Writes a line at the end; where the log then ends.
    fn write(&self, state: &mut State, line: &str) -> Result<u64, LogError> {
        // One call a line: a program that is killed has written it, or torn it at the end
        // of a page, or has not.
        state.file.write_all(line.as_bytes()).map_err(|error| {
            // A part of a line would run into the next.
            let _ = state.file.set_len(state.content.end());
            file_error(&self.path, "written", error)
        })?;
        Ok(state.content.end() + line.len() as u64)
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
        let state = self.state();
        state.content.in_order(&self.path, &state.file, each)
    }
}
