//! Pictures in a folder: the map of its results, and whatever else is drawn.

use std::path::Path;

use anyhow::Result;

use crate::map;
use crate::output::{Manifest, PICTURES, ResultTables, write_atomically};
use crate::plot::Picture;

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
