//! The film of a string in its hole.

use linear::elements::reconstruction::Reconstruction;
use sim::laws::contact::Touch;

use super::marks::CLEARANCE_SHOWN;
use super::whole_string::wall_line;
use campaign::engine::{Case, Clearances, Simulation};
use campaign::plan::Sweep;
use campaign::quantities::{LENGTH, WIDTH};
use campaign::words::decimals;
use plot::{Axis, Film, FilmDot, FilmFrame, FilmWords, Look, Picture, film};

/// The string is shown from where its peak displacement is this part of the largest.
const SHOWN_FROM: f64 = 0.05;

/// The most decimals of a time, s.
const MOST_DECIMALS: f64 = 5.0;

/// What is drawn, in the legend.
const WORDS: FilmWords = FilmWords {
    curves: ["x", "y"],
    radius: "radius r, to both sides",
    dots: ["site that touches the wall", "site that does not"],
    walls: ["wall at a site", "between sites"],
};

/// The curves of a string that lies in its hole.
const LYING_CURVES: [&str; 2] = ["x, to the high side", "y, to the right"];

/// The shapes that were kept of a simulation, at their steps; what moves less than a twentieth
/// of the most, above the rest, is left out.
pub fn film_picture(
    look: &Look,
    sweep: &Sweep,
    cases: &[Case],
    simulation: &Simulation,
    whole: &Reconstruction,
    steps: &[usize],
) -> Picture {
    let [length, width] = [&LENGTH, &WIDTH].map(|twin| sweep.content.units.of(twin));
    let string_length = sweep.setting.string.length();
    let above_bit = |depth: f64| length.number(string_length - depth);
    let first = first_shown(&whole.peaks);
    let motion = &simulation.trajectory;
    let distances = sweep.setting.sites.distances_from_bit();
    let across = |value: f64| width.number(1e3 * value);
    let places = time_decimals(motion.times.as_slice(), steps);
    let highest = string_length - whole.depths[first];
    let frames = steps.iter().zip(&whole.shapes).map(|(&step, [x, y])| {
        let site = |(site, &distance): (usize, &f64)| {
            let [x, y] = motion.positions[site][step];
            FilmDot {
                place: length.number(distance),
                radius: across(x.hypot(y)),
                filled: motion.touches[site][step] != Touch::Free,
            }
        };
        FilmFrame {
            title: format!("t = {} s", decimals(motion.times[step], places)),
            shape: (x[first..].iter().zip(&y[first..]))
                .map(|(x, y)| [across(*x), across(*y)])
                .collect(),
            dots: (distances.iter().enumerate())
                .filter(|(_, distance)| **distance <= highest)
                .map(site)
                .collect(),
        }
    });
    let case = cases.iter().find(|case| case.index == simulation.case);
    let clearances = case.and_then(|case| Clearances::of(&sweep.setting, case));
    let furthest = whole.peaks.iter().copied().fold(0.0, f64::max);
    let from = whole.depths[first];
    let at_sites = clearances.iter().flat_map(Clearances::sites);
    let at_sites: Vec<(f64, f64)> = at_sites
        .filter(|(depth, clearance)| *depth >= from && furthest > CLEARANCE_SHOWN * clearance)
        .copied()
        .collect();
    let is_near = !at_sites.is_empty();
    let line = clearances.filter(|_| is_near);
    let line = line.map_or_else(Vec::new, |clearances| wall_line(&clearances, from));
    let drawn = |wall: &[(f64, f64)]| {
        let points = wall.iter();
        let point = |(depth, clearance): &(f64, f64)| (across(*clearance), above_bit(*depth));
        points.map(point).collect::<Vec<_>>()
    };
    let cut = (first > 0).then(|| {
        let from = length.text(highest, 0);
        let least = match sweep.setting.lying {
            Some(_) => "is less off the middle than by 5 % of the most",
            None => "moves less than 5 % of the most",
        };
        format!("Higher than {from} above the bit the string {least}.")
    });
    let shown = Film {
        title: format!(
            "{}: the string in its hole, {}",
            sweep.title, simulation.name
        ),
        axes: [
            format!("x, y, r ({})", width.name),
            format!("Above the bit ({})", length.name),
        ]
        .map(Axis::linear),
        places: whole.depths[first..]
            .iter()
            .copied()
            .map(above_bit)
            .collect(),
        wall: drawn(&line),
        wall_at_dots: drawn(&at_sites),
        words: FilmWords {
            curves: match sweep.setting.lying {
                Some(_) => LYING_CURVES,
                None => WORDS.curves,
            },
            ..WORDS
        },
        notes: cut.into_iter().collect(),
        frames: frames.collect(),
    };
    film(look, &shown)
}

/// The uppermost node that is shown.
fn first_shown(peaks: &[f64]) -> usize {
    let largest = peaks.iter().copied().fold(0.0, f64::max);
    let first = peaks.iter().position(|peak| *peak > SHOWN_FROM * largest);
    first.unwrap_or(0)
}

/// Decimals that tell the times of steps apart.
fn time_decimals(times: &[f64], steps: &[usize]) -> usize {
    let pairs = steps.windows(2);
    let gaps = pairs.map(|pair| times[pair[1]] - times[pair[0]]);
    let least = gaps.fold(f64::INFINITY, f64::min);
    (1.0 - least.log10().floor()).clamp(1.0, MOST_DECIMALS) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_string_is_shown_from_where_it_moves() {
        assert_eq!(first_shown(&[0.0, 0.049, 0.051, 0.0, 1.0]), 2);
        assert_eq!(first_shown(&[0.0; 3]), 0);
    }

    #[test]
    fn times_are_distinguishable() {
        let times = [0.0, 0.0015, 0.003, 0.8, 1.6];
        assert_eq!(time_decimals(&times, &[0, 3, 4]), 2);
        assert_eq!(time_decimals(&times, &[0, 1, 2]), 4);
        assert_eq!(time_decimals(&times, &[2]), 1);
    }
}
