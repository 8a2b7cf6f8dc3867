//! The log of a run: what is done, appended case by case, so that a run goes on
//! from where it was stopped, however it was.
//!
//! Each line is `checksum TAB …`, the checksum (CRC-32, eight hexadecimal digits)
//! being that of all that follows the first tab. The first line is the header; each
//! other is `case TAB method TAB reason TAB row`, the reason empty but for a case
//! without an answer, and the row as it will stand in `labels.csv`. A line that
//! was not written whole, or not as it was meant, does not match its checksum
//! and counts as not there.

use std::fs::{File, TryLockError};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::shard::Shard;

/// Version of this format.
const FORMAT: u32 = 1;

/// First word of a header.
const HEADER: &str = "sweep-log";

/// What is written reaches the disk at least this often. Less than this is lost
/// when the power goes; nothing when only the program goes.
const BETWEEN_SYNCS: Duration = Duration::from_secs(1);

/// Cases whose rows are put in order at once, in memory.
const CASES_PER_BLOCK: usize = 1 << 14;

/// A line longer than this is none of ours, bytes.
const LONGEST_LINE: u64 = 1 << 26;

/// What a log belongs to. Runs with another header do not go on from it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// Version of the format.
    format: u32,
    /// The program with its version.
    pub program: String,
    /// Which part of the sweep.
    pub shard: Shard,
    /// What the sweep means.
    pub meaning: serde_json::Value,
}

impl Header {
    /// The header of a run by this program.
    pub fn new(shard: Shard, meaning: serde_json::Value) -> Self {
        Self::of(crate::PROGRAM.to_owned(), shard, meaning)
    }

    /// The header of a run by any program.
    pub fn of(program: String, shard: Shard, meaning: serde_json::Value) -> Self {
        Self {
            format: FORMAT,
            program,
            shard,
            meaning,
        }
    }
}

/// A case done by one method.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Record {
    /// Number of the case.
    pub case: usize,
    /// The method's place in the sweep's list.
    pub method: usize,
    /// Why there is no answer.
    pub reason: Option<String>,
    /// The row of `labels.csv`.
    pub row: String,
}

/// A log that cannot be used.
#[derive(Debug, Error)]
pub enum LogError {
    /// Another run writes it.
    #[error("another run is writing {0}; wait for it, or choose another --out")]
    Locked(PathBuf),
    /// It has no header of this program.
    #[error("{0} is not a log of this program; replace it with --fresh")]
    NotALog(PathBuf),
    /// It cannot be read or written.
    #[error("{path} cannot be {what}: {error}")]
    File {
        /// The log.
        path: PathBuf,
        /// `read` or `written`.
        what: &'static str,
        /// What the system says.
        error: io::Error,
    },
}

/// An open log, locked for this run.
#[derive(Debug)]
pub struct Log {
    path: PathBuf,
    methods: usize,
    state: Mutex<State>,
}

#[derive(Debug)]
struct State {
    file: File,
    synced: Instant,
    content: Content,
}

/// What is in a log, up to the end of its last whole line.
#[derive(Debug)]
struct Content {
    end: u64,
    index: Index,
    broken_lines: usize,
}

impl Content {
    fn read(path: &Path, file: &File, cases: usize, methods: usize) -> Result<Self, LogError> {
        let unreadable = |error| file_error(path, "read", error);
        let mut content = Self {
            end: 0,
            index: Index::new(cases * methods, cases),
            broken_lines: 0,
        };
        let mut scan = Scan::new(file).map_err(unreadable)?;
        match scan.next_line().map_err(unreadable)? {
            Some(line) if parse_header(line.text).is_some() => content.end = line.to,
            // A header that was not written whole has nothing after it.
            Some(line) if !line.is_last => return Err(LogError::NotALog(path.to_owned())),
            _ => return Ok(content),
        }
        while let Some(line) = scan.next_line().map_err(unreadable)? {
            match parse_record(line.text) {
                Some(record) if record.case < cases && record.method < methods => {
                    let pair = record.case * methods + record.method;
                    let failed = record.reason.is_some();
                    content
                        .index
                        .add(pair, record.case, failed, line.from, line.to);
                    content.end = line.to;
                }
                _ => content.broken_lines += 1,
            }
        }
        Ok(content)
    }
}

