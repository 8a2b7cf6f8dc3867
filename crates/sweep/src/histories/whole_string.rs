//! The picture of the whole string.

use anyhow::Result;
use linear::elements::reconstruction::WholeString;

use super::marks::{level, shown_clearances};
use super::simulation::Simulation;
use crate::engine::Case;
use crate::plan::{LateralSettings, Sweep};
use crate::plot::{Axis, Panel, Picture, Series, panels};
use crate::quantities::{LENGTH, WIDTH};

/// Fig. 13: the peak displacement of the whole string, reconstructed by finite
/// elements from the forces at its sites, whatever method gave them.
///
/// # Errors
/// Where finite elements cannot treat the string.
pub fn string_picture(
    sweep: &Sweep,
    lateral: &LateralSettings,
    cases: &[Case],
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
    let [length, width] = [&LENGTH, &WIDTH].map(|twin| sweep.content.units.of(twin));
    let series = simulations
        .iter()
        .map(|simulation| {
            let whole = whole.reconstruct(&simulation.trajectory.forces, &[])?;
            let depths = whole.depths.iter().map(|depth| length.number(*depth));
            let peaks = whole.peaks.iter().map(|peak| width.number(1e3 * peak));
            Ok(Series {
                name: simulation.name.clone(),
                points: depths.zip(peaks).collect(),
            })
        })
        .collect::<Result<Vec<_>>>()?;
    let least = |clearances: &[f64]| clearances.iter().copied().reduce(f64::min);
    let peaks = series.iter().flat_map(|series| &series.points);
    let shown = shown_clearances(cases, least, &width, peaks.map(|point| point.1));
    let references = shown.into_iter().map(|at| level(at, "least clearance"));
    let panel = Panel {
        axes: [
            format!("Depth ξ ({})", length.name),
            format!("Peak radius ({})", width.name),
        ]
        .map(Axis::linear),
        series,
        references: references.collect(),
    };
    panels(&format!("{}: the whole string", sweep.title), &[panel])
}
