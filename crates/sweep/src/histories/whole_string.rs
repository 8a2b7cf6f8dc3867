//! The whole string, from the forces at its sites.

use anyhow::{Context, Result};
use linear::elements::reconstruction::Reconstruction;

use super::marks::{CLEARANCE_SHOWN, each_clearance, style};
use campaign::engine::{Case, Clearances, Simulation, reconstructed};
use campaign::plan::Sweep;
use campaign::quantities::{LENGTH, Unit, WIDTH};
use plot::{Axis, Look, Panel, Picture, Series, Wall, panels};

/// The part of the string above the uppermost site, in that below it, that is shown around the
/// sites; and the part of the string that they are within, where they are shown apart.
const SHOWN_ABOVE: f64 = 0.15;
const APART: f64 = 0.5;

/// A wall with more corners than this, those of every tool joint of a long string, is shown by its
/// least clearance in each of this number of pieces.
const MOST_CORNERS: usize = 400;
const PIECES: usize = 150;

/// The whole string of each simulation, where it bends, reconstructed by finite elements from the
/// forces at its sites, by any method; of the first one the shapes in these steps too.
///
/// # Errors
/// Where finite elements cannot treat the string.
pub fn whole_strings(
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
    snapshots: &[usize],
) -> Result<Vec<Reconstruction>> {
    let of_each = simulations.iter().enumerate().map(|(index, simulation)| {
        let snapshots = if index == 0 { snapshots } else { &[] };
        let case = cases.iter().find(|case| case.index == simulation.case);
        let mut methods = sweep.methods.iter();
        let method = methods.find(|method| method.name() == simulation.method);
        let (case, method) = case
            .zip(method)
            .context("a history of no case and method")?;
        let moved = (method, &simulation.trajectory);
        Ok(reconstructed(
            sweep,
            (&sweep.setting, case),
            moved,
            snapshots,
        )?)
    });
    of_each.filter_map(Result::transpose).collect()
}

/// Fig. 13: the peak displacement of whole strings, with the clearance at their sites; where
/// these are in the lower half, that part again.
pub fn string_picture(
    look: &Look,
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
    wholes: &[Reconstruction],
) -> Picture {
    let [length, width] = [&LENGTH, &WIDTH].map(|twin| sweep.content.units.of(twin));
    let peaks = wholes.iter().flat_map(|whole| &whole.peaks);
    let furthest = peaks.copied().fold(0.0, f64::max);
    let all = each_clearance(sweep, cases);
    let near = |clearances: &&Clearances| {
        let least = clearances.sites().iter().map(|site| site.1);
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
                style: style(simulation, simulations),
                points: shown(&whole.depths, &whole.peaks, from, [&length, &width]),
            })
            .collect(),
        references: Vec::new(),
        walls: (all.iter().filter(near))
            .map(|clearances| wall(clearances, from, [&length, &width]))
            .collect(),
        is_difference: false,
    };
    let string = &sweep.setting.string;
    let (whole_length, bends) = (string.length(), string.bending_length());
    let mut list = vec![panel("Depth ξ", whole_length - bends)];
    let reach = sweep.setting.sites.distances_from_bit()[0];
    if reach > 0.0 && reach < APART * bends {
        let from = whole_length - (1.0 + SHOWN_ABOVE) * reach;
        list.push(panel("Depth ξ around the sites", from));
    }
    let shown = match bends < whole_length {
        true => "what is modelled sideways",
        false => "the whole string",
    };
    panels(look, &format!("{}: {shown}", sweep.title), &list)
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

fn wall(clearances: &Clearances, from: f64, units: [&Unit; 2]) -> Wall {
    let points = |places: &[(f64, f64)]| {
        let (depths, clearances): (Vec<f64>, Vec<f64>) = places.iter().copied().unzip();
        shown(&depths, &clearances, from, units)
    };
    Wall {
        name: "clearance, sites as rings".to_owned(),
        line: points(&wall_line(clearances, from)),
        known: points(clearances.sites()),
    }
}

/// The wall from a depth (m) down to the bit, as it is drawn: corners by depth and clearance, m.
pub fn wall_line(clearances: &Clearances, from: f64) -> Vec<(f64, f64)> {
    // The wall continues to where the picture begins.
    let begins = clearances.at(from).map(|clearance| (from, clearance));
    let corners = clearances.line().into_iter();
    let line: Vec<(f64, f64)> = (begins.into_iter())
        .chain(corners.filter(|corner| corner.0 > from))
        .collect();
    if line.len() > MOST_CORNERS {
        least_of_each_piece(&line)
    } else {
        line
    }
}

/// The least clearance of each of even pieces of a wall, level over each.
fn least_of_each_piece(line: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let Some((first, last)) = line.first().zip(line.last()) else {
        return Vec::new();
    };
    let length = (last.0 - first.0) / PIECES as f64;
    let pieces = (0..PIECES).flat_map(|piece| {
        let ends = [piece, piece + 1].map(|end| first.0 + length * end as f64);
        // What is level there, too, begins before it or ends after it.
        let above = line.partition_point(|corner| corner.0 < ends[0]);
        let below = line.partition_point(|corner| corner.0 <= ends[1]);
        let around = &line[above.saturating_sub(1)..(below + 1).min(line.len())];
        let least = around.iter().map(|corner| corner.1);
        let least = least.fold(f64::INFINITY, f64::min);
        ends.map(|end| (end, least))
    });
    pieces.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wall_of_many_corners_is_shown_by_its_least_clearance() {
        // Joints of half a metre every ten, and one of them narrower.
        let line: Vec<(f64, f64)> = (0..300)
            .flat_map(|joint| {
                let from = 10.0 * f64::from(joint);
                let narrow = if joint == 200 { 0.01 } else { 0.03 };
                [(0.0, 0.05), (9.5, 0.05), (9.5, narrow), (10.0, narrow)]
                    .map(|(depth, clearance)| (from + depth, clearance))
            })
            .collect();
        let shown = least_of_each_piece(&line);
        assert_eq!(shown.len(), 2 * PIECES);
        let at = |depth: f64| {
            let next = shown.partition_point(|corner| corner.0 < depth);
            shown[next].1
        };
        assert_eq!((at(1000.0), at(2009.8), at(2500.0)), (0.03, 0.01, 0.03));
        assert_eq!(shown.last().unwrap().0, 3000.0);
    }
}
