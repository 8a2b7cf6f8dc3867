//! `sweep plot`: the regime map of a results folder.

use std::path::Path;

use anyhow::{Result, bail};

use super::folder::{hold, refuse_empty, tables_of};
use super::{Status, UsageError, say};
use crate::cli::PlotArguments;
use crate::map;
use crate::output::{Manifest, PICTURES, ResultTables, write_atomically};
use crate::plot::{Axis, Picture};

/// Draws the map again.
pub fn plot(arguments: &PlotArguments) -> Result<Status> {
    let folder = &arguments.folder;
    refuse_empty(folder)?;
    let _lock = hold(folder, "map.svg")?;
    let mut tables = tables_of(folder)?;
    if tables.manifest.tally.rows == 0 {
        bail!(UsageError(format!(
            "{} has no case to draw yet",
            folder.display()
        )));
    }
    let drawn = match tables.so_far {
        None => draw_and_note(folder, &mut tables.manifest)?,
        Some(_) => draw_map(&tables, folder)?,
    };
    if !drawn {
        bail!(UsageError(format!(
            "{} has no map: its sweep varies fewer than two quantities",
            folder.display()
        )));
    }
    say(&format!("{}\n", folder.join("map.png").display()))?;
    Ok(Status::Complete)
}

/// Draws the map of a finished run in a folder that is held, and notes its checksums.
pub fn draw_and_note(folder: &Path, manifest: &mut Manifest) -> Result<bool> {
    let drawn = draw_map(&ResultTables::finished(folder)?, folder)?;
    if drawn && manifest.has_checksums() {
        manifest.note(folder, &PICTURES)?;
        manifest.write(folder)?;
    }
    Ok(drawn)
}

/// Draws `map.svg` and `map.png` of a results folder's tables into a folder; false
/// where its design has no two axes.
pub fn draw_map(tables: &ResultTables, folder: &Path) -> Result<bool> {
    let Some(picture) = map::picture(tables)? else {
        return Ok(false);
    };
    save_picture(folder, "map", &picture)?;
    Ok(true)
}

/// Writes a picture in both formats.
pub fn save_picture(folder: &Path, name: &str, picture: &Picture) -> Result<()> {
    write_atomically(&folder.join(format!("{name}.svg")), picture.svg.as_bytes())?;
    write_atomically(&folder.join(format!("{name}.png")), &picture.png)
}

/// A linear axis.
pub fn axis(label: &str) -> Axis {
    Axis {
        label: label.to_owned(),
        logarithmic: false,
    }
}
