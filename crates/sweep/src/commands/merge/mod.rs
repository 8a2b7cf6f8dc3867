//! `sweep merge`: the shards of a sweep into one results folder.

mod parts;
mod tables;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};

use super::drawing::{Drawing, draw_and_note};
use super::folder::{LOG, MANIFEST, OwnedFiles, hold, make_folder, remove_page};
use super::outcome::{status_of, summary};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use campaign::dependence::together;
use campaign::engine::Shard;
use campaign::words::file_word;
use parts::{Part, read_parts, refuse_damaged_parts};
use results::folder::Manifest;
use results::log::{Header, Place};
use tables::join_tables;

/// The most ranges of numbers in which missing shards are reported.
const MOST_RANGES: usize = 100;

/// Joins shards.
pub fn merge(folders: &[PathBuf], out: &Path, terminal: Terminal) -> Result<Status> {
    let (parts, unfinished) = read_parts(folders)?;
    let of = division(&parts, &unfinished)?;
    if parts.len() < of {
        let first = (0..of).find(|index| !parts.contains_key(index));
        let any = parts.values().next().map(|part| &part.manifest);
        let command = any
            .zip(first)
            .and_then(|(manifest, first)| again(manifest, first));
        let command = command.map_or_else(String::new, |command| format!(": `{command}`"));
        let missing = missing(parts.keys().copied(), of);
        terminal.complain(&format!(
            "incomplete: {} of {of} shards are finished{command}\nrun again: {missing}",
            parts.len(),
        ));
        return Ok(Status::Incomplete);
    }
    let parts: Vec<Part> = parts.into_values().collect();
    refuse_damaged_parts(&parts, terminal)?;
    make_folder(out)?;
    let _lock = hold(out, "labels.csv", terminal)?;
    refuse_unrelated(out, &parts)?;
    let mut manifest = join(&parts, out)?;
    let drawn = draw_and_note(out, &mut manifest, &Drawing::default())?;
    say(&summary(&manifest, out, drawn)?)?;
    Ok(status_of(&manifest))
}

/// The command that runs a shard.
fn again(manifest: &Manifest, index: usize) -> Option<String> {
    let file = manifest.sweep_file.as_ref()?.display().to_string();
    let of = manifest.shard().of;
    Some(format!(
        "sweep run {} --shard {index}/{of}",
        file_word(&file)
    ))
}

/// Into how many shards the sweep was divided.
fn division(parts: &BTreeMap<usize, Part>, unfinished: &[Header]) -> Result<usize> {
    let finished = parts.values().map(|part| part.manifest.shard().of);
    let mut known = finished.chain(unfinished.iter().map(|header| header.shard.of));
    let none = || UsageError("none of these folders holds a shard of a sweep".to_owned());
    Ok(known.next().ok_or_else(none)?)
}

/// The shards that are not among those finished, which are in order, as a scheduler takes
/// numbers and ranges; only the first ranges, for there may be millions.
fn missing(finished: impl Iterator<Item = usize>, of: usize) -> String {
    let mut next = 0;
    let ranges = finished.chain([of]).filter_map(|index| {
        let (first, last) = (next, index.checked_sub(1));
        next = index.saturating_add(1);
        let last = last.filter(|&last| first <= last)?;
        Some(if first == last {
            first.to_string()
        } else {
            format!("{first}-{last}")
        })
    });
    let mut ranges: Vec<String> = ranges.take(MOST_RANGES + 1).collect();
    if ranges.len() > MOST_RANGES {
        ranges[MOST_RANGES] = " and more, reported after these".to_owned();
    }
    ranges.join(",")
}

/// Puts the tables of shards together, with a manifest of them all.
fn join(parts: &[Part], out: &Path) -> Result<Manifest> {
    let (tables, tally) = join_tables(parts, out)?;
    let mut manifest = parts[0].manifest.clone();
    manifest.shard = None;
    manifest.tally = tally;
    manifest.depends_on = together(parts.iter().map(|part| part.manifest.depends_on.as_slice()));
    manifest.wall_seconds = parts.iter().map(|part| part.manifest.wall_seconds).sum();
    let sums = (tables.iter()).map(|(name, table)| ((*name).to_owned(), table.checksum().clone()));
    manifest.files = sums.collect();
    // Before the tables: from here on, they are known to be of a merge, should it be
    // killed.
    manifest.write(out)?;
    remove_page(out)?;
    for (_, table) in tables {
        table.publish()?;
    }
    Ok(manifest)
}

/// Foreign results are not replaced, nor is an unfinished run.
fn refuse_unrelated(out: &Path, parts: &[Part]) -> Result<()> {
    let merged = &parts[0].manifest;
    let header = Header::new(merged.program.clone(), Shard::WHOLE, merged.fingerprint()?);
    let owned = OwnedFiles::find(out, &header)?;
    if owned.log != Place::Free {
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
    owned.refuse_foreign(out, merged.map.is_some(), false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn missing_shards_are_reported_in_ranges_and_only_the_first_of_very_many() {
        let ranges_of = |finished: &[usize], of| missing(finished.iter().copied(), of);
        assert_eq!(ranges_of(&[0, 2, 5], 9), "1,3-4,6-8");
        assert_eq!(ranges_of(&[1, 2], 4), "0,3");
        assert_eq!(ranges_of(&[0], usize::MAX), format!("1-{}", usize::MAX - 1));
        let every_other: Vec<usize> = (0..1000).map(|index| 2 * index).collect();
        let text = ranges_of(&every_other, 2000);
        assert!(text.starts_with("1,3,5,") && text.len() < 500, "{text}");
        assert!(
            text.ends_with(",199, and more, reported after these"),
            "{text}"
        );
    }
}
