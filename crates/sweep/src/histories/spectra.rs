//! The picture of what the bit does at which frequency: amplitudes of its speed and of the torque
//! on it, over time and frequency.

use linear::estimates::torsional_travel_time;

use super::spectrum::{Spectrogram, spectrogram};
use campaign::engine::Simulation;
use campaign::plan::Sweep;
use campaign::quantities::TORQUE;
use campaign::records::to_rpm;
use campaign::words::short;
use plot::{Axis, LevelClasses, LevelPanel, Look, Picture, level_chart};
use sim::Trajectory;

/// Simulations that are drawn, each with two panels.
const MOST: usize = 4;

/// A stretch is this many turns of the slowest mode of the string with its bit free, but no more
/// than this part of the history.
const TURNS: f64 = 6.0;
const LARGEST_PART: f64 = 0.2;

/// Of the first simulations with torsional motion; none where none has it for long enough.
pub fn spectra_picture(look: &Look, sweep: &Sweep, simulations: &[Simulation]) -> Option<Picture> {
    let bit = bit_place(sweep)?;
    let unit = sweep.content.units.of(&TORQUE).kilo();
    let slowest = 4.0 * torsional_travel_time(&sweep.setting.string);
    let mut panels = Vec::new();
    let mut stretch = None;
    let with_motion = simulations.iter().filter(|it| has_torsion(it));
    for simulation in with_motion.clone().take(MOST) {
        let motion = &simulation.trajectory;
        let speed: Vec<f64> = motion
            .speeds
            .get(bit)?
            .iter()
            .map(|it| to_rpm(*it))
            .collect();
        let torque = motion.bit_torque.iter();
        let torque: Vec<f64> = torque.map(|it| unit.number(-1e-3 * it)).collect();
        for (what, values, unit) in [
            ("Bit speed", speed, "rpm"),
            ("Torque on the bit", torque, unit.name.as_str()),
        ] {
            let title = format!("{what}, {}", simulation.name);
            let Some(found) = of_history(motion, &values, slowest) else {
                continue;
            };
            stretch.get_or_insert(found.stretch);
            panels.push(panel(title, unit, motion, found));
        }
    }
    let left_out = with_motion.count().saturating_sub(MOST);
    let left_out = match left_out {
        0 => String::new(),
        more => format!(" The first {MOST} of {} are shown.", MOST + more),
    };
    let note = format!(
        "Amplitude of a sine at each frequency, up to half the sampling frequency, in stretches of \
         {} s (Hann window).{left_out}",
        short(stretch?)
    );
    Some(level_chart(look, &sweep.title, &panels, &note))
}

/// The bit among the sites.
pub fn bit_place(sweep: &Sweep) -> Option<usize> {
    let distances = sweep.setting.sites.distances_from_bit();
    distances.iter().position(|distance| *distance == 0.0)
}

/// Whether the bit of a simulation has a torsional motion.
pub fn has_torsion(simulation: &Simulation) -> bool {
    simulation.followed.torsion().is_some() && !simulation.trajectory.speeds.is_empty()
}

fn of_history(motion: &Trajectory, values: &[f64], slowest: f64) -> Option<Spectrogram> {
    let (first, last) = (motion.times.first()?, motion.times.last()?);
    let duration = last - first;
    let sampling = (motion.times.len() - 1) as f64 / duration;
    let stretch = (TURNS * slowest).min(LARGEST_PART * duration);
    spectrogram(values, sampling, stretch)
}

fn panel(title: String, unit: &str, motion: &Trajectory, found: Spectrogram) -> LevelPanel {
    let start = motion.times.first().copied().unwrap_or(0.0);
    LevelPanel {
        title,
        axes: [
            Axis::linear("Time t (s)"),
            Axis::logarithmic("Frequency (Hz)"),
        ],
        edges: [
            found.times.iter().map(|time| start + time).collect(),
            found.frequencies,
        ],
        levels: found.amplitudes,
        scale: format!("Amplitude ({unit})"),
        classes: LevelClasses::Factors,
    }
}
