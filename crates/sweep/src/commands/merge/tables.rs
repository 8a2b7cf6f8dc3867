//! The tables of shards, joined.

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::iter::Peekable;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use serde::Deserialize;

use super::parts::Part;
use campaign::text_file::unreadable;
use results::files::{AtomicFile, SealedFile};
use results::folder::{FAILURES_HEADER, LabelColumns, RECORDS, RecordWriter, Tally, read_records};

/// Joins the tables of shards, for a folder: by name, on the disk, without their names
/// yet; and what is in them.
///
/// # Errors
/// Where they do not fit together, or a file cannot be read or written.
pub fn join_tables(parts: &[Part], out: &Path) -> Result<(Vec<(&'static str, SealedFile)>, Tally)> {
    let (labels, tally) = join_labels(parts, out)?;
    let mut tables = vec![
        ("labels.csv", labels),
        ("failures.csv", join_failures(parts, out)?),
        ("boundary.csv", copy_boundary(parts, out)?),
    ];
    tables.extend(join_records(parts, out)?.map(|records| (RECORDS, records)));
    Ok((tables, tally))
}

/// A row with the number of its case.
type Row = (usize, String);

/// Rows of a table, the header taken off.
struct Table {
    path: PathBuf,
    rows: Peekable<Box<dyn Iterator<Item = Result<Row>>>>,
}

impl Table {
    /// Opens a table and gives its header.
    fn open(path: PathBuf) -> Result<(String, Self)> {
        let cannot_be_read = unreadable(&path);
        let file = File::open(&path).with_context(|| cannot_be_read.clone())?;
        let mut lines = BufReader::new(file).lines();
        let header = lines
            .next()
            .transpose()
            .with_context(|| cannot_be_read.clone())?;
        let name = path.display().to_string();
        let rows = lines.map(move |line| {
            let line = line.with_context(|| cannot_be_read.clone())?;
            let case = line.split(',').next().and_then(|case| case.parse().ok());
            let case = case.with_context(|| format!("{name}: `{line}` has no case number"))?;
            Ok((case, line))
        });
        let rows: Box<dyn Iterator<Item = _>> = Box::new(rows);
        let rows = rows.peekable();
        Ok((header.unwrap_or_default(), Self { path, rows }))
    }

    /// Opens the records of a shard.
    fn of_records(folder: &Path) -> Result<Self> {
        #[derive(Deserialize)]
        struct OfCase {
            case: usize,
        }
        let path = folder.join(RECORDS);
        let name = path.display().to_string();
        let rows = read_records(folder)?.map(move |line| {
            let line = line?;
            let of_case: OfCase =
                serde_json::from_str(&line).with_context(|| format!("{name} is damaged"))?;
            Ok((of_case.case, line))
        });
        let rows: Box<dyn Iterator<Item = _>> = Box::new(rows);
        let rows = rows.peekable();
        Ok(Self { path, rows })
    }

    /// The case of the next row; a mistake comes before any.
    fn next_case(&mut self) -> Option<usize> {
        let next = self.rows.peek()?;
        Some(next.as_ref().map_or(0, |(case, _)| *case))
    }
}

/// The rows of all shards in the order of their cases; each case is in one
/// shard, which has its rows in order.
fn join_labels(parts: &[Part], out: &Path) -> Result<(SealedFile, Tally)> {
    let mut file = AtomicFile::create(&out.join("labels.csv"))?;
    let mut tally = Tally::default();
    let opened = parts
        .iter()
        .map(|part| Table::open(part.folder.join("labels.csv")));
    let (headers, mut tables): (Vec<String>, Vec<Table>) =
        opened.collect::<Result<Vec<_>>>()?.into_iter().unzip();
    if headers.iter().any(|header| *header != headers[0]) {
        bail!("the shards' labels.csv have different columns");
    }
    let columns = LabelColumns::find(headers[0].split(','), &[], &[])
        .map_err(|reason| anyhow!("the shards' labels.csv {reason}"))?;
    file.write(format!("{}\n", headers[0]).as_bytes())?;
    while let Some((path, line)) = next_row(&mut tables)? {
        let fields: Vec<&str> = line.split(',').collect();
        let row = columns.row(tally.rows, |column| fields.get(column).copied());
        let row = row.map_err(|reason| anyhow!("{}: `{line}`: {reason}", path.display()))?;
        tally.add(
            &row.method,
            row.failed,
            row.labels,
            row.predicted,
            row.certainty,
        );
        tally.add_margin(&row.method, row.labels, row.stick_slip_margin);
        tally.add_motor(&row.method, row.motor_stalled, row.labels);
        if let Some(push) = row.wall_push {
            tally.add_push(&row.method, push);
        }
        if let Some(found) = row.found {
            tally.add_found(&row.method, found);
        }
        file.write(format!("{line}\n").as_bytes())?;
    }
    let of_parts = parts
        .iter()
        .map(|part| &part.manifest.tally.fastest_whirl_turns_per_s);
    for (method, rate) in of_parts.flatten() {
        tally.add_whirl(method, *rate);
    }
    let whole = &parts[0].manifest;
    let expected = whole.cases * whole.methods.len();
    if tally.rows != expected {
        bail!(
            "the shards hold {} rows, but were to hold {expected}",
            tally.rows
        );
    }
    tally.fading = parts.iter().map(|part| part.manifest.tally.fading).sum();
    Ok((file.seal()?, tally))
}

/// The records of all shards in the order of their cases; none where a shard has kept none.
///
/// # Errors
/// Where they cannot be read or written.
fn join_records(parts: &[Part], out: &Path) -> Result<Option<SealedFile>> {
    if !parts
        .iter()
        .all(|part| part.manifest.files.contains_key(RECORDS))
    {
        return Ok(None);
    }
    let opened = parts.iter().map(|part| Table::of_records(&part.folder));
    let mut tables = opened.collect::<Result<Vec<_>>>()?;
    let mut records = RecordWriter::create(out)?;
    while let Some((_, line)) = next_row(&mut tables)? {
        records.write(&format!("{line}\n"))?;
    }
    records.seal().map(Some)
}

/// The next row of some tables in the order of their cases.
fn next_row(tables: &mut [Table]) -> Result<Option<(PathBuf, String)>> {
    let first = (tables.iter_mut())
        .filter_map(|table| Some((table.next_case()?, table)))
        .min_by_key(|(case, _)| *case);
    let Some((_, table)) = first else {
        return Ok(None);
    };
    let row = table.rows.next().transpose()?;
    Ok(row.map(|(_, line)| (table.path.clone(), line)))
}

/// Failures are few: all at once.
fn join_failures(parts: &[Part], out: &Path) -> Result<SealedFile> {
    let mut records: Vec<csv::StringRecord> = Vec::new();
    for part in parts {
        let path = part.folder.join("failures.csv");
        let mut reader = csv::Reader::from_path(&path).with_context(|| unreadable(&path))?;
        for record in reader.records() {
            records.push(record.with_context(|| unreadable(&path))?);
        }
    }
    // Stable: the methods of a case stay in order.
    records.sort_by_key(|record| record.get(0).and_then(|case| case.parse::<usize>().ok()));
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(FAILURES_HEADER.split(','))?;
    for record in &records {
        writer.write_record(record)?;
    }
    seal(&out.join("failures.csv"), &writer.into_inner()?)
}

/// Every shard has the limit of the whole sweep.
fn copy_boundary(parts: &[Part], out: &Path) -> Result<SealedFile> {
    let path = parts[0].folder.join("boundary.csv");
    let content = std::fs::read(&path).with_context(|| unreadable(&path))?;
    seal(&out.join("boundary.csv"), &content)
}

fn seal(path: &Path, content: &[u8]) -> Result<SealedFile> {
    let mut file = AtomicFile::create(path)?;
    file.write(content)?;
    file.seal()
}
