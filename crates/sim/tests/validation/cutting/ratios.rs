//! Maps of how far a bit slows down below its mean speed, over rate of penetration and speed, in the
//! numbers without dimension of U. J. F. Aarsnes and N. van de Wouw, "Axial and torsional
//! self-excited vibrations of a distributed drill-string", *Journal of Sound and Vibration*
//! (2019): by the stepper, and by exact delay lines in small explicit steps.
//!
//! A wave of torsion takes a time of 1 along the string, one along the axis 1/1.6; 0.7 of each is sent
//! back. Torque is the depth of cut and 0.1 of what the flats carry, weight K_a times the depth of cut
//! and what they carry, 200. A push of 1 until t = 15 disturbs steady drilling until t = 60; the ratio is
//! what the least speed of the last 20 lacks.

use std::f64::consts::TAU;

use linear::parallel;
use problems::delay_lines::{CuttingBit, Rock};
use sim::{Kick, SimulationError};

use super::scene::{Drilling, given, one_blade, ringing};

/// A place of a map.
#[derive(Debug, Clone, Copy)]
struct Place {
    stiffness: f64,
    rate: f64,
    /// In turns: the delay is one over it.
    speed: f64,
}

const FLATS: f64 = 200.0;
const FLAT_RADIUS: f64 = 0.1;
const AXIAL_SPEED: f64 = 1.6;
const SENT_BACK: f64 = 0.7;
const DURATION: f64 = 60.0;
const PUSHED: f64 = 15.0;
const WINDOW: f64 = 20.0;

/// Of the stepper, and of explicit steps.
const STEP: f64 = 2.5e-3;
const FINE_STEP: f64 = 2.5e-4;

/// Where a bit is faster than this many times its mean speed, it is taken to stick.
const TOO_FAST: f64 = 10.0;

/// All places of a map of a number of rows and columns.
fn map(stiffness: f64, [rows, columns]: [usize; 2]) -> Vec<Place> {
    let log = |[from, to]: [f64; 2], at: usize, count: usize| {
        10f64.powf(from + (to - from) * at as f64 / (count - 1) as f64)
    };
    let row = |row: usize| {
        let rate = log([-1.0, 1.5], row, rows);
        let ends = [0.2 * rate + 0.03, 1.2 * rate + 2.5].map(f64::log10);
        (0..columns).map(move |column| Place {
            stiffness,
            rate,
            speed: log(ends, column, columns),
        })
    };
    (0..rows).flat_map(row).collect()
}

fn by_delay_lines(place: Place, step: f64) -> f64 {
    let rock = Rock {
        stiffnesses: [1.0, place.stiffness],
        flats: FLATS,
        growth: f64::INFINITY,
        flat_radius: FLAT_RADIUS,
        apart: 1.0,
        relief: f64::INFINITY,
    };
    let tubes = [&[[1.0, 1.0]][..], &[[1.0 / AXIAL_SPEED, 1.0 / AXIAL_SPEED]]];
    let mut bit =
        CuttingBit::drilling(rock, tubes, [SENT_BACK; 2], [place.speed, place.rate], step);
    let steps = (DURATION / step).round() as usize;
    let mut least = f64::INFINITY;
    for index in 0..steps {
        let time = index as f64 * step;
        let push = if time < PUSHED { -1.0 } else { 0.0 };
        let now = bit.advance([0.0, push]);
        if now.speed > TOO_FAST * place.speed {
            return 1.0;
        }
        if time >= DURATION - WINDOW {
            least = least.min(now.speed);
        }
    }
    1.0 - least / place.speed
}

/// The stepper, in steps of a time. Torque and weight are those of a bit of one blade and a radius of
/// 1; it turns by 2π while the numbers without dimension count one.
fn by_stepper(place: Place, step: f64) -> f64 {
    let count = (DURATION / step).round() as usize + 1;
    let taps =
        |compliance: f64, round_trip: f64| ringing(compliance, round_trip / step, SENT_BACK, count);
    // The ratio has to be more than nothing.
    let ratio = 0.5 * place.stiffness.max(1e-9);
    let cutting = one_blade(2.0, [ratio, 2.0 * FLAT_RADIUS], FLATS);
    let kick = Kick {
        torque: 0.0,
        force: -1.0,
        duration: PUSHED,
    };
    let responses = given([taps(TAU, 2.0), taps(AXIAL_SPEED, 2.0 / AXIAL_SPEED)], step);
    let steady = [TAU * place.speed, place.rate];
    let steps = match Drilling::steadily(&responses, &cutting, steady, kick).try_steps() {
        Ok(steps) => steps,
        // So fast that it passes its blade within a step.
        Err(SimulationError::PastABlade { .. }) => return 1.0,
        Err(error) => panic!("{error}"),
    };
    if steps
        .iter()
        .any(|now| now.speed > TOO_FAST * TAU * place.speed)
    {
        return 1.0;
    }
    let last = &steps[steps.len() - (WINDOW / step).round() as usize..];
    1.0 - last
        .iter()
        .map(|now| now.speed)
        .fold(f64::INFINITY, f64::min)
        / (TAU * place.speed)
}

/// Rows and columns of the maps of the literature; a test compares fewer, unless `MAP_SIZE` asks for
/// more.
fn size() -> usize {
    let asked = std::env::var("MAP_SIZE").ok();
    asked.map_or(7, |size| size.parse().expect("a number of rows"))
}

/// A bit sticks where the ratio is greater than this, and turns evenly where it is less than the other.
const STICKS: f64 = 0.95;
const UNEVEN: f64 = 0.1;

#[test]
fn val_maps_of_unstable_ratios() {
    for (stiffness, least) in [(0.0, 1.0), (10.0, 0.97), (20.0, 0.97), (40.0, 0.97)] {
        let places = map(stiffness, [size(); 2]);
        let stepped = parallel::map(places.len(), 1, |at| by_stepper(places[at], STEP));
        let exact = parallel::map(places.len(), 1, |at| by_delay_lines(places[at], FINE_STEP));
        let same = |limit: f64| {
            let both = stepped.iter().zip(&exact);
            let same = both.filter(|(one, other)| (**one > limit) == (**other > limit));
            same.count() as f64 / places.len() as f64
        };
        let parts = [STICKS, UNEVEN].map(same);
        println!(
            "K_a = {stiffness}: {parts:?} of {} labels agree",
            places.len()
        );
        assert!(parts[0] >= least, "{stiffness}: {parts:?}");
    }
}
