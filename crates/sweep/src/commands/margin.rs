//! The line of a reference that says how far its cases are from where their labels change.

use std::path::Path;

use anyhow::{Context, Result};

use campaign::text_file::{LARGEST_TABLE, read_text, unreadable};

const MARGIN: &str = "# margin: ";

/// The line that states a margin.
pub fn margin_line(margin: &str) -> String {
    format!("{MARGIN}{margin}\n")
}

/// The margin that a reference states, if it does.
///
/// # Errors
/// Where the file cannot be read.
pub fn margin_of(reference: &Path) -> Result<Option<String>> {
    let text = read_text(reference, LARGEST_TABLE).with_context(|| unreadable(reference))?;
    let stated = text.lines().find_map(|line| line.strip_prefix(MARGIN));
    Ok(stated.map(|margin| margin.trim().to_owned()))
}
