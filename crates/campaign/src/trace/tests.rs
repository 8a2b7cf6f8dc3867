//! Traces of regimes that are known everywhere, against full grids of them.

use std::f64::consts::TAU;

use super::*;
use crate::random::Stream;

/// What a point is, by its place as parts of both axes.
type Regime<'a> = &'a dyn Fn(f64, f64) -> bool;

struct Trial {
    known: Known,
    traced: Traced,
    simulated: usize,
    rounds: usize,
}

fn parts(lattice: Lattice, place: [usize; 2]) -> [f64; 2] {
    let size = lattice.size();
    [0, 1].map(|axis| place[axis] as f64 / (size[axis] - 1) as f64)
}

fn class_at(lattice: Lattice, regime: Regime, point: usize) -> Class {
    let rows = lattice.size()[1];
    let [x, y] = parts(lattice, [point / rows, point % rows]);
    if regime(x, y) {
        Class::With
    } else {
        Class::Without
    }
}

/// Simulates what is wanted until nothing is; of each round only every `every`th point, as
/// if the run was stopped.
fn trace_in_parts(lattice: Lattice, regimes: &[Regime], every: usize) -> Trial {
    let mut known = Known::nothing(lattice, regimes.len());
    let (mut simulated, mut rounds) = (0, 0);
    loop {
        match next(&known, 7) {
            Next::Wanted(points) => {
                for point in points.into_iter().step_by(every) {
                    for (layer, regime) in regimes.iter().enumerate() {
                        known.set(layer, point, class_at(lattice, regime, point));
                    }
                    simulated += 1;
                }
                rounds += 1;
            }
            Next::Done(traced) => {
                return Trial {
                    known,
                    traced: *traced,
                    simulated,
                    rounds,
                };
            }
        }
    }
}

fn trace(lattice: Lattice, regime: Regime) -> Trial {
    trace_in_parts(lattice, &[regime], 1)
}

/// Points of the grid of which a trace says the wrong thing, and of which it says nothing.
fn wrong_and_unknown(trial: &Trial, regime: Regime) -> [usize; 2] {
    let lattice = trial.known.lattice;
    let rows = lattice.size()[1];
    let classes = (0..lattice.points()).map(|point| {
        let traced = trial.traced.classes.at(0, [point / rows, point % rows]);
        (traced, class_at(lattice, regime, point))
    });
    classes.fold([0, 0], |[wrong, unknown], (traced, true_one)| {
        let is_unknown = traced == Class::Unknown;
        let is_wrong = !is_unknown && traced != true_one;
        [
            wrong + usize::from(is_wrong),
            unknown + usize::from(is_unknown),
        ]
    })
}

fn chance(x: f64, y: f64) -> f64 {
    let number = (x * 1e6) as u64 * 1_000_003 + (y * 1e6) as u64;
    Stream::new(3, number).part()
}

#[test]
fn a_line_an_island_and_a_loop_are_those_of_the_full_grid_for_few_points() {
    let lattice = Lattice::new([8, 8], 1.0 / 129.0);
    assert_eq!(lattice.size(), [257, 257]);
    let regime: Regime = &|x, y| {
        let is_below = y < 0.2 + 0.3 * (1.5 * x).sin();
        let is_island = (x - 0.7).hypot(y - 0.75) < 0.15;
        is_below || is_island
    };
    let trial = trace(lattice, regime);
    assert_eq!(wrong_and_unknown(&trial, regime), [0, 0]);
    assert!(trial.traced.bands[0].is_empty());
    let part = trial.simulated as f64 / lattice.points() as f64;
    assert!(part < 0.1, "{part}");
    let lines = contours(&trial.traced, 0);
    let is_closed: Vec<bool> = lines
        .iter()
        .map(|line| line[0] == line[line.len() - 1])
        .collect();
    assert_eq!(is_closed, [false, true]);
    // Within half a step of the circle, along an axis.
    for place in &lines[1] {
        let [x, y] = place.map(|place| place as f64 / 512.0);
        let off = (x - 0.7).hypot(y - 0.75) - 0.15;
        assert!(off.abs() < 0.5 / 256.0, "{off}");
    }
}

/// The same points in the end, however a run was stopped, and in any rounds.
#[test]
fn where_a_trace_was_stopped_does_not_change_it() {
    let lattice = Lattice::new([8, 6], 0.01);
    let line: Regime = &|x, y| y < 0.5 + 0.2 * (9.0 * x).cos();
    let band: Regime = &|x, y| chance(x, y) < 6.0 * (y - 0.4 * x - 0.2);
    let whole = trace_in_parts(lattice, &[line, band], 1);
    let parts = trace_in_parts(lattice, &[line, band], 3);
    assert!(parts.rounds > whole.rounds);
    assert_eq!(parts.known, whole.known);
    assert_eq!(parts.traced.bands, whole.traced.bands);
}

