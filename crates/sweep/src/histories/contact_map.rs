//! The picture of contact: when each site touches the wall, how hard, and whether it rolls.

use sim::Trajectory;
use sim::laws::contact::Touch;

use campaign::engine::Simulation;
use campaign::plan::Sweep;
use campaign::quantities::{FORCE, LENGTH, Unit};
use campaign::words::short;
use plot::{Axis, BandChart, BandPanel, Bar, COLUMNS, Look, Picture, band_chart};

/// A panel for each case and method; in it a band for each site, from the surface down.
pub fn contact_picture(look: &Look, sweep: &Sweep, simulations: &[Simulation]) -> Picture {
    let units = sweep.content.units;
    let [length, force] = [&LENGTH, &FORCE].map(|twin| units.of(twin));
    let motions = simulations.iter().map(|simulation| &simulation.trajectory);
    let frequency = |motion: &Trajectory| motion.sampling_frequency().unwrap_or(1.0);
    let ends = motions.map(|motion| motion.times.len() as f64 / frequency(motion));
    let end = ends.fold(0.0, f64::max);
    let bin = end / COLUMNS as f64;
    let panels = simulations.iter().map(|simulation| {
        let motion = &simulation.trajectory;
        let frequency = frequency(motion);
        let steps_a_bin = (bin * frequency * (1.0 - 1e-9)).ceil().max(1.0) as usize;
        BandPanel {
            title: simulation.name.clone(),
            rows: bars(motion, frequency, steps_a_bin, &force),
        }
    });
    let distances = sweep.setting.sites.distances_from_bit().iter();
    let rows = distances.map(|&distance| match distance {
        0.0 => "bit".to_owned(),
        // To a centimetre, or as finely in another unit.
        _ => ((100.0 * length.number(distance)).round() / 100.0).to_string(),
    });
    let bin = short(1e3 * bin);
    let chart = BandChart {
        title: format!("{}: contact with the wall", sweep.title),
        axes: [
            "Time t (s)".to_owned(),
            format!("Sites in order, above the bit ({})", length.name),
        ]
        .map(Axis::linear),
        ends: [0.0, end],
        rows: rows.collect(),
        unit: force.name.clone(),
        kinds: ["full height: rolling", "low: sliding"].map(str::to_owned),
        notes: vec![
            "empty: no contact".to_owned(),
            format!(
                "The largest normal force of every {bin} ms; rolling or sliding, whichever takes longer in them."
            ),
        ],
        panels: panels.collect(),
    };
    band_chart(look, &chart)
}

/// The bars of each site, each of a number of steps: with the largest normal force, and full where
/// the site rolls in at least half of the steps in which it touches.
fn bars(motion: &Trajectory, frequency: f64, steps: usize, force: &Unit) -> Vec<Vec<Bar>> {
    let time = |step: usize| step as f64 / frequency;
    let of_site = |(touches, forces): (&Vec<Touch>, &Vec<f64>)| {
        let bins = touches.chunks(steps).zip(forces.chunks(steps)).enumerate();
        let bars = bins.filter_map(|(bin, (touches, forces))| {
            let count = |touch: Touch| touches.iter().filter(|it| **it == touch).count();
            let [rolling, sliding] = [Touch::Rolling, Touch::Sliding].map(count);
            let largest = forces.iter().copied().fold(0.0, f64::max);
            (rolling + sliding > 0).then(|| Bar {
                from: time(bin * steps),
                to: time((bin + 1) * steps),
                value: force.number(1e-3 * largest),
                is_full: rolling >= sliding,
            })
        });
        bars.collect()
    };
    motion
        .touches
        .iter()
        .zip(&motion.normal_forces)
        .map(of_site)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use campaign::quantities::Units;

    #[test]
    fn a_bin_has_its_largest_force_and_what_takes_most_of_its_contact() {
        use Touch::{Free, Rolling, Sliding};
        let motion = Trajectory {
            touches: vec![vec![
                Free, Free, Free, Sliding, Rolling, Rolling, Sliding, Sliding, Rolling, Free,
            ]],
            normal_forces: vec![vec![0.0, 0.0, 0.0, 9e3, 1e3, 2e3, 4e3, 8e3, 1e3, 0.0]],
            ..Trajectory::default()
        };
        let bars = bars(&motion, 100.0, 3, &Units::Si.of(&FORCE));
        let found: Vec<_> = (bars[0].iter())
            .map(|bar| (bar.from, bar.to, bar.value, bar.is_full))
            .collect();
        // The last bin, of one step, is free.
        assert_eq!(found, [(0.03, 0.06, 9.0, true), (0.06, 0.09, 8.0, false)]);
        let at_once = super::bars(&motion, 100.0, 100, &Units::Si.of(&FORCE));
        assert_eq!(at_once[0].len(), 1);
        assert!(at_once[0][0].is_full, "three steps against three");
    }
}
