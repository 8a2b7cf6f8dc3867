//! Files that a command writes where the user asks: never over what it did not write.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use anyhow::{Result, bail};

use super::status::UsageError;
use crate::report::is_page;

/// What a command writes, by which it knows what it has written before.
#[derive(Debug, Clone, Copy)]
pub enum Output<'a> {
    /// A page for a browser.
    Page,
    /// What begins with one of these.
    Beginning(&'a [&'a [u8]]),
}

/// Refuses to write over what the command has not written, unless forced. Devices and pipes are
/// written to.
///
/// # Errors
/// Where something else has the name.
pub fn refuse_to_lose(path: &Path, output: Output, force: bool) -> Result<()> {
    if force || !path.is_file() || is_empty(path) {
        return Ok(());
    }
    let is_ours = match output {
        Output::Page => is_page(path)?,
        Output::Beginning(beginnings) => begins_with(path, beginnings)?,
    };
    if !is_ours {
        bail!(UsageError(format!(
            "{} is there already, and this command did not write it: give another name, or --force \
             to write over it",
            path.display()
        )));
    }
    Ok(())
}

fn is_empty(path: &Path) -> bool {
    path.metadata().is_ok_and(|it| it.len() == 0)
}

fn begins_with(path: &Path, beginnings: &[&[u8]]) -> std::io::Result<bool> {
    let longest = beginnings.iter().map(|it| it.len()).max().unwrap_or(0);
    let mut start = Vec::new();
    File::open(path)?
        .take(longest as u64)
        .read_to_end(&mut start)?;
    let mut beginnings = beginnings.iter();
    Ok(beginnings.any(|beginning| start.starts_with(beginning)))
}
