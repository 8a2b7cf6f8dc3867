//! The picture of the paths of sites across the borehole.

use anyhow::Result;

use super::marks::shown_clearances;
use crate::plot::{Axis, Orbit, Picture, Series, orbits};
use campaign::engine::Case;
use campaign::engine::Simulation;
use campaign::plan::Sweep;
use campaign::quantities::WIDTH;
use campaign::words::site_title;

/// The path of every site's centre, with the circle of its clearance in each case where it comes
/// near that.
///
/// # Errors
/// Where it cannot be drawn.
pub fn orbit_picture(sweep: &Sweep, cases: &[Case], simulations: &[Simulation]) -> Result<Picture> {
    let units = sweep.content.units;
    let width = units.of(&WIDTH);
    let distances = sweep.setting.sites.distances_from_bit().iter().enumerate();
    let of_sites = distances.map(|(site, &distance)| {
        let of_site = |simulation: &Simulation| Series {
            name: simulation.name.clone(),
            points: simulation.trajectory.positions[site]
                .iter()
                .map(|[x, y]| (width.number(1e3 * x), width.number(1e3 * y)))
                .collect(),
        };
        let series: Vec<Series> = simulations.iter().map(of_site).collect();
        let points = series.iter().flat_map(|series| &series.points);
        let radii = points.map(|(x, y)| x.hypot(*y));
        let at_site = |clearances: &[f64]| clearances.get(site).copied();
        let circles = shown_clearances(cases, at_site, &width, radii);
        let (site, unit) = (site_title(distance, units), &width.name);
        Orbit {
            axes: [format!("x at {site} ({unit})"), format!("y ({unit})")].map(Axis::linear),
            series,
            circles,
        }
    });
    orbits(&sweep.title, &of_sites.collect::<Vec<_>>())
}
