//! `--modes`: natural frequencies, the surface speeds at which a multiple meets one, and mode
//! shapes.

mod found;
mod pictures;
mod speeds;
mod tables;
mod words;

use std::path::Path;

use anyhow::Result;

use crate::commands::drawing::Drawing;
use campaign::plan::Sweep;
use found::{Modes, find};
use pictures::{campbell_picture, shape_picture};
use results::files::write_atomically;
use speeds::Excitation;

/// Finds and describes the modes, a number of the lowest in full; then writes
/// tables and pictures.
///
/// # Errors
/// Where that takes too long, or the files cannot be written.
pub fn show_modes(
    sweep: &Sweep,
    count: usize,
    orders: &[f64],
    folder: &Path,
    drawing: &Drawing,
) -> Result<String> {
    let excitation = Excitation::of(sweep, orders)?;
    let found = find(sweep, count, &excitation)?;
    write_found(&found, &excitation, folder)?;
    let (look, units) = (&drawing.look, sweep.content.units);
    let campbell = campbell_picture(look, &sweep.title, &found, &excitation);
    drawing.save(folder, "campbell", &campbell)?;
    let shapes = shape_picture(look, &sweep.title, &found, units);
    drawing.save(folder, "mode_shapes", &shapes)?;
    let mut text = words::describe(sweep, &found, &excitation, count);
    for name in ["campbell", "mode_shapes"] {
        let shown = folder.join(drawing.shown(name));
        text += &format!("  picture: {}\n", shown.display());
    }
    Ok(text)
}

/// Finds the modes and writes their tables.
///
/// # Errors
/// As [`show_modes`].
pub fn write_modes(sweep: &Sweep, count: usize, orders: &[f64], folder: &Path) -> Result<()> {
    let excitation = Excitation::of(sweep, orders)?;
    write_found(&find(sweep, count, &excitation)?, &excitation, folder)
}

fn write_found(found: &[Modes], excitation: &Excitation, folder: &Path) -> Result<()> {
    for (name, table) in [
        ("modes.csv", tables::modes(found)?),
        (
            "critical_speeds.csv",
            tables::critical_speeds(found, excitation)?,
        ),
        ("mode_shapes.csv", tables::shapes(found)?),
    ] {
        write_atomically(&folder.join(name), &table)?;
    }
    Ok(())
}
