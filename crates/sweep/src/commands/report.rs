//! `sweep report` and `sweep summary`: what results folders say, as a page and in
//! the terminal.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use super::document::say_document;
use super::folder::{REPORT, hold, tables_of};
use super::outputs::{Output, refuse_to_lose};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use crate::cli::ReportArguments;
use crate::report::{Results, SummaryFound, compare, is_page, page, sections, text};
use campaign::text_file::unreadable;
use results::files::{folder_of, write_atomically};

/// Says in the terminal what a folder holds.
pub fn summary(folder: &Path, json: bool, terminal: Terminal) -> Result<Status> {
    let all = [read(folder, terminal)?];
    if json {
        say_document("summary", &SummaryFound::new(&all[0]))?;
        return Ok(Status::Complete);
    }
    say(&text(&title(&all), &sections(&all, &[])))?;
    Ok(Status::Complete)
}

/// Writes a page about one folder, or several side by side.
pub fn report(arguments: &ReportArguments, terminal: Terminal) -> Result<Status> {
    let mut all = (arguments.folders.iter())
        .map(|folder| read(folder, terminal))
        .collect::<Result<Vec<_>>>()?;
    let folders = all.len();
    for results in &mut all {
        results.analyse()?;
        results.draw(folders)?;
    }
    let comparisons = (all.iter().skip(1))
        .map(|other| compare(&all[0], other))
        .collect::<Result<Vec<_>>>()?;
    if let Some(path) = &arguments.out {
        refuse_to_lose(path, Output::Page, arguments.overwrite.force)?;
    }
    let html = page(&title(&all), &sections(&all, &comparisons), &all);
    let path = match (&arguments.out, &arguments.folders[..]) {
        (Some(path), _) => {
            write_atomically(path, html.as_bytes())?;
            path.clone()
        }
        // In the folder that it is about; here, where there are several.
        (None, [folder]) => write_page(folder.join(REPORT), &html, terminal)?,
        (None, _) => write_page(PathBuf::from(REPORT), &html, terminal)?,
    };
    say(&format!("{}\n", path.display()))?;
    Ok(Status::Complete)
}

fn read(folder: &Path, terminal: Terminal) -> Result<Results> {
    Results::read(folder, tables_of(folder, terminal)?)
}

/// Writes a page under its usual name, where nothing else has it.
fn write_page(path: PathBuf, html: &str, terminal: Terminal) -> Result<PathBuf> {
    let _lock = hold(folder_of(&path), REPORT, terminal)?;
    let is_ours = is_page(&path).with_context(|| unreadable(&path))?;
    if path.exists() && !is_ours {
        bail!(UsageError(format!(
            "{} is no page of this program: write another with --out, or move it away",
            path.display()
        )));
    }
    write_atomically(&path, html.as_bytes())?;
    Ok(path)
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