/// What is in a log and where, without its rows.
#[derive(Debug, Default)]
struct Index {
    /// One bit for each case and method.
    done: Vec<u64>,
    count: usize,
    failed: usize,
    /// For each block of cases, the bytes of the log between which its rows are.
    blocks: Vec<Option<(u64, u64)>>,
}

impl Index {
    fn new(pairs: usize, cases: usize) -> Self {
        Self {
            done: vec![0; pairs.div_ceil(64)],
            blocks: vec![None; cases.div_ceil(CASES_PER_BLOCK)],
            ..Self::default()
        }
    }

    fn has(&self, pair: usize) -> bool {
        self.done[pair / 64] >> (pair % 64) & 1 == 1
    }

    fn add(&mut self, pair: usize, case: usize, failed: bool, from: u64, to: u64) {
        if self.has(pair) {
            return;
        }
        self.done[pair / 64] |= 1 << (pair % 64);
        self.count += 1;
        self.failed += usize::from(failed);
        let block = &mut self.blocks[case / CASES_PER_BLOCK];
        let (start, end) = block.unwrap_or((from, to));
        *block = Some((start.min(from), end.max(to)));
    }
}

/// Reads the header of a log, if there is a whole one.
///
/// # Errors
/// Where the file cannot be read.
pub fn read_header(path: &Path) -> Result<Option<Header>, LogError> {
    let read = || -> io::Result<Option<Header>> {
        let mut line = Vec::new();
        let mut reader = BufReader::new(File::open(path)?).take(LONGEST_LINE);
        reader.read_until(b'\n', &mut line)?;
        Ok(parse_header(&line))
    };
    match read() {
        // A folder that is none is found when it is to be made.
        Err(error)
            if matches!(
                error.kind(),
                io::ErrorKind::NotFound | io::ErrorKind::NotADirectory
            ) =>
        {
            Ok(None)
        }
        result => result.map_err(|error| file_error(path, "read", error)),
    }
}

/// How many pairs of case and method a log has, another run writing it or not.
///
/// # Errors
/// Where it cannot be read or is no log.
pub fn count_done(path: &Path, cases: usize, methods: usize) -> Result<usize, LogError> {
    let file = File::open(path).map_err(|error| file_error(path, "read", error))?;
    Ok(Content::read(path, &file, cases, methods)?.index.count)
}

