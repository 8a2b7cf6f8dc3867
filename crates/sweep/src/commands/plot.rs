//! `sweep plot`: the regime map of a results folder.

use anyhow::{Result, bail};

use super::drawing::{Drawing, draw_and_note, draw_map};
use super::folder::{hold, refuse_empty, tables_of};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use crate::cli::PlotArguments;

/// Draws the map again.
pub fn plot(arguments: &PlotArguments, terminal: Terminal) -> Result<Status> {
    let drawing = Drawing::of(&arguments.picture)?.over(&arguments.ranges);
    let folder = arguments.folder.as_path();
    refuse_empty(folder)?;
    let _lock = hold(folder, "map.svg", terminal)?;
    let mut tables = tables_of(folder, terminal)?;
    if tables.manifest.tally.rows == 0 {
        bail!(UsageError(format!(
            "{} has no case to draw yet",
            folder.display()
        )));
    }
    let drawn = match tables.so_far {
        None => draw_and_note(folder, &mut tables.manifest, &drawing)?,
        Some(_) => draw_map(&tables, folder, &drawing)?,
    };
    if !drawn {
        bail!(UsageError(format!(
            "{} has no map: its sweep varies fewer than two quantities",
            folder.display()
        )));
    }
    say(&format!(
        "{}\n",
        folder.join(drawing.shown("map")).display()
    ))?;
    Ok(Status::Complete)
}
