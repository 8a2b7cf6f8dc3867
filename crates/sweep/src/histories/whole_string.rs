//! The picture of the whole string.

use anyhow::Result;
use linear::elements::reconstruction::WholeString;

use super::marks::{level, shown_clearance};
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
    let clearances = lateral.walls.iter().map(|wall| wall.clearance);
    let least = clearances.fold(f64::INFINITY, f64::min);
    let peaks = series.iter().flat_map(|series| &series.points);
    let shown = shown_clearance(least, peaks.map(|point| point.1));
    let references = shown.map(|clearance| level(clearance, "least clearance"));
    let panel = Panel {
        axes: ["Depth ξ (m)", "Peak radius (mm)"].map(Axis::linear),
        series,
        references: references.into_iter().collect(),
    };
    panels(&format!("{}: the whole string", sweep.title), &[panel])
}