impl Log {
    /// Opens a log, or begins one where there is none, or none whole, or it is to
    /// be `fresh`. The caller has compared headers; this is for a sweep of so many
    /// cases and methods.
    ///
    /// # Errors
    /// Where another run has it, it is no log, or it cannot be written.
    pub fn open(
        path: &Path,
        header: &Header,
        cases: usize,
        methods: usize,
        fresh: bool,
    ) -> Result<Self, LogError> {
        let unwritable = |error| file_error(path, "written", error);
        let file = File::options()
            .read(true)
            .append(true)
            .create(true)
            .open(path)
            .map_err(unwritable)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(LogError::Locked(path.to_owned())),
            // A file system without locks: nothing can be promised there.
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {}
            Err(TryLockError::Error(error)) => return Err(unwritable(error)),
        }
        if fresh {
            file.set_len(0).map_err(unwritable)?;
        }
        let content = Content::read(path, &file, cases, methods)?;
        // What follows the last whole line is the rest of a torn one.
        file.set_len(content.end).map_err(unwritable)?;
        let log = Self {
            path: path.to_owned(),
            methods,
            state: Mutex::new(State {
                file,
                synced: Instant::now(),
                content,
            }),
        };
        let mut state = log.state();
        if state.content.end == 0 {
            let json = serde_json::to_string(header)
                .map_err(|error| file_error(path, "written", error.into()))?;
            log.write(&mut state, &checked(&format!("{HEADER}\t{json}")))?;
            state.file.sync_all().map_err(unwritable)?;
        }
        drop(state);
        Ok(log)
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
        let done = self.state().content.index.done.clone();
        let methods = self.methods;
        move |case, method| {
            let pair = case * methods + method;
            done[pair / 64] >> (pair % 64) & 1 == 1
        }
    }

    /// How many pairs are done.
    pub fn count(&self) -> usize {
        self.state().content.index.count
    }

    /// How many of them have no answer.
    pub fn failed(&self) -> usize {
        self.state().content.index.failed
    }

    /// Lines that do not match their checksum: a torn last one, or damage.
    pub fn broken_lines(&self) -> usize {
        self.state().content.broken_lines
    }

    /// Adds a record. When this returns, it outlives the program; within a
    /// second, the machine.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn append(&self, record: &Record) -> Result<(), LogError> {
        let line = checked(&format!(
            "{}\t{}\t{}\t{}",
            record.case,
            record.method,
            one_line(record.reason.as_deref().unwrap_or_default()),
            record.row
        ));
        let mut state = self.state();
        let from = state.content.end;
        self.write(&mut state, &line)?;
        let (pair, to) = (
            record.case * self.methods + record.method,
            state.content.end,
        );
        state
            .content
            .index
            .add(pair, record.case, record.reason.is_some(), from, to);
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
        tell(state.content.index.count);
        // The program ends whether this succeeds or not.
        let _ = self.sync_state(&mut state);
        std::mem::forget(state);
    }

    fn sync_state(&self, state: &mut State) -> Result<(), LogError> {
        state.synced = Instant::now();
        (state.file.sync_data()).map_err(|error| file_error(&self.path, "written", error))
    }

    fn write(&self, state: &mut State, line: &str) -> Result<(), LogError> {
        // One call a line: a program that is killed has written it or has not.
        state.file.write_all(line.as_bytes()).map_err(|error| {
            // A part of a line would run into the next.
            let _ = state.file.set_len(state.content.end);
            file_error(&self.path, "written", error)
        })?;
        state.content.end += line.len() as u64;
        Ok(())
    }

    /// Gives every record to `each`, in the order of cases and methods; only a
    /// block of cases is in memory at a time.
    ///
    /// # Errors
    /// Where the log cannot be read, or what `each` returned.
    pub fn in_order(
        &self,
        mut each: impl FnMut(&Record) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        let state = self.state();
        let unreadable = |error| file_error(&self.path, "read", error);
        for (block, range) in state.content.index.blocks.iter().enumerate() {
            let Some((from, to)) = *range else { continue };
            let mut records: Vec<Record> = Vec::new();
            let mut scan = Scan::between(&state.file, from, to).map_err(unreadable)?;
            while let Some(line) = scan.next_line().map_err(unreadable)? {
                records.extend(
                    parse_record(line.text).filter(|record| record.case / CASES_PER_BLOCK == block),
                );
            }
            records.sort_by_key(|record| (record.case, record.method));
            records.dedup_by_key(|record| (record.case, record.method));
            records.iter().try_for_each(&mut each)?;
        }
        Ok(())
    }
}

fn file_error(path: &Path, what: &'static str, error: io::Error) -> LogError {
    LogError::File {
        path: path.to_owned(),
        what,
        error,
    }
}

/// A line with its checksum.
fn checked(text: &str) -> String {
    format!("{:08x}\t{text}\n", crc32fast::hash(text.as_bytes()))
}

/// Tabs and line breaks have a meaning here.
fn one_line(text: &str) -> String {
    text.replace(|letter: char| letter.is_control(), " ")
}

