//! Damaged results folders: readers are warned, and what can be restored is.

use std::path::Path;

use anyhow::Result;

use crate::commands::terminal::Terminal;
use results::folder::{Damage, Manifest, TABLES, damaged};

/// Refuses a folder that lacks what only a new run would bring.
///
/// # Errors
/// What is missing or damaged, and what to do.
pub fn refuse_lost(manifest: &Manifest, folder: &Path) -> Result<()> {
    let mut lost = manifest.damage(folder, &TABLES)?;
    lost.retain(|damage| !manifest.can_make_again(&damage.name));
    if lost.is_empty() {
        return Ok(());
    }
    Err(damaged(&lost, true))
}

/// Several files in one line.
pub fn in_words(damage: &[Damage]) -> String {
    let words: Vec<&str> = damage.iter().map(|damage| damage.words.as_str()).collect();
    words.join("; ")
}

/// Says that tables are taken as they are, where nothing is known of them.
pub fn tell_if_unverified(manifest: &Manifest, folder: &Path, terminal: Terminal) {
    if let Some(note) = manifest.unverified(folder) {
        terminal.complain(&format!("note: {note}"));
    }
}
