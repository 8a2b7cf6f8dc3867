//! What describes a run that is not finished. The log keeps it until there is a
//! manifest.

use std::path::Path;

use anyhow::Result;
use serde::{Deserialize, Serialize};

use super::manifest::Manifest;
use crate::log::Header;
use campaign::design::Design;
use campaign::engine::{MethodSystem, RunOptions, pairs_of};
use campaign::labels::{LabelTable, shows_found, shows_string_torque, shows_surface, shows_torque};
use campaign::plan::Sweep;

/// A run that is not finished.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct About {
    /// What `manifest.json` will say, without results and times.
    pub manifest: Manifest,
    /// Whether `labels.csv` has a column of T_d next to the axes.
    pub shows_torque: bool,
    /// Whether it has columns of a bit that cuts.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub shows_cutting: bool,
    /// Whether it has columns of a string that lies in its hole.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub shows_lying: bool,
    /// Whether it has columns of accelerations.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub shows_shocks: bool,
    /// Whether it has columns of bending and stress.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub shows_stress: bool,
    /// Whether it has columns of what turns the surface.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub shows_surface: bool,
    /// Whether it has columns of the torque along the string.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub shows_string_torque: bool,
    /// Whether it has columns of a mud motor.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub shows_motor: bool,
    /// Whether it has columns of how deep walls give way.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub shows_wall: bool,
    /// Its columns of what cases are held against.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub misfits: Vec<String>,
    /// The places of the methods that certify labels, where any do.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certifying: Option<[usize; 2]>,
    /// Whether it has columns of how the bit turns from each start.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub shows_starts: bool,
    /// Whether it has columns of sites that were found.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub shows_found: bool,
    /// The sweep file, as the command names it.
    pub sweep_file: String,
    /// Simulations in all, where that is known beforehand.
    pub simulations: Option<usize>,
}

impl About {
    /// Of a run that begins or continues.
    ///
    /// # Errors
    /// None that a sweep that was read could cause.
    pub fn new(
        sweep: &Sweep,
        sweep_file: &Path,
        header: &Header,
        options: RunOptions,
        systems: &[MethodSystem],
    ) -> Result<Self> {
        let mut manifest = Manifest::new(sweep, header, options, systems)?;
        let is_trace = matches!(sweep.design, Design::Trace(_));
        // The same text however often the run is stopped.
        manifest.threads = 0;
        for method in &mut manifest.methods {
            method.build_seconds = None;
        }
        Ok(Self {
            manifest,
            shows_torque: shows_torque(sweep),
            shows_cutting: sweep.setting.cutting.is_some(),
            shows_lying: LabelTable::of(sweep).shows_lying,
            shows_shocks: LabelTable::of(sweep).shows_shocks,
            shows_stress: LabelTable::of(sweep).shows_stress,
            shows_surface: shows_surface(sweep),
            shows_string_torque: shows_string_torque(sweep),
            shows_motor: sweep.setting.motor.is_some(),
            shows_wall: sweep.setting.lateral.is_some(),
            misfits: LabelTable::of(sweep)
                .misfits
                .into_iter()
                .map(str::to_owned)
                .collect(),
            certifying: sweep.certifying,
            shows_starts: LabelTable::of(sweep).shows_starts,
            shows_found: shows_found(sweep),
            sweep_file: sweep_file.display().to_string(),
            simulations: (!is_trace).then(|| pairs_of(sweep, header.shard)),
        })
    }

    /// What the rows of its `labels.csv` have in common.
    pub fn label_table(&self) -> LabelTable<'_> {
        LabelTable {
            methods: self.manifest.method_names(),
            axes: &self.manifest.axes,
            shows_torque: self.shows_torque,
            shows_cutting: self.shows_cutting,
            shows_lying: self.shows_lying,
            shows_shocks: self.shows_shocks,
            shows_stress: self.shows_stress,
            shows_surface: self.shows_surface,
            shows_string_torque: self.shows_string_torque,
            shows_motor: self.shows_motor,
            shows_wall: self.shows_wall,
            misfits: self.misfits.iter().map(String::as_str).collect(),
            certifying: self.certifying,
            shows_starts: self.shows_starts,
            shows_found: self.shows_found,
        }
    }
}
