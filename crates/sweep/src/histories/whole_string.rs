//! The whole string, from the forces at its sites.

use anyhow::Result;
use linear::elements::reconstruction::{Reconstruction, WholeString};

use super::hole::Hole;
use super::marks::{CLEARANCE_SHOWN, each_hole};
use super::simulation::Simulation;
use crate::engine::Case;
use crate::plan::{LateralSettings, Sweep};
use crate::plot::{Axis, Panel, Picture, Series, Wall, panels};
use crate::quantities::{LENGTH, Unit, WIDTH};

/// The part of the string above the uppermost site, in that below it, that is shown around the
/// sites; and the part of the string that they are within, where they are shown apart.
const SHOWN_ABOVE: f64 = 0.15;
const APART: f64 = 0.5;

/// The whole string of each simulation, reconstructed by finite elements from the forces at its
/// sites, whatever method gave them; of the first one the shapes in these steps too.
///
/// # Errors
/// Where finite elements cannot treat the string.
pub fn whole_strings(
    sweep: &Sweep,
    lateral: &LateralSettings,
    simulations: &[Simulation],
    snapshots: &[usize],
) -> Result<Vec<Reconstruction>> {
    let whole = WholeString {
        string: &sweep.setting.string,
        bending: &lateral.bending,
        support: lateral.support,
        sites: &sweep.setting.sites,
        sampling_frequency: sweep.setting.sampling_frequency,
        parameters: sweep.content.method.finite_element,
    };
    let of_each = simulations.iter().enumerate().map(|(index, simulation)| {
        let snapshots = if index == 0 { snapshots } else { &[] };
        Ok(whole.reconstruct(&simulation.trajectory.forces, snapshots)?)
    });
    of_each.collect()
}

/// Fig. 13: the peak displacement of whole strings, with the clearance at their sites; where
/// these are in the lower half, that part again.
///
/// # Errors
/// Where it cannot be drawn.
pub fn string_picture(
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
    wholes: &[Reconstruction],
) -> Result<Picture> {
    let [length, width] = [&LENGTH, &WIDTH].map(|twin| sweep.content.units.of(twin));
    let peaks = wholes.iter().flat_map(|whole| &whole.peaks);
    let furthest = peaks.copied().fold(0.0, f64::max);
    let holes = each_hole(sweep, cases);
    let near = |hole: &&Hole| {
        let least = hole.sites().iter().map(|site| site.1);
        furthest > CLEARANCE_SHOWN * least.fold(f64::INFINITY, f64::min)
    };
    let panel = |label: &str, from: f64| Panel {
        axes: [
            format!("{label} ({})", length.name),
            format!("Peak radius ({})", width.name),
        ]
        .map(Axis::linear),
        series: (simulations.iter().zip(wholes))
            .map(|(simulation, whole)| Series {
                name: simulation.name.clone(),
                points: shown(&whole.depths, &whole.peaks, from, [&length, &width]),
            })
            .collect(),
        references: Vec::new(),
        walls: (holes.iter().filter(near))
            .map(|hole| wall(hole, from, [&length, &width]))
            .collect(),
    };
    let mut list = vec![panel("Depth ξ", 0.0)];
    let whole_length = sweep.setting.string.length();
    let reach = sweep.setting.sites.distances_from_bit()[0];
    if reach > 0.0 && reach < APART * whole_length {
        let from = whole_length - (1.0 + SHOWN_ABOVE) * reach;
        list.push(panel("Depth ξ around the sites", from));
    }
    panels(&format!("{}: the whole string", sweep.title), &list)
}

/// Depths from one on and values there, m, in units of lengths and of widths.
fn shown(
    depths: &[f64],
    values: &[f64],
    from: f64,
    [length, width]: [&Unit; 2],
) -> Vec<(f64, f64)> {
    let points = depths.iter().zip(values);
    let points = points.filter(|(depth, _)| **depth >= from);
    let in_units =
        |(depth, value): (&f64, &f64)| (length.number(*depth), width.number(1e3 * value));
    points.map(in_units).collect()
}

fn wall(hole: &Hole, from: f64, units: [&Unit; 2]) -> Wall {
    let points = |places: &[(f64, f64)]| {
        let (depths, clearances): (Vec<f64>, Vec<f64>) = places.iter().copied().unzip();
        // The wall goes on to where the picture begins.
        let depths: Vec<f64> = depths.iter().map(|depth| depth.max(from)).collect();
        shown(&depths, &clearances, from, units)
    };
    Wall {
        line: points(&hole.line()),
        known: points(hole.sites()),
    }
}
