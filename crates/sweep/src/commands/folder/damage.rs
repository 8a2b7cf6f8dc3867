//! Damaged results folders: readers are warned, and what can be restored is.

use std::path::Path;

use anyhow::{Result, bail};

use crate::commands::terminal::Terminal;
use results::folder::{Damage, Manifest, PICTURES, TABLES};

/// Refuses a folder whose tables are not those that were written, for who would
/// read them.
///
/// # Errors
/// What is missing or damaged, and what to do.
pub fn refuse_damaged(manifest: &Manifest, folder: &Path, terminal: Terminal) -> Result<()> {
    tell_if_unverified(manifest, folder, terminal);
    let damage = manifest.damage(folder, &TABLES)?;
    if damage.is_empty() {
        return Ok(());
    }
    let is_lost = (damage.iter()).any(|damage| !can_be_made_again(manifest, &damage.name));
    bail!("{}: {}", in_words(&damage), remedy(is_lost))
}

/// Refuses a folder that lacks what only a new run would bring.
///
/// # Errors
/// What is missing or damaged, and what to do.
pub fn refuse_lost(manifest: &Manifest, folder: &Path) -> Result<()> {
    let mut lost = manifest.damage(folder, &TABLES)?;
    lost.retain(|damage| !can_be_made_again(manifest, &damage.name));
    if !lost.is_empty() {
        bail!("{}: {}", in_words(&lost), remedy(true));
    }
    Ok(())
}

/// Whether a file follows from the sweep and the labels: the limit, the map, and the
/// list of failures where there is none.
fn can_be_made_again(manifest: &Manifest, name: &str) -> bool {
    match name {
        "failures.csv" => manifest.tally.failed == 0,
        _ => name == "boundary.csv" || PICTURES.contains(&name),
    }
}

fn remedy(is_lost: bool) -> &'static str {
    if is_lost {
        "put back a copy, or begin anew with --fresh"
    } else {
        "the same `sweep run` as before makes it again"
    }
}

/// Several files in one line.
pub fn in_words(damage: &[Damage]) -> String {
    let words: Vec<&str> = damage.iter().map(|damage| damage.words.as_str()).collect();
    words.join("; ")
}

/// Says that tables are taken as they are, where nothing is known of them.
pub fn tell_if_unverified(manifest: &Manifest, folder: &Path, terminal: Terminal) {
    if !manifest.has_checksums() {
        terminal.complain(&format!(
            "note: {} was written by {}, which kept no checksums: its tables are not verified",
            folder.display(),
            manifest.program
        ));
    }
}
