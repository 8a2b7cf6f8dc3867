//! `--modes`: natural frequencies, the surface speeds at which a multiple meets one, mode shapes, and
//! of a bit that cuts how many ways of vibration grow about steady drilling.

mod drilling;
mod found;
mod pictures;
mod resonances;
mod speeds;
mod tables;
mod words;

use std::path::Path;

use anyhow::Result;
use serde::Serialize;

use crate::commands::drawing::Drawing;
use campaign::plan::Sweep;
use campaign::quantities::Units;
use drilling::InspectedDrilling;
use found::{Modes, find};
use pictures::{campbell_picture, shape_picture};
use resonances::{InspectedResonances, Resonances};
use results::files::write_atomically;
use speeds::Excitation;
use tables::{CriticalSpeed, critical};

/// The modes of a string, and what excites them.
#[derive(Serialize)]
pub struct InspectedModes {
    #[serde(flatten)]
    excitation: Excitation,
    families: Vec<Modes>,
    critical_speeds: Vec<CriticalSpeed>,
    bit_resonances: InspectedResonances,
    steady_drilling: InspectedDrilling,
    /// How many of each family are described in full.
    #[serde(skip)]
    count: usize,
    pictures: Vec<String>,
}

impl InspectedModes {
    /// Finds the modes, a number of the lowest in full, and writes tables and pictures.
    ///
    /// # Errors
    /// Where that takes too long, or the files cannot be written.
    pub fn find(
        sweep: &Sweep,
        count: usize,
        orders: &[f64],
        folder: &Path,
        drawing: &Drawing,
    ) -> Result<Self> {
        let excitation = Excitation::of(sweep, orders)?;
        let families = find(sweep, count, &excitation)?;
        write_found(&families, &excitation, folder)?;
        let (look, units) = (&drawing.look, sweep.content.units);
        let campbell = campbell_picture(look, &sweep.title, &families, &excitation);
        drawing.save(folder, "campbell", &campbell)?;
        let shapes = shape_picture(look, &sweep.title, &families, units);
        drawing.save(folder, "mode_shapes", &shapes)?;
        let resonances = Resonances::find(sweep)?;
        let mut pictures = vec!["campbell", "mode_shapes"];
        if resonances.are_there() {
            resonances.write(folder)?;
            let picture = resonances.picture(look, &sweep.title, units);
            drawing.save(folder, "bit_resonances", &picture)?;
            pictures.push("bit_resonances");
        }
        let drilling = InspectedDrilling::find(sweep)?;
        drilling.write(folder)?;
        let shown = |name| folder.join(drawing.shown(name)).display().to_string();
        Ok(Self {
            critical_speeds: critical(&families, &excitation),
            bit_resonances: resonances.most_easily_fed(),
            steady_drilling: drilling,
            excitation,
            families,
            count,
            pictures: pictures.into_iter().map(shown).collect(),
        })
    }

    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let mut text = words::describe(&self.families, &self.excitation, self.count, units);
        text += &self.bit_resonances.words(units);
        text += &self.steady_drilling.words(units);
        let pictures = self.pictures.iter();
        text.extend(pictures.map(|path| format!("  picture: {path}\n")));
        text
    }
}

/// Finds the modes and writes their tables.
///
/// # Errors
/// As [`InspectedModes::find`].
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
