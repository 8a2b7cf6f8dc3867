//! `sweep plot`: the regime map of a results folder.

use std::path::Path;

use anyhow::{Result, bail};

use super::{Status, UsageError, say};
use crate::cli::PlotArguments;
use crate::map;
use crate::output::write_atomically;
use crate::plot::{Axis, Picture};

/// Draws the map again.
pub fn plot(arguments: &PlotArguments) -> Result<Status> {
    if !draw_map(&arguments.folder)? {
        bail!(UsageError(format!(
            "{} has no map: its sweep varies fewer than two quantities",
            arguments.folder.display()
        )));
    }
    say(&format!("{}\n", arguments.folder.join("map.png").display()))?;
    Ok(Status::Complete)
}

/// Draws `map.svg` and `map.png` from the files of a results folder; false
/// where its design has no two axes.
pub fn draw_map(folder: &Path) -> Result<bool> {
    let Some(picture) = map::picture(folder)? else {
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
