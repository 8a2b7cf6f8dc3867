//! Stick-slip by exact waves, handed on in time.

use std::f64::consts::TAU;

use anyhow::{Context, Result, ensure};
use sim::waveguide::{Friction, Waveguide};
use sim::{BitTorque, torsion_timing};

use campaign::accuracy::bisection::{Truth, bisected, geometric};
use campaign::plan::Sweep;

/// Places of damping on the coarser of two waveguides where damping is light, and pieces, at
/// least: the bit's speed after a front falls in steps of them.
pub const USUAL_PLACES: f64 = 500.0;

/// How much finer the other is.
const FINER: f64 = 1.5;

/// Least uncertainty of the limit: what the bracket is halved to.
const HALVED: f64 = 1e-3;

/// The limit is looked for within this factor of Eq. 74's, and above it, where the bit sticks there,
/// within the square: one that has been held may stick further above.
const WITHIN: f64 = 2.0;

/// A held bit breaks loose in the first step, with any rounding.
const BROKEN_LOOSE: f64 = 1.0 + 1e-9;

/// Recaptures that make stick-slip, as in the regimes of the program.
const REPEATED: usize = 3;

/// The torque on the bit of a sweep.
///
/// # Errors
/// Where it has none.
pub fn torque(sweep: &Sweep) -> Result<BitTorque> {
    let bit = sweep.bit.as_ref().context("the sweep has no bit")?;
    let torque = bit.torque_dynamic(&sweep.conditions)?;
    let torque = torque.context("the bit has no torque")?;
    Ok(sweep.conditions.torques(torque))
}

/// The limit in rpm about that of Eq. 74, by the finer of two waveguides; what the other differs by
/// is its uncertainty.
///
/// # Errors
/// Where the string has no such limit, or the bit no torque.
pub fn truth(sweep: &Sweep, of_equation: f64, places: f64) -> Result<Truth> {
    let limit = |places: f64, bracket| limit(sweep, places, bracket);
    let usual = |places: f64| {
        let [low, high] = [of_equation / WITHIN, of_equation * WITHIN];
        limit(places, [low, high]).or_else(|_| limit(places, [low, WITHIN * high]))
    };
    let coarse = usual(places)?;
    let near = [coarse / 1.05, coarse * 1.05];
    let fine = limit(FINER * places, near).or_else(|_| usual(FINER * places))?;
    Ok(Truth {
        limit: fine,
        uncertainty: (fine / coarse - 1.0).abs() + HALVED,
    })
}

/// What two waveguides, one finer than the other, say of a surface speed (rpm): whether the bit
/// sticks and slips.
///
/// # Errors
/// Where the bit has no torque.
pub fn labels(sweep: &Sweep, rpm: f64) -> Result<[bool; 2]> {
    let of = |places| sticks_and_slips(sweep, places, rpm);
    Ok([of(USUAL_PLACES)?, of(FINER * USUAL_PLACES)?])
}

/// The limit in a bracket by a waveguide with a number of places.
fn limit(sweep: &Sweep, places: f64, [low, high]: [f64; 2]) -> Result<f64> {
    let sticks = |speed: f64| sticks_and_slips(sweep, places, speed);
    ensure!(sticks(low)? && !sticks(high)?, "there is no limit");
    let halvings = ((high / low).ln() / HALVED).log2().ceil() as usize;
    let found = bisected([low, high], true, halvings, geometric, |speed| {
        sticks(speed).ok()
    });
    found.context("there is no limit")
}

/// Whether the bit of a sweep is recaptured again and again, in the closing window too, from the
/// start of the sweep: rest, or its bit held until it breaks loose.
fn sticks_and_slips(sweep: &Sweep, places: f64, rpm: f64) -> Result<bool> {
    let (string, speed) = (&sweep.setting.string, rpm * TAU / 60.0);
    let bit = torque(sweep)?;
    let start = sweep.starts.first(&sweep.setting, speed, Some(&bit));
    let timing = torsion_timing(string, speed, &bit, &start);
    let law = Friction {
        torque_static: bit.torque_static,
        torque_dynamic: bit.torque_dynamic,
    };
    let guide = Waveguide::new(string, places, law);
    let mut guide = match start.steady() {
        None => guide,
        Some(_) => guide.wound_up(speed, BROKEN_LOOSE * bit.torque_static),
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
    Ok(last >= closing && sticks >= REPEATED)
}