#[test]
fn a_ragged_limit_has_a_band_and_no_line_and_its_parts_are_those_of_the_grid() {
    let lattice = Lattice::new([8, 8], 0.004);
    // From none to all, over a quarter of the axis.
    let probability = |x: f64, y: f64| 4.0 * (y - 0.5 * x - 0.2);
    let regime: Regime = &|x, y| chance(x, y) < probability(x, y);
    let trial = trace(lattice, regime);
    let bands = &trial.traced.bands[0];
    let points: usize = bands.iter().map(|band| band.tile.side.pow(2)).sum();
    let of_band = 0.25 * lattice.points() as f64;
    assert!(points as f64 > 0.8 * of_band, "{points} of {of_band}");
    assert!(
        (trial.simulated as f64) < 0.6 * of_band,
        "{}",
        trial.simulated
    );
    let (mut off, mut square) = (0.0, 0.0);
    let mut count = 0.0;
    for band in bands.iter().filter(|band| band.tile.side > 4) {
        let own: Vec<_> = band.tile.own().collect();
        let with = own.iter().filter(|place| {
            let [x, y] = parts(lattice, **place);
            regime(x, y)
        });
        let of_grid = with.count() as f64 / own.len() as f64;
        let of_band = band.with as f64 / band.classified as f64;
        off += of_band - of_grid;
        square += (of_band - of_grid).powi(2) - of_grid * (1.0 - of_grid) / band.classified as f64;
        count += 1.0;
    }
    assert!(count > 50.0);
    // Neither too many nor too few, and no further off than 16 points make.
    assert!((off / count).abs() < 0.02, "{}", off / count);
    assert!(square / count < 0.005, "{}", square / count);
    let lines = contours(&trial.traced, 0);
    let length: usize = lines.iter().map(Vec::len).sum();
    assert!(length < 200, "{length}");
}

#[test]
fn a_ragged_limit_does_not_hide_the_line_of_another_layer() {
    let lattice = Lattice::new([8, 8], 0.008);
    let line: Regime = &|x, y| y < 0.3 + 0.5 * x;
    let band: Regime = &|x, y| chance(x, y) < 2.0 * (y - 0.1);
    let trial = trace_in_parts(lattice, &[line, band], 1);
    assert!(trial.traced.bands[0].is_empty());
    assert!(trial.traced.bands[1].len() > 100);
    assert_eq!(contours(&trial.traced, 0).len(), 1);
    assert_eq!(wrong_and_unknown(&trial, line), [0, 0]);
}

/// What the coarse scan does not see may be missed: as the guide says.
#[test]
fn an_island_within_a_coarse_cell_is_missed() {
    let lattice = Lattice::new([8, 8], 0.01);
    let regime: Regime = &|x, y| (x - 0.56).hypot(y - 0.56) < 0.05;
    let trial = trace(lattice, regime);
    assert_eq!(trial.simulated, 81);
    assert!(wrong_and_unknown(&trial, regime)[0] > 0);
}

/// Regimes with smooth limits, several of them, as waves of random lengths make them: what
/// is wrong is as much as the guide says.
#[test]
fn random_smooth_limits_are_those_of_the_full_grid() {
    let lattice = Lattice::new([8, 8], 0.008);
    let (mut wrong, mut with_wrong, mut unknown, mut simulated) = (0, 0, 0, 0);
    const TRIALS: usize = 100;
    for trial in 0..TRIALS {
        let mut stream = Stream::new(11, trial as u64);
        let waves: Vec<[f64; 4]> = (0..4)
            .map(|_| {
                let mut between = |from, to| from + (to - from) * stream.part();
                [
                    between(-1.5, 1.5),
                    between(-1.5, 1.5),
                    between(0.0, TAU),
                    between(0.2, 1.0),
                ]
            })
            .collect();
        let regime: Regime = &|x, y| {
            let wave =
                |[a, b, phase, size]: &[f64; 4]| size * (TAU * (a * x + b * y) + phase).sin();
            waves.iter().map(wave).sum::<f64>() > 0.2
        };
        let trial = trace(lattice, regime);
        let [of_trial, left] = wrong_and_unknown(&trial, regime);
        wrong += of_trial;
        with_wrong += usize::from(of_trial > 0);
        unknown += left;
        simulated += trial.simulated;
    }
    let all = (TRIALS * lattice.points()) as f64;
    let parts = [wrong, unknown, simulated].map(|count| count as f64 / all);
    println!("{with_wrong} of {TRIALS} with a wrong label; wrong, unknown, simulated: {parts:?}");
    assert!(
        parts[0] < 5e-4 && parts[1] < 0.01 && parts[2] < 0.3,
        "{parts:?}"
    );
}
