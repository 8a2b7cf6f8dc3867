//! `sweep window`: where, over weight on bit and surface speed, no limit is near, and the best
//! point there.

mod found;
mod tables;
mod words;

use std::path::PathBuf;

use anyhow::Result;

use super::document::say_document;
use super::drawing::save_picture;
use super::folder::{make_folder, results_folder, tables_of};
use super::input::read_text;
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use crate::cli::WindowArguments;
use crate::map::{WindowView, window_picture};
use campaign::plan::Sweep;
use found::WindowFound;
use results::files::write_atomically;
use results::folder::ResultTables;
use results::window::{OperatingWindow, WindowAsked, WindowError};

/// Draws the window, and says what came out.
pub fn window(arguments: &WindowArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.jobs, terminal)?;
    let sweep = Sweep::read_from(&arguments.file, &[], &read_text)?;
    let own = results_folder(None, &sweep);
    let folders = match &arguments.folders[..] {
        [] => vec![own],
        folders => folders.to_vec(),
    };
    let mut all = Vec::with_capacity(folders.len());
    for folder in folders {
        let tables = tables_of(&folder, terminal)?;
        all.push((folder, tables));
    }
    let asked = WindowAsked {
        orders: arguments.orders.clone(),
        held_at: arguments.held_at.clone(),
        margin: arguments.margin,
        risk: arguments.risk,
        bins: usize::from(arguments.bins),
        accept_chatter: arguments.accept_chatter,
    };
    let found = OperatingWindow::of(&sweep, &all, &asked).map_err(in_words)?;
    let OperatingWindow {
        chart,
        not_examined,
        how_often_wrong,
    } = found;
    if arguments.accept_chatter && sweep.setting.cutting.is_none() {
        let message = "--accept-chatter: no bit of this sweep cuts, and so none chatters";
        return Err(UsageError(message.to_owned()).into());
    }
    let view = WindowView {
        title: title(&sweep, &all),
        units: sweep.content.units,
        regions: chart.safe_regions(),
        best: chart.best(arguments.clearance),
        clearance: arguments.clearance,
        not_examined,
        how_often_wrong,
        chart: &chart,
    };
    let folder = arguments.out.clone().unwrap_or_else(|| all[0].0.clone());
    make_folder(&folder)?;
    write_atomically(&folder.join("window.csv"), &tables::window(&chart)?)?;
    save_picture(&folder, "window", &window_picture(&view))?;
    let files = words::files(&folder);
    if arguments.document.json {
        say_document("window", &WindowFound::new(&view, files))?;
    } else {
        say(&words::describe(&view, &files))?;
    }
    Ok(Status::Complete)
}

/// Why there is no window, in the words of the command line.
fn in_words(error: WindowError) -> anyhow::Error {
    let message = match error {
        WindowError::Results(error) => return error,
        WindowError::Boundary(error) => return error.into(),
        WindowError::String(error) => return error.into(),
        WindowError::Frequencies(error) => return error.into(),
        WindowError::NotBent
        | WindowError::Lies
        | WindowError::NotHeld
        | WindowError::HeldAt(_) => format!("--held-at: {error}"),
        _ => error.to_string(),
    };
    UsageError(message).into()
}

fn title(sweep: &Sweep, all: &[(PathBuf, ResultTables)]) -> String {
    let so_far = all.iter().find_map(|(_, tables)| tables.so_far);
    let so_far = so_far.map_or_else(String::new, |so_far| format!(" ({so_far})"));
    format!("{}: operating window{so_far}", sweep.title)
}
