//! What is in a log and where, found in one pass.

use std::fs::File;
use std::path::{Path, PathBuf};

use linear::parallel;

use super::about::parse_about;
use super::error::{LogError, file_error};
use super::header::{Header, Place};
use super::line::{Scan, parse_record};
use campaign::records::Record;

/// Cases whose records are put in order at once, in memory.
const CASES_PER_BLOCK: usize = 1 << 14;

/// Lines that all threads together parse at once, and their bytes, but for the last.
const LINES_AT_ONCE: usize = 1 << 12;
const BYTES_AT_ONCE: usize = 1 << 24;

/// How much a log holds.
#[derive(Debug, Clone, Copy, Default)]
pub struct LogCounts {
    /// Pairs of case and method that are done.
    pub done: usize,
    /// How many of them have no answer.
    pub failed: usize,
    /// Lines that do not match their checksum: a torn last one, or damage.
    pub broken_lines: usize,
}

/// What is in a log that is open, without its records. Unless it is written by
/// [`super::Log`], it is not locked, and stays as it was when it was opened.
#[derive(Debug)]
pub struct LogView {
    /// How much it holds.
    pub counts: LogCounts,
    pub(super) path: PathBuf,
    pub(super) file: File,
    /// End of the last whole line, bytes.
    pub(super) end: u64,
    /// What the run is shown by, as the last line about it says.
    pub(super) about: Option<String>,
    cases: usize,
    methods: usize,
    /// One bit for each case and method.
    done: Bits,
    /// For each block of cases, the bytes of the log between which its records are.
    blocks: Vec<Option<(u64, u64)>>,
}

impl LogView {
    /// Reads the log of a sweep with these numbers of cases and methods.
    ///
    /// # Errors
    /// Where it is no log or cannot be read.
    pub fn open(path: &Path, cases: usize, methods: usize) -> Result<Self, LogError> {
        let file = File::open(path).map_err(|error| file_error(path, "read", error))?;
        Self::read(path, file, cases, methods)
    }

    /// The same of a file that is open.
    pub(super) fn read(
        path: &Path,
        file: File,
        cases: usize,
        methods: usize,
    ) -> Result<Self, LogError> {
        let unreadable = |error| file_error(path, "read", error);
        let reader = file.try_clone().map_err(unreadable)?;
        let mut content = Self {
            counts: LogCounts::default(),
            path: path.to_owned(),
            file,
            end: 0,
            about: None,
            cases,
            methods,
            done: Bits::new(cases * methods),
            blocks: vec![None; cases.div_ceil(CASES_PER_BLOCK)],
        };
        let mut scan = Scan::new(&reader).map_err(unreadable)?;
        match scan.next_line().map_err(unreadable)? {
            Some(line) if matches!(Header::parse(line.text), Some(Place::Log(_))) => {
                content.end = line.to;
            }
            _ => return Err(LogError::NotALog(path.to_owned())),
        }
        while let Some(line) = scan.next_line().map_err(unreadable)? {
            match parse_record(line.text) {
                Some(record) if content.has_place_for(&record) => {
                    content.add(&record, line.from, line.to);
                }
                _ => match parse_about(line.text) {
                    Some(about) => content.set_about(about, line.to),
                    None => content.counts.broken_lines += 1,
                },
            }
        }
        Ok(content)
    }

    /// Whether a record may be of this sweep.
    fn has_place_for(&self, record: &Record) -> bool {
        record.case < self.cases && record.method < self.methods
    }

    /// Counts a record whose line is between these bytes of the log.
    pub(super) fn add(&mut self, record: &Record, from: u64, to: u64) {
        self.end = to;
        if !self.done.set(record.case * self.methods + record.method) {
            return;
        }
        self.counts.done += 1;
        self.counts.failed += usize::from(record.outcome.is_err());
        let block = &mut self.blocks[record.case / CASES_PER_BLOCK];
        let (start, end) = block.unwrap_or((from, to));
        *block = Some((start.min(from), end.max(to)));
    }

    /// Keeps what the run is shown by, whose line ends at this byte of the log.
    pub(super) fn set_about(&mut self, about: String, to: u64) {
        self.end = to;
        self.about = Some(about);
    }

    /// Which pairs of case and method are done, as of now.
    pub(super) fn done(&self) -> impl Fn(usize, usize) -> bool + Sync + use<> {
        let (done, methods) = (self.done.clone(), self.methods);
        move |case, method| done.has(case * methods + method)
    }

    /// Gives all records of the log to `each`, in the order of cases and methods: a
    /// block of whole cases at a time, so that no more is in memory.
    ///
    /// # Errors
    /// Where the log cannot be read or has lost records since it was opened, or what `each` returned.
    pub fn in_order(
        &self,
        mut each: impl FnMut(&[Record]) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        let unreadable = |error| file_error(&self.path, "read", error);
        let mut given = 0;
        for (block, range) in self.blocks.iter().enumerate() {
            let Some((from, to)) = *range else { continue };
            let is_of_block = |record: &Record| {
                record.case / CASES_PER_BLOCK == block && self.has_place_for(record)
            };
            let (mut lines, mut records) = (Vec::with_capacity(LINES_AT_ONCE), Vec::new());
            let mut scan = Scan::between(&self.file, from, to).map_err(unreadable)?;
            loop {
                lines.clear();
                let mut bytes = 0;
                while lines.len() < LINES_AT_ONCE && bytes < BYTES_AT_ONCE {
                    let Some(line) = scan.next_line().map_err(unreadable)? else {
                        break;
                    };
                    bytes += line.text.len();
                    lines.push(line.text.to_vec());
                }
                if lines.is_empty() {
                    break;
                }
                let parsed = parallel::map(lines.len(), 1, |line| parse_record(&lines[line]));
                records.extend(parsed.into_iter().flatten().filter(is_of_block));
            }
            records.sort_by_key(|record| (record.case, record.method));
            records.dedup_by_key(|record| (record.case, record.method));
            given += records.len();
            each(&records)?;
        }
        if given != self.counts.done {
            return Err(LogError::Changed(self.path.clone()).into());
        }
        Ok(())
    }

    /// Whether the file still has its name and every line that was read or written.
    pub(super) fn is_whole(&self) -> bool {
        let [named, open] = [std::fs::metadata(&self.path), self.file.metadata()];
        let lengths = [named, open].map(|found| found.map_or(0, |found| found.len()));
        lengths.iter().all(|length| *length >= self.end)
    }
}

/// A set of numbers below a bound.
#[derive(Debug, Clone)]
struct Bits(Vec<u64>);

impl Bits {
    fn new(bound: usize) -> Self {
        Self(vec![0; bound.div_ceil(64)])
    }

    fn has(&self, number: usize) -> bool {
        self.0[number / 64] >> (number % 64) & 1 == 1
    }

    /// Adds a number; whether it was not there.
    fn set(&mut self, number: usize) -> bool {
        let is_new = !self.has(number);
        self.0[number / 64] |= 1 << (number % 64);
        is_new
    }
}
