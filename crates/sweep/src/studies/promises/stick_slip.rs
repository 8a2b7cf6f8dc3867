//! The true limit of stick-slip, on the waveguide.

use std::f64::consts::TAU;

use anyhow::{Context, Result, ensure};
use linear::Drillstring;
use sim::{Start, torsion_timing};

use super::finder::Truth;
use super::problem::{Problem, TORQUE};
use super::waveguide::{Friction, Waveguide};
use crate::studies::limit::{bisected, geometric};
use campaign::plan::Sweep;

/// Places of damping on the coarser of two waveguides, and pieces, at least: the bit's speed
/// after a front falls in steps of them. More where joints are to be pieces.
const PLACES: f64 = 1000.0;
const PLACES_OF_JOINTED: f64 = 2000.0;

/// The same of families of which there are many strings.
const PLACES_OF_FAMILY: f64 = 500.0;

/// How much finer the other is.
const FINER: f64 = 1.5;

/// Least uncertainty of the limit: what the bracket is halved to.
const HALVED: f64 = 1e-3;

/// The limit is looked for within this factor of Eq. 74's.
const WITHIN: f64 = 2.0;

/// A held bit breaks loose in the first step, whatever the rounding.
const BROKEN_LOOSE: f64 = 1.0 + 1e-9;

/// Recaptures that make stick-slip, as in the regimes of the program.
const REPEATED: usize = 3;

/// The limit in rpm by the finer of two waveguides; what the other differs by is its
/// uncertainty.
pub fn truth(problem: &Problem) -> Result<Truth> {
    truth_at(problem, places)
}

/// The same where joints are pieces with damping at their ends and a few places more: many strings
/// are so long and so finely jointed that more would take hours.
pub fn truth_of_family(problem: &Problem) -> Result<Truth> {
    truth_at(problem, |_| PLACES_OF_FAMILY)
}

fn truth_at(problem: &Problem, places: impl Fn(&Drillstring) -> f64) -> Result<Truth> {
    let sweep = problem.sweep("sampling_frequency_hz = 1000\n")?;
    let guess = guess(&sweep)?;
    let places = places(&sweep.setting.string);
    let limit = |places: f64, bracket| limit(&sweep, places, bracket);
    // A bit that has been held may stick further above Eq. 74 than one from rest.
    let wide = [guess / WITHIN, guess * WITHIN * WITHIN];
    let coarse = limit(places, wide)?;
    let near = [coarse / 1.05, coarse * 1.05];
    let fine = limit(FINER * places, near).or_else(|_| limit(FINER * places, wide))?;
    Ok(Truth {
        limit: fine,
        uncertainty: (fine / coarse - 1.0).abs() + HALVED,
    })
}

/// What two waveguides, one finer than the other, say of a surface speed (rpm): whether the bit
/// sticks and slips.
pub fn labels(sweep: &Sweep, rpm: f64) -> [bool; 2] {
    let places = PLACES_OF_FAMILY;
    [places, FINER * places].map(|places| sticks_and_slips(sweep, places, rpm))
}

/// Of the coarser waveguide.
fn places(string: &Drillstring) -> f64 {
    let is_jointed = string.sections().iter().any(|section| section.repeat > 1);
    if is_jointed {
        PLACES_OF_JOINTED
    } else {
        PLACES
    }
}

/// Between the two speeds of the problem.
pub fn guess(sweep: &Sweep) -> Result<f64> {
    let values = [0, 1].map(|case| sweep.design.values(case)[0]);
    ensure!(values[0] > 0.0, "the string has no undershoot");
    Ok((values[0] * values[1]).sqrt() / 1.13)
}

/// The limit in a bracket by a waveguide with a number of places.
fn limit(sweep: &Sweep, places: f64, [low, high]: [f64; 2]) -> Result<f64> {
    let sticks = |speed: f64| Some(sticks_and_slips(sweep, places, speed));
    let (first, last) = (sticks(low), sticks(high));
    ensure!(
        first == Some(true) && last == Some(false),
        "there is no limit"
    );
    let halvings = ((high / low).ln() / HALVED).log2().ceil() as usize;
    bisected([low, high], true, halvings, geometric, sticks).context("there is no limit")
}

/// Whether the bit of a sweep is recaptured again and again, in the closing window too, from the
/// start of the sweep: rest, or its bit held until it breaks loose.
fn sticks_and_slips(sweep: &Sweep, places: f64, rpm: f64) -> bool {
    let (string, speed) = (&sweep.setting.string, rpm * TAU / 60.0);
    let bit = sweep.conditions.torques(TORQUE);
    let start = sweep.starts.first(&sweep.setting, speed, Some(&bit));
    let timing = torsion_timing(string, speed, &bit, &start);
    let law = Friction {
        torque_static: bit.torque_static,
        torque_dynamic: bit.torque_dynamic,
    };
    let guide = Waveguide::new(string, places, law);
    let mut guide = match start {
        Start::Rest => guide,
        Start::Steady(_) => guide.wound_up(speed, BROKEN_LOOSE * bit.torque_static),
    };
    let count = (timing.duration / guide.step) as usize;
    let closing = count - (timing.closing_window / guide.step) as usize;
    let (mut turns, mut sticks, mut last) = (false, 0, 0);
    for step in 0..count {
        let turned = turns;
        turns = guide.advance(speed, turned) > 0.0;
        if turned && !turns {
            sticks += 1;
        }
        if !turns && sticks > 0 {
            last = step;
        }
    }
    last >= closing && sticks >= REPEATED
}
