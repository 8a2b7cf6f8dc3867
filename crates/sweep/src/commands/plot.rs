//! `sweep plot`: the regime map of a results folder.

use std::path::Path;

use anyhow::{Result, bail};

use super::folder::tables_of;
use super::{Status, UsageError, say};
use crate::cli::PlotArguments;
use crate::map;
use crate::output::{Tables, write_atomically};
use crate::plot::{Axis, Picture};

/// Draws the map again.
pub fn plot(arguments: &PlotArguments) -> Result<Status> {
    let folder = arguments.folder.display();
    let tables = tables_of(&arguments.folder)?;
    if tables.manifest.tally.rows == 0 {
        bail!(UsageError(format!("{folder} has no case to draw yet")));
    }
    if !draw_map(&tables, &arguments.folder)? {
        bail!(UsageError(format!(
            "{folder} has no map: its sweep varies fewer than two quantities"
        )));
    }
    say(&format!("{}\n", arguments.folder.join("map.png").display()))?;
    Ok(Status::Complete)
}

/// Draws `map.svg` and `map.png` of a results folder's tables into a folder; false
/// where its design has no two axes.
pub fn draw_map(tables: &Tables, folder: &Path) -> Result<bool> {
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
