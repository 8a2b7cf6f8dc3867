//! `sweep merge`: the shards of a sweep into one results folder.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufRead, BufReader, Lines};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};

use super::folder::{LOG, MANIFEST, Ours, hold, in_words, tell_if_unverified};
use super::plot::draw_and_note;
use super::run::{status_of, summary};
use super::{Status, UsageError, complain, make_folder, say};
use crate::cli::MergeArguments;
use crate::engine::{Header, Place, Shard, read_header};
use crate::files::{AtomicFile, SealedFile};
use crate::output::{
    FAILURES_HEADER, LabelColumns, Manifest, PICTURES, TABLES, Tally, differences,
};

/// A finished shard.
struct Part {
    folder: PathBuf,
    manifest: Manifest,
}

/// Joins shards.
pub fn merge(arguments: &MergeArguments) -> Result<Status> {
    let (parts, unfinished) = read_parts(&arguments.folders)?;
    let known = parts.values().map(|part| part.manifest.shard().of);
    let Some(of) = known
        .chain(unfinished.iter().map(|header| header.shard.of))
        .next()
    else {
        bail!(UsageError(
            "none of these folders holds a shard of a sweep".to_owned()
        ));
    };
    let missing: Vec<String> = (0..of)
        .filter(|index| !parts.contains_key(index))
        .map(|index| index.to_string())
        .collect();
    if !missing.is_empty() {
        complain(&format!(
            "incomplete: {} of {of} shards are finished\nrun again: {}",
            of - missing.len(),
            missing.join(",")
        ));
        return Ok(Status::Incomplete);
    }
    let parts: Vec<Part> = parts.into_values().collect();
    refuse_damaged_parts(&parts)?;
    let out = &arguments.out;
    make_folder(out)?;
    let _lock = hold(out, "labels.csv")?;
    refuse_unrelated(out, &parts)?;
    let (labels, tally) = join_labels(&parts, out)?;
    let tables = [
        ("labels.csv", labels),
        ("failures.csv", join_failures(&parts, out)?),
        ("boundary.csv", copy_boundary(&parts, out)?),
    ];
    let mut manifest = parts[0].manifest.clone();
    manifest.shard = None;
    manifest.tally = tally;
    manifest.wall_seconds = parts.iter().map(|part| part.manifest.wall_seconds).sum();
    let sums = (tables.iter()).map(|(name, table)| ((*name).to_owned(), table.checksum().clone()));
    manifest.files = sums.collect();
    // Before the tables: from here on, they are known to be of a merge, should it be
    // killed.
    manifest.write(out)?;
    for (_, table) in tables {
        table.publish()?;
    }
    let drawn = draw_and_note(out, &mut manifest)?;
    say(&summary(&manifest, out, drawn)?)?;
    Ok(status_of(&manifest))
}

/// Refuses shards of which a table is not the one that was written.
fn refuse_damaged_parts(parts: &[Part]) -> Result<()> {
    let mut damage = Vec::new();
    let mut shards = Vec::new();
    for Part { folder, manifest } in parts {
        tell_if_unverified(manifest, folder);
        let found = manifest.damage(folder, &TABLES)?;
        shards.extend((!found.is_empty()).then(|| manifest.shard().index.to_string()));
        damage.extend(found);
    }
    if damage.is_empty() {
        return Ok(());
    }
    bail!(
        "{}: put back copies, or run these shards again with --fresh: {}",
        in_words(&damage),
        shards.join(",")
    )
}

/// The finished shards by number, and what is known of unfinished ones; all of
/// one sweep and program.
fn read_parts(folders: &[PathBuf]) -> Result<(BTreeMap<usize, Part>, Vec<Header>)> {
    let mut parts: BTreeMap<usize, Part> = BTreeMap::new();
    let mut unfinished = Vec::new();
    let mut first: Option<(PathBuf, Header)> = None;
    for folder in folders {
        let log = read_header(&folder.join(LOG))?;
        let is_finished = log.is_none() && folder.join("manifest.json").exists();
        let header = if is_finished {
            let manifest = Manifest::read(folder)?;
            let header = Header::of(
                manifest.program.clone(),
                manifest.shard(),
                manifest.fingerprint()?,
            );
            let part = Part {
                folder: folder.clone(),
                manifest,
            };
            if let Some(twice) = parts.insert(header.shard.index, part) {
                bail!(UsageError(format!(
                    "shard {} is there twice: {} and {}",
                    header.shard,
                    twice.folder.display(),
                    folder.display()
                )));
            }
            header
        } else if let Some(header) = log {
            unfinished.push(header.clone());
            header
        } else {
            continue;
        };
        match &first {
            Some((other, expected)) => refuse_unlike(other, expected, folder, &header)?,
            None => first = Some((folder.clone(), header)),
        }
    }
    Ok((parts, unfinished))
}

