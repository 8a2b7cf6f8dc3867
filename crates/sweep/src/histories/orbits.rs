//! The picture of the paths of sites across the borehole.

use super::marks::{shown_clearances, style};
use campaign::engine::{Case, Simulation};
use campaign::plan::Sweep;
use campaign::quantities::WIDTH;
use campaign::words::site_title;
use plot::{Axis, Look, Orbit, Picture, Series, orbits};

/// A lateral label describes the last seconds, this many: they are marked.
const LAST: f64 = 2.0;

/// What circles and the dark ends of paths are, in the legend.
const WORDS: [&str; 2] = ["clearance", "the last seconds, dark; before, faint"];

/// The path of every site's centre, with the circle of its clearance in each case where it comes
/// near that.
pub fn orbit_picture(
    look: &Look,
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
) -> Picture {
    let units = sweep.content.units;
    let width = units.of(&WIDTH);
    // A string that lies in its hole is seen with the low side down.
    let lies = sweep.setting.lying.is_some();
    let distances = sweep.setting.sites.distances_from_bit().iter().enumerate();
    let of_sites = distances.map(|(site, &distance)| {
        let of_site = |simulation: &Simulation| Series {
            name: simulation.name.clone(),
            style: style(simulation, simulations),
            points: simulation.trajectory.positions[site]
                .iter()
                .map(|[x, y]| if lies { [y, x] } else { [x, y] })
                .map(|[x, y]| (width.number(1e3 * x), width.number(1e3 * y)))
                .collect(),
        };
        let series: Vec<Series> = simulations.iter().map(of_site).collect();
        let points = series.iter().flat_map(|series| &series.points);
        let radii = points.map(|(x, y)| x.hypot(*y));
        let at_site = |clearances: &[f64]| clearances.get(site).copied();
        let circles = shown_clearances(cases, at_site, &width, radii);
        let (site, unit) = (site_title(distance, units), &width.name);
        let axes = match lies {
            true => [
                format!("to the right at {site} ({unit})"),
                format!("to the high side ({unit})"),
            ],
            false => [format!("x at {site} ({unit})"), format!("y ({unit})")],
        };
        Orbit {
            axes: axes.map(Axis::linear),
            has_one_scale: true,
            series,
            circles,
            last: simulations
                .iter()
                .map(|it| last_steps(&it.trajectory.times))
                .collect(),
        }
    });
    orbits(look, &sweep.title, WORDS, &of_sites.collect::<Vec<_>>())
}

/// How many steps the last seconds take.
fn last_steps(times: &[f64]) -> usize {
    let end = times.last().copied().unwrap_or(0.0);
    times.len() - times.partition_point(|time| *time < end - LAST)
}
