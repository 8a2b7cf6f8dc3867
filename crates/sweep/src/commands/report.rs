//! `sweep report` and `sweep summary`: what results folders say, as a page and in
//! the terminal.

use std::path::{Path, PathBuf};

use anyhow::Result;

use super::folder::refuse_unfinished;
use super::{Status, say};
use crate::cli::{ReportArguments, SummaryArguments};
use crate::output::write_atomically;
use crate::report::{Comparison, Results, page, sections, text};

/// Says in the terminal what a folder holds.
pub fn summary(arguments: &SummaryArguments) -> Result<Status> {
    let all = [read(&arguments.folder)?];
    say(&text(&title(&all), &sections(&all, &[])))?;
    Ok(Status::Complete)
}

/// Writes a page about one folder, or several side by side.
pub fn report(arguments: &ReportArguments) -> Result<Status> {
    let all = (arguments.folders.iter())
        .map(|folder| read(folder))
        .collect::<Result<Vec<_>>>()?;
    let comparisons = (all.iter().skip(1))
        .map(|other| Comparison::of(&all[0], other))
        .collect::<Result<Vec<_>>>()?;
    let html = page(&title(&all), &sections(&all, &comparisons))?;
    let path = arguments
        .out
        .clone()
        .unwrap_or_else(|| place(&arguments.folders));
    write_atomically(&path, html.as_bytes())?;
    say(&format!("{}\n", path.display()))?;
    Ok(Status::Complete)
}

fn read(folder: &Path) -> Result<Results> {
    refuse_unfinished(folder)?;
    Results::read(folder)
}

/// In the folder that a report is about; here, where there are several.
fn place(folders: &[PathBuf]) -> PathBuf {
    const NAME: &str = "report.html";
    match folders {
        [folder] => folder.join(NAME),
        _ => PathBuf::from(NAME),
    }
}

fn title(all: &[Results]) -> String {
    match all {
        [results] => format!("{}: {}", results.manifest.name, results.manifest.title),
        _ => format!("{} results folders side by side", all.len()),
    }
}
