//! The cases that the maps of a results folder are drawn from.

use std::path::PathBuf;

use anyhow::Result;

use super::extent::Extent;
use crate::output::ResultTables;
use crate::plan::MapSettings;
use crate::quantities::Axis;

/// The cases of a results folder.
pub struct MapCases {
    /// Their `labels.csv`.
    pub labels: PathBuf,
    /// The axes of the maps, to the right and upwards.
    pub on_map: [Axis; 2],
    /// The axes of the design that are not on the map.
    pub others: Vec<Axis>,
    /// What they span.
    pub extent: Extent,
}

impl MapCases {
    /// Looks at the cases once.
    ///
    /// # Errors
    /// Where labels cannot be read.
    pub fn read(tables: &ResultTables, settings: &MapSettings) -> Result<Self> {
        let labels = tables.folder.join("labels.csv");
        let on_map = [settings.x, settings.y];
        let others = tables.manifest.axes.iter().copied();
        let others: Vec<_> = others.filter(|axis| !on_map.contains(axis)).collect();
        Ok(Self {
            extent: Extent::of(&labels, on_map, &others)?,
            labels,
            on_map,
            others,
        })
    }

    /// The combinations of values of the other axes that have a map each; none of
    /// many, or of such that hardly two cases share: their cases are put together.
    pub fn combinations(&self) -> Option<&[Vec<f64>]> {
        let few = self.extent.others.as_deref()?;
        (few.len() <= 1 || 2 * few.len() <= self.extent.cases).then_some(few)
    }
}
