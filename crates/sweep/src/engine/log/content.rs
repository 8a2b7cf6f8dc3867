//! What is in a log and where, found in one pass.

use std::fs::File;
use std::path::Path;

use rayon::prelude::*;

use super::about::parse_about;
use super::error::{LogError, file_error};
use super::header::{FirstLine, Header};
use super::line::Scan;
use super::record::parse_record;
use crate::engine::Record;

/// Cases whose records are put in order at once, in memory.
const CASES_PER_BLOCK: usize = 1 << 14;

/// Lines that all threads together parse at once.
const LINES_AT_ONCE: usize = 1 << 12;

/// What is in a log, without its records.
#[derive(Debug)]
pub(super) struct Content {
    cases: usize,
    methods: usize,
    /// End of the last whole line, bytes.
    end: u64,
    /// One bit for each case and method.
    done: Bits,
    count: usize,
    failed: usize,
    broken_lines: usize,
    /// What the run is shown by, as the last line about it says.
    about: Option<String>,
    /// For each block of cases, the bytes of the log between which its records are.
    blocks: Vec<Option<(u64, u64)>>,
}

impl Content {
    /// Reads a log of a sweep of so many cases and methods.
    ///
    /// # Errors
    /// Where it is no log or cannot be read.
    pub fn read(path: &Path, file: &File, cases: usize, methods: usize) -> Result<Self, LogError> {
        let unreadable = |error| file_error(path, "read", error);
        let mut content = Self {
            cases,
            methods,
            end: 0,
            done: Bits::new(cases * methods),
            count: 0,
            failed: 0,
            broken_lines: 0,
            about: None,
            blocks: vec![None; cases.div_ceil(CASES_PER_BLOCK)],
        };
        let mut scan = Scan::new(file).map_err(unreadable)?;
        match scan.next_line().map_err(unreadable)? {
            Some(line) if matches!(Header::parse(line.text), FirstLine::Header(_)) => {
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
                    None => content.broken_lines += 1,
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
    pub fn add(&mut self, record: &Record, from: u64, to: u64) {
        self.end = to;
        if !self.done.set(record.case * self.methods + record.method) {
            return;
        }
        self.count += 1;
        self.failed += usize::from(record.outcome.is_err());
        let block = &mut self.blocks[record.case / CASES_PER_BLOCK];
        let (start, end) = block.unwrap_or((from, to));
        *block = Some((start.min(from), end.max(to)));
    }

    /// Keeps what the run is shown by, whose line ends at this byte of the log.
    pub fn set_about(&mut self, about: String, to: u64) {
        self.end = to;
        self.about = Some(about);
    }

    /// What the run is shown by.
    pub fn about(&self) -> Option<&str> {
        self.about.as_deref()
    }

    /// End of the last whole line, bytes.
    pub fn end(&self) -> u64 {
        self.end
    }

    /// Which pairs of case and method are done, as of now.
    pub fn done(&self) -> impl Fn(usize, usize) -> bool + Sync + use<> {
        let (done, methods) = (self.done.clone(), self.methods);
        move |case, method| done.has(case * methods + method)
    }

    /// How many pairs are done.
    pub fn count(&self) -> usize {
        self.count
    }

    /// How many of them have no answer.
    pub fn failed(&self) -> usize {
        self.failed
    }

    /// Lines that do not match their checksum: a torn last one, or damage.
    pub fn broken_lines(&self) -> usize {
        self.broken_lines
    }

    /// Gives all records of the log to `each`, in the order of cases and methods: a
    /// block of whole cases at a time, so that no more is in memory.
    ///
    /// # Errors
    /// Where the log cannot be read, or what `each` returned.
    pub fn in_order(
        &self,
        path: &Path,
        file: &File,
        mut each: impl FnMut(&[Record]) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        let unreadable = |error| file_error(path, "read", error);
        for (block, range) in self.blocks.iter().enumerate() {
            let Some((from, to)) = *range else { continue };
            let is_of_block = |record: &Record| {
                record.case / CASES_PER_BLOCK == block && self.has_place_for(record)
            };
            let (mut lines, mut records) = (Vec::with_capacity(LINES_AT_ONCE), Vec::new());
            let mut scan = Scan::between(file, from, to).map_err(unreadable)?;
            loop {
                lines.clear();
                while lines.len() < LINES_AT_ONCE
                    && let Some(line) = scan.next_line().map_err(unreadable)?
                {
                    lines.push(line.text.to_vec());
                }
                if lines.is_empty() {
                    break;
                }
                let parsed = lines.par_iter().filter_map(|line| parse_record(line));
                records.par_extend(parsed.filter(is_of_block));
            }
            records.sort_by_key(|record| (record.case, record.method));
            records.dedup_by_key(|record| (record.case, record.method));
            each(&records)?;
        }
        Ok(())
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
