//! `sweep report` and `sweep summary`: what results folders say, as a page and in
//! the terminal.

use std::path::{Path, PathBuf};

use anyhow::Result;

use super::folder::{REPORT, tables_of};
use super::plot::draw_map;
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
    let tables = tables_of(folder)?;
    let is_drawn = tables.manifest.shard().is_whole() && tables.manifest.tally.rows > 0;
    if tables.so_far.is_some() && is_drawn {
        draw_map(&tables, tables.pictures())?;
    }
    Results::read(folder, tables)
}

/// In the folder that a report is about; here, where there are several.
fn place(folders: &[PathBuf]) -> PathBuf {
    match folders {
        [folder] => folder.join(REPORT),
        _ => PathBuf::from(REPORT),
    }
}

fn title(all: &[Results]) -> String {
    match all {
        [results] => {
            let so_far = results.tables.so_far;
            let so_far = so_far.map_or_else(String::new, |so_far| format!(" ({so_far})"));
            format!(
                "{}: {}{so_far}",
                results.manifest.name, results.manifest.title
            )
        }
        _ => format!("{} results folders side by side", all.len()),
    }
}