fn refuse_unlike(one: &Path, expected: &Header, other: &Path, found: &Header) -> Result<()> {
    let refuse = |what: String| {
        bail!(UsageError(format!(
            "{} and {} are {what}",
            one.display(),
            other.display()
        )))
    };
    if expected.fingerprint != found.fingerprint {
        let all = differences(&expected.fingerprint, &found.fingerprint);
        return refuse(format!("of different sweeps ({})", all.join("; ")));
    }
    if expected.shard.of != found.shard.of {
        return refuse(format!(
            "of different divisions, shard {} and shard {}",
            expected.shard, found.shard
        ));
    }
    if expected.program != found.program {
        return refuse(format!(
            "by different programs, {} and {}",
            expected.program, found.program
        ));
    }
    Ok(())
}

/// The results of something else are not replaced, nor is a run that goes on.
fn refuse_unrelated(out: &Path, parts: &[Part]) -> Result<()> {
    let merged = &parts[0].manifest;
    let header = Header::of(merged.program.clone(), Shard::WHOLE, merged.fingerprint()?);
    let ours = Ours::find(out, &header)?;
    if ours.log != Place::Free {
        bail!(UsageError(format!(
            "{} holds a stopped run ({LOG}): finish it by the same `sweep run` as before, or choose \
             another --out",
            out.display()
        )));
    }
    if out.join(MANIFEST).exists() {
        let there = Manifest::read(out)?;
        if there.fingerprint()? != header.fingerprint || !there.shard().is_whole() {
            bail!(UsageError(format!(
                "{} holds other results: choose another --out",
                out.display()
            )));
        }
    }
    let pictures = if merged.map.is_some() {
        &PICTURES[..]
    } else {
        &[]
    };
    ours.refuse_foreign(out, &[&TABLES, pictures].concat())
}

/// Lines of a table, the header taken off, with the case of the next one.
struct Table {
    lines: Lines<BufReader<File>>,
    next: Option<(usize, String)>,
    path: PathBuf,
}

impl Table {
    /// Opens a table and gives its header.
    fn open(path: PathBuf) -> Result<(String, Self)> {
        let unreadable = || format!("{} cannot be read", path.display());
        let mut lines = BufReader::new(File::open(&path).with_context(unreadable)?).lines();
        let header = lines
            .next()
            .transpose()
            .with_context(unreadable)?
            .unwrap_or_default();
        let mut table = Self {
            lines,
            next: None,
            path,
        };
        table.advance()?;
        Ok((header, table))
    }

    fn advance(&mut self) -> Result<Option<String>> {
        let unreadable = || format!("{} cannot be read", self.path.display());
        let line = self.lines.next().transpose().with_context(unreadable)?;
        let next = line
            .map(|line| {
                let case = line.split(',').next().and_then(|case| case.parse().ok());
                let case = case.with_context(|| {
                    format!("{}: `{line}` has no case number", self.path.display())
                })?;
                anyhow::Ok((case, line))
            })
            .transpose()?;
        Ok(std::mem::replace(&mut self.next, next).map(|(_, line)| line))
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
    let columns = LabelColumns::find(headers[0].split(','), &[])
        .map_err(|reason| anyhow!("the shards' labels.csv {reason}"))?;
    file.write(format!("{}\n", headers[0]).as_bytes())?;
    while let Some(table) = (tables.iter_mut())
        .filter(|table| table.next.is_some())
        .min_by_key(|table| table.next.as_ref().map(|(case, _)| *case))
    {
        if let Some(line) = table.advance()? {
            let fields: Vec<&str> = line.split(',').collect();
            let row = columns.row(tally.rows, |column| fields.get(column).copied());
            let row =
                row.map_err(|reason| anyhow!("{}: `{line}`: {reason}", table.path.display()))?;
            tally.add(&row.method, row.failed, row.labels, row.predicted);
            file.write(format!("{line}\n").as_bytes())?;
        }
    }
    let expected: usize = parts.iter().map(|part| part.manifest.tally.rows).sum();
    if tally.rows != expected {
        bail!(
            "the shards hold {} rows, but were to hold {expected}",
            tally.rows
        );
    }
    Ok((file.seal()?, tally))
}

/// Failures are few: all at once.
fn join_failures(parts: &[Part], out: &Path) -> Result<SealedFile> {
    let mut records: Vec<csv::StringRecord> = Vec::new();
    for part in parts {
        let path = part.folder.join("failures.csv");
        let unreadable = || format!("{} cannot be read", path.display());
        let mut reader = csv::Reader::from_path(&path).with_context(unreadable)?;
        for record in reader.records() {
            records.push(record.with_context(unreadable)?);
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
    let content =
        std::fs::read(&path).with_context(|| format!("{} cannot be read", path.display()))?;
    seal(&out.join("boundary.csv"), &content)
}

fn seal(path: &Path, content: &[u8]) -> Result<SealedFile> {
    let mut file = AtomicFile::create(path)?;
    file.write(content)?;
    file.seal()
}
