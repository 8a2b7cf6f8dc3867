//! The axes of a sheet in numbers, for a page that draws its maps itself.

use super::MapSheet;
use super::panel::scales;

/// An axis of all maps of a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct MapAxis {
    /// Its title, with the unit.
    pub title: String,
    /// The values at its ends.
    pub ends: [f64; 2],
    /// Marks at round numbers: the place between the ends, from 0 to 1, and the number.
    pub ticks: Vec<(f64, String)>,
}

impl MapAxis {
    /// The place of a value, from 0 to 1 between the ends.
    pub fn fraction(&self, value: f64) -> f64 {
        (value - self.ends[0]) / (self.ends[1] - self.ends[0])
    }
}

/// The axes of a sheet, as its picture has them, each with about `most` numbers.
pub fn map_axes(sheet: &MapSheet, most: usize) -> [MapAxis; 2] {
    let scales = scales(sheet, [None; 2]);
    [0, 1].map(|axis| {
        let ticks = scales[axis].ticks(most).into_iter();
        MapAxis {
            title: sheet.axes[axis].label.clone(),
            ends: scales[axis].ends(),
            ticks: ticks
                .filter_map(|tick| Some((tick.fraction, tick.label?)))
                .collect(),
        }
    })
}