/// What a line says, if it is whole.
fn parse_line(line: &[u8]) -> Option<&str> {
    let line = std::str::from_utf8(line).ok()?.strip_suffix('\n')?;
    let (checksum, text) = line.split_once('\t')?;
    let digits = |byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f');
    let is_whole = checksum.len() == 8
        && checksum.bytes().all(digits)
        && u32::from_str_radix(checksum, 16) == Ok(crc32fast::hash(text.as_bytes()));
    is_whole.then_some(text)
}

fn parse_header(line: &[u8]) -> Option<Header> {
    let json = parse_line(line)?.strip_prefix(HEADER)?.strip_prefix('\t')?;
    serde_json::from_str(json).ok()
}

fn parse_record(line: &[u8]) -> Option<Record> {
    let mut fields = parse_line(line)?.splitn(4, '\t');
    let record = Record {
        case: fields.next()?.parse().ok()?,
        method: fields.next()?.parse().ok()?,
        reason: fields
            .next()
            .map(str::to_owned)
            .filter(|reason| !reason.is_empty()),
        row: fields.next()?.to_owned(),
    };
    Some(record)
}

/// Lines of a part of a file.
struct Scan<'a> {
    reader: io::Take<BufReader<&'a File>>,
    line: Vec<u8>,
    at: u64,
}

/// A line and its bytes of the file.
struct Line<'a> {
    text: &'a [u8],
    from: u64,
    to: u64,
    is_last: bool,
}

impl<'a> Scan<'a> {
    fn new(file: &'a File) -> io::Result<Self> {
        let length = file.metadata()?.len();
        Self::between(file, 0, length)
    }

    fn between(mut file: &'a File, from: u64, to: u64) -> io::Result<Self> {
        file.seek(SeekFrom::Start(from))?;
        Ok(Self {
            reader: BufReader::with_capacity(1 << 16, file).take(to - from),
            line: Vec::new(),
            at: from,
        })
    }

    fn next_line(&mut self) -> io::Result<Option<Line<'_>>> {
        self.line.clear();
        let from = self.at;
        let read = self
            .reader
            .by_ref()
            .take(LONGEST_LINE)
            .read_until(b'\n', &mut self.line)?;
        if read == 0 {
            return Ok(None);
        }
        self.at += read as u64;
        Ok(Some(Line {
            text: &self.line,
            from,
            to: self.at,
            is_last: self.reader.limit() == 0,
        }))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const CASES: usize = 40;
    const METHODS: usize = 2;

    fn record(pair: usize) -> Record {
        Record {
            case: pair / METHODS,
            method: pair % METHODS,
            reason: pair
                .is_multiple_of(7)
                .then(|| format!("because\tof {pair}\n")),
            row: format!("{},quadrature,0.5,ok", pair / METHODS),
        }
    }

    fn header() -> Header {
        Header::new(Shard::WHOLE, serde_json::json!({ "time_s": 1.0 }))
    }

    /// A log with records in an order of its own, and its bytes.
    fn written(folder: &Path) -> (PathBuf, Vec<u8>) {
        let path = folder.join("log");
        let log = Log::open(&path, &header(), CASES, METHODS, false).unwrap();
        for index in 0..CASES * METHODS {
            log.append(&record(index * 37 % (CASES * METHODS))).unwrap();
        }
        drop(log);
        let bytes = std::fs::read(&path).unwrap();
        (path, bytes)
    }

    #[test]
    fn what_was_appended_is_read_in_the_order_of_cases() {
        let folder = tempfile::tempdir().unwrap();
        let (path, _) = written(folder.path());
        assert_eq!(read_header(&path).unwrap(), Some(header()));
        let log = Log::open(&path, &header(), CASES, METHODS, false).unwrap();
        assert_eq!(log.count(), CASES * METHODS);
        assert_eq!(log.failed(), (CASES * METHODS).div_ceil(7));
        let mut pair = 0;
        log.in_order(|found| {
            let expected = record(pair);
            assert_eq!((found.case, found.method), (expected.case, expected.method));
            assert_eq!(found.row, expected.row);
            // Tabs and breaks of lines become spaces.
            assert_eq!(found.reason.is_some(), expected.reason.is_some());
            pair += 1;
            Ok(())
        })
        .unwrap();
        assert_eq!(pair, CASES * METHODS);
    }

