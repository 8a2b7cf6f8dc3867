//! The shards that are to be joined: all of one sweep, and whole.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};

use crate::commands::folder::{LOG, MANIFEST, header_of, in_words, tell_if_unverified};
use crate::commands::status::UsageError;
use crate::commands::terminal::Terminal;
use campaign::engine::Shard;
use campaign::words::{file_word, shell_word};
use results::folder::{Manifest, RECORDS, TABLES, differences};
use results::log::{Header, read_header};

/// A finished shard.
pub struct Part {
    /// Where it is.
    pub folder: PathBuf,
    /// What it says of itself.
    pub manifest: Manifest,
}

/// Refuses shards of which a table is not the one that was written.
///
/// # Errors
/// What is missing or damaged, and what to do.
pub fn refuse_damaged_parts(parts: &[Part], terminal: Terminal) -> Result<()> {
    let mut damage = Vec::new();
    let mut shards = Vec::new();
    let mut command = String::new();
    for Part { folder, manifest } in parts {
        tell_if_unverified(manifest, folder, terminal);
        // Shards of earlier versions have kept no records.
        let records = manifest.files.contains_key(RECORDS).then_some(RECORDS);
        let files: Vec<&str> = TABLES.into_iter().chain(records).collect();
        let found = manifest.damage(folder, &files)?;
        if let (false, Some(file)) = (found.is_empty(), &manifest.sweep_file) {
            let (file, folder) = (file.display().to_string(), folder.display().to_string());
            let (file, folder) = (file_word(&file), shell_word(&folder));
            let Shard { index, of } = manifest.shard();
            command = format!("`sweep run {file} --shard {index}/{of} --out {folder} --fresh`; ");
        }
        shards.extend((!found.is_empty()).then(|| manifest.shard().index.to_string()));
        damage.extend(found);
    }
    if damage.is_empty() {
        return Ok(());
    }
    bail!(
        "{}: put back copies, or {command}run these shards again with --fresh: {}",
        in_words(&damage),
        shards.join(",")
    )
}

/// The finished shards by number, and what is known of unfinished ones; all of
/// one sweep and program.
///
/// # Errors
/// Where they are not.
pub fn read_parts(folders: &[PathBuf]) -> Result<(BTreeMap<usize, Part>, Vec<Header>)> {
    let mut parts: BTreeMap<usize, Part> = BTreeMap::new();
    let mut unfinished = Vec::new();
    let mut first: Option<(PathBuf, Header)> = None;
    for folder in folders {
        let log = read_header(&folder.join(LOG))?;
        let is_finished = log.is_none() && folder.join(MANIFEST).exists();
        let header = if is_finished {
            let manifest = Manifest::read(folder)?;
            let header = header_of(&manifest)?;
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
    let unlike = if expected.fingerprint != found.fingerprint {
        let all = differences(&expected.fingerprint, &found.fingerprint);
        format!("of different sweeps ({})", all.join("; "))
    } else if expected.shard.of != found.shard.of {
        let (expected, found) = (expected.shard, found.shard);
        format!("of different divisions, shard {expected} and shard {found}")
    } else if expected.program != found.program {
        let (expected, found) = (&expected.program, &found.program);
        format!("by different programs, {expected} and {found}")
    } else {
        return Ok(());
    };
    let (one, other) = (one.display(), other.display());
    bail!(UsageError(format!("{one} and {other} are {unlike}")))
}
