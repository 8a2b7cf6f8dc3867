//! The plane of phases: the speed of the bit over the twist of the string. Stick-slip goes around a
//! closed path, which rests on the line of no speed while the bit sticks; smooth rotation is a point.

use super::marks::style;
use super::spectra::{bit_place, has_torsion};
use campaign::engine::{Case, Simulation};
use campaign::plan::Sweep;
use campaign::records::to_rpm;
use plot::{Axis, Look, Orbit, Picture, Series, orbits};

/// What the dark ends of paths are, in the legend.
const WORDS: [&str; 2] = ["", "the closing window, dark; before, faint"];

/// What a picture resolves, as a part of the range of a path.
const RESOLVED: f64 = 1e-3;

/// The path of each simulation with torsional motion; none where none has it.
pub fn phase_picture(
    look: &Look,
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
) -> Option<Picture> {
    let bit = bit_place(sweep)?;
    let mut series = Vec::new();
    let mut last = Vec::new();
    for simulation in simulations.iter().filter(|it| has_torsion(it)) {
        let Some(case) = cases.iter().find(|case| case.index == simulation.case) else {
            continue;
        };
        let motion = &simulation.trajectory;
        let speeds = motion.speeds.get(bit)?;
        let surface = surface_speeds(sweep, case, simulation);
        let twist = twist(&motion.times, &surface, speeds);
        let points = twist.iter().zip(speeds);
        let points: Vec<(f64, f64)> = points
            .map(|(twist, speed)| (twist / std::f64::consts::TAU, to_rpm(*speed)))
            .collect();
        // The wind-up before the first slip is no part of the cycle.
        let first = speeds.iter().position(|speed| *speed != 0.0);
        let first = first.map_or(0, |first| first.saturating_sub(1));
        let end = motion.times.last().copied().unwrap_or(0.0);
        let from = end - case.scene.timing.closing_window;
        let closing = motion.times.partition_point(|time| *time < from);
        let [before, after] = [first.min(closing)..closing, closing..points.len()]
            .map(|steps| thinned(&points[steps]));
        last.push(after.len());
        series.push(Series {
            name: simulation.name.clone(),
            style: style(simulation, simulations),
            points: [before, after].concat(),
        });
    }
    if series.is_empty() {
        return None;
    }
    let orbit = Orbit {
        axes: [
            "Twist of the string since the start (turns)",
            "Bit speed (rpm)",
        ]
        .map(Axis::linear),
        has_one_scale: false,
        series,
        circles: Vec::new(),
        last,
    };
    Some(orbits(look, &sweep.title, WORDS, &[orbit]))
}

/// The points of a path that are apart by more than a picture resolves, and its ends.
fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let size = |of: fn(&(f64, f64)) -> f64| {
        let values = points.iter().map(of);
        let [least, most] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], it| {
            [low.min(it), high.max(it)]
        });
        most - least
    };
    let resolved = [size(|point| point.0), size(|point| point.1)].map(|it| RESOLVED * it);
    let mut kept: Vec<(f64, f64)> = Vec::new();
    for (place, &(x, y)) in points.iter().enumerate() {
        let is_apart = kept.last().is_none_or(|last| {
            (x - last.0).abs() > resolved[0] || (y - last.1).abs() > resolved[1]
        });
        if is_apart || place + 1 == points.len() {
            kept.push((x, y));
        }
    }
    kept
}

/// The speed of the surface in every step, rad/s: as it was followed, else as it is set.
fn surface_speeds(sweep: &Sweep, case: &Case, simulation: &Simulation) -> Vec<f64> {
    let motion = &simulation.trajectory;
    if !motion.surface_speed.is_empty() {
        return motion.surface_speed.clone();
    }
    let profile = &sweep.setting.profile;
    let times = motion.times.iter();
    times
        .map(|time| case.scene.surface_speed * profile.at(*time))
        .collect()
}

/// How far the surface has turned beyond the bit, rad: from the speeds of both by the trapezoidal
/// rule.
pub fn twist(times: &[f64], surface: &[f64], bit: &[f64]) -> Vec<f64> {
    let mut twist = Vec::with_capacity(times.len());
    let mut sum = 0.0;
    for step in 0..times.len() {
        if step > 0 {
            let faster = |step: usize| surface[step] - bit[step];
            sum += 0.5 * (times[step] - times[step - 1]) * (faster(step - 1) + faster(step));
        }
        twist.push(sum);
    }
    twist
}
