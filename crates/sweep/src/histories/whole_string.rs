//! The picture of the whole string.

use anyhow::Result;
use linear::elements::reconstruction::WholeString;

use super::marks::level;
use super::simulation::Simulation;
use crate::plan::{LateralSettings, Sweep};
use crate::plot::{Axis, Panel, Picture, Series, panels};

/// Fig. 13: the peak displacement of the whole string, reconstructed by finite
/// elements from the forces at its sites, whatever method gave them.
///
/// # Errors
/// Where finite elements cannot treat the string.
pub fn string_picture(
    sweep: &Sweep,
    lateral: &LateralSettings,
    simulations: &[Simulation],
) -> Result<Picture> {
    let whole = WholeString {
        string: &sweep.setting.string,
        bending: &lateral.bending,
        support: lateral.support,
        sites: &sweep.setting.sites,
        sampling_frequency: sweep.setting.sampling_frequency,
        parameters: sweep.content.method.finite_element,
    };
    let series = simulations
        .iter()
        .map(|simulation| {
            let whole = whole.reconstruct(&simulation.trajectory.forces, &[])?;
            let peaks = whole.peaks.iter().map(|peak| 1e3 * peak);
            Ok(Series {
                name: simulation.name.clone(),
                points: whole.depths.iter().copied().zip(peaks).collect(),
            })
        })
        .collect::<Result<Vec<_>>>()?;
    let clearance = lateral.walls.iter().map(|wall| wall.clearance);
    let least = 1e3 * clearance.fold(f64::INFINITY, f64::min);
    let panel = Panel {
        axes: ["Depth ξ (m)", "Peak radius (mm)"].map(Axis::linear),
        series,
        references: vec![level(least, "least clearance")],
    };
    panels(&format!("{}: the whole string", sweep.title), &[panel])
}