    #[test]
    fn only_one_has_a_log_open() {
        let folder = tempfile::tempdir().unwrap();
        let (path, _) = written(folder.path());
        let _first = Log::open(&path, &header(), CASES, METHODS, false).unwrap();
        for fresh in [false, true] {
            let second = Log::open(&path, &header(), CASES, METHODS, fresh);
            assert!(matches!(second, Err(LogError::Locked(_))));
        }
    }

    /// What may happen to the bytes of a file.
    #[derive(Debug, Clone)]
    enum Damage {
        Change(usize, u8),
        Remove(usize, usize),
        Insert(usize, Vec<u8>),
        Repeat(usize, usize),
    }

    fn damage() -> impl Strategy<Value = Damage> {
        prop_oneof![
            (any::<usize>(), any::<u8>()).prop_map(|(at, byte)| Damage::Change(at, byte)),
            (any::<usize>(), 0..200usize).prop_map(|(at, count)| Damage::Remove(at, count)),
            (any::<usize>(), prop::collection::vec(any::<u8>(), 0..20))
                .prop_map(|(at, bytes)| Damage::Insert(at, bytes)),
            (any::<usize>(), 0..400usize).prop_map(|(at, count)| Damage::Repeat(at, count)),
        ]
    }

    fn apply(bytes: &mut Vec<u8>, damage: &Damage) {
        let place = |at: usize, bytes: &[u8]| at % bytes.len().max(1);
        match damage {
            Damage::Change(at, byte) => {
                let at = place(*at, bytes);
                if let Some(old) = bytes.get_mut(at) {
                    *old = *byte;
                }
            }
            Damage::Remove(at, count) => {
                let at = place(*at, bytes).min(bytes.len());
                bytes.drain(at..(at + count).min(bytes.len()));
            }
            Damage::Insert(at, new) => {
                let at = place(*at, bytes).min(bytes.len());
                bytes.splice(at..at, new.iter().copied());
            }
            Damage::Repeat(at, count) => {
                let at = place(*at, bytes).min(bytes.len());
                let again = bytes[at..(at + count).min(bytes.len())].to_vec();
                bytes.splice(at..at, again);
            }
        }
    }

    /// A hundred thousand damaged logs: never a panic, never a record that was
    /// not written, and never fewer of them than whole lines.
    #[test]
    fn a_damaged_log_gives_only_what_was_written() {
        let folder = tempfile::tempdir().unwrap();
        let (path, whole) = written(folder.path());
        let lines: std::collections::HashSet<&[u8]> =
            whole.split_inclusive(|&byte| byte == b'\n').collect();
        let config = ProptestConfig {
            cases: 100_000,
            failure_persistence: None,
            ..ProptestConfig::default()
        };
        let damages = prop::collection::vec(damage(), 0..6);
        proptest!(config, |(damages in damages)| {
            let mut bytes = whole.clone();
            for damage in &damages {
                apply(&mut bytes, damage);
            }
            std::fs::write(&path, &bytes).unwrap();
            let file = File::open(&path).unwrap();
            let has_header = read_header(&path).unwrap().is_some();
            match Content::read(&path, &file, CASES, METHODS) {
                Ok(content) => {
                    let records: std::collections::HashSet<(usize, usize)> = bytes
                        .split_inclusive(|&byte| byte == b'\n')
                        .filter(|line| lines.contains(line))
                        .filter_map(parse_record)
                        .map(|record| (record.case, record.method))
                        .collect();
                    let expected = if has_header { records.len() } else { 0 };
                    prop_assert_eq!(content.index.count, expected);
                    prop_assert!(content.end <= bytes.len() as u64);
                }
                Err(error) => prop_assert!(!has_header, "{}", error),
            }
        });
    }
}
