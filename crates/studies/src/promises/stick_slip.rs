//! The true limit of stick-slip, on the waveguide.

use anyhow::{Result, ensure};
use linear::Drillstring;

use super::problem::Problem;
use crate::stick_slip::exact::{self, USUAL_PLACES};
use campaign::accuracy::bisection::Truth;
use campaign::plan::Sweep;

/// Places of damping on the coarser of two waveguides, and pieces, at least. More where joints are
/// to be pieces.
const PLACES: f64 = 1000.0;
const PLACES_OF_JOINTED: f64 = 2000.0;

/// The limit in rpm by the finer of two waveguides; what the other differs by is its
/// uncertainty.
pub fn truth(problem: &Problem) -> Result<Truth> {
    truth_at(problem, places)
}

/// The same where joints are pieces with damping at their ends and a few places more: many strings
/// are so long and so finely jointed that more would take hours.
pub fn truth_of_family(problem: &Problem) -> Result<Truth> {
    truth_at(problem, |_| USUAL_PLACES)
}

fn truth_at(problem: &Problem, places: impl Fn(&Drillstring) -> f64) -> Result<Truth> {
    let sweep = problem.sweep("sampling_frequency_hz = 1000\n")?;
    let places = places(&sweep.setting.string);
    exact::truth(&sweep, guess(&sweep)?, places)
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
