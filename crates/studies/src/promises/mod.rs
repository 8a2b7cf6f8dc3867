//! Promises of accuracy put to the test: random strings, to which nothing was tuned, each
//! with a limit of stick-slip or of whirl; an accuracy is asked for, and the limit by what
//! is chosen compared with one that no reference of the choice has a part in.

mod cutting;
mod cutting_accuracy;
mod cutting_labels;
mod cutting_limits;
mod default_limits;
mod draw;
mod finder;
mod growth;
mod labels;
mod problem;
mod stick_slip;
mod surroundings;
mod whirl;

use anyhow::{Context, Result};
use rayon::prelude::*;

pub use cutting::{CuttingProblem, Fed, HardestRock};
pub use cutting_accuracy::{
    ASKED_ABOVE_CUTTING, CuttingPromise, KeptAboveCutting, Rates, cutting_promises,
};
pub use cutting_labels::{CuttingLabel, Small, cutting_labels};
pub use cutting_limits::{CuttingLimit, Lengths, cutting_limits};
pub use default_limits::{Found, Wanted, default_limits};
pub use growth::{Onset, onsets_of_growth};
pub use labels::{Tested, test_labels};
pub use problem::{Begins, Motion, Problem};

pub use campaign::accuracy::bisection::Truth;
use campaign::accuracy::choose;
use campaign::memory::Limit;
use campaign::plan::Sweep;
use finder::Finder;

/// Accuracies asked for on every string, parts of one.
pub const ASKED: [f64; 3] = [0.1, 0.03, 0.01];

/// A true limit tests a promise where it is certain to this part of what was asked for.
const CERTAIN: f64 = 0.5;

/// What was promised, and what was kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// The method chosen.
    pub method: String,
    /// Its sampling frequency, Hz.
    pub sampling_frequency: f64,
    /// The error that was estimated, a part of one.
    pub estimated: f64,
    /// The limit by the method chosen; `None` where that is more than a factor
    /// [`campaign::accuracy::bisection::WITHIN`] from the true one.
    pub limit: Option<f64>,
    /// How far from its limit the furthest label of the other side was reported, a part of it; 0
    /// where none was seen.
    pub furthest_reported: Option<f64>,
    /// How far from `limit` it is, of those examined.
    pub furthest: Option<f64>,
}

/// One promise.
#[derive(Debug, Clone, PartialEq)]
pub struct Promise {
    /// On which string.
    pub problem: Problem,
    /// The true limit there, or why it is not known.
    pub truth: Result<Truth, String>,
    /// The accuracy asked for, a part of one.
    pub asked: f64,
    /// What came of it, or why it was refused.
    pub kept: Result<Kept, String>,
}

impl Promise {
    /// The error of the limit, a part of one: infinite where it is not found near the true
    /// one; `None` where there is nothing to compare.
    pub fn error(&self) -> Option<f64> {
        let (truth, kept) = (self.truth.as_ref().ok()?, self.kept.as_ref().ok()?);
        let error = |limit: f64| (limit / truth.limit - 1.0).abs();
        Some(kept.limit.map_or(f64::INFINITY, error))
    }

    /// The error relative to what was asked for, for any true limit within its uncertainty: a
    /// broken promise is above one. `None` where the true limit is not known well enough to say.
    pub fn broken_by(&self) -> Option<f64> {
        let uncertainty = self.truth.as_ref().ok()?.uncertainty;
        let broken_by = (self.error()? - uncertainty).max(0.0) / self.asked;
        (uncertainty <= CERTAIN * self.asked).then_some(broken_by)
    }
}

/// Tests all accuracies on a number of strings for each motion; `done` is called after each
/// string.
///
/// # Errors
/// Where a string cannot be drawn.
pub fn run(
    motions: &[Motion],
    strings: usize,
    seed: u64,
    limit: &Limit,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<Promise>> {
    of_each(motions, strings, done, |motion, number| {
        Ok(promises(&Problem::draw(motion, number, seed)?, limit))
    })
}

/// The results of a number of strings for each motion, one after the other.
fn of_each<Found: Clone + Send>(
    motions: &[Motion],
    strings: usize,
    done: &(dyn Fn() + Sync),
    of_string: impl Fn(Motion, usize) -> Result<Vec<Found>> + Sync,
) -> Result<Vec<Found>> {
    let numbers: Vec<(Motion, usize)> = (motions.iter())
        .flat_map(|&motion| (0..strings).map(move |number| (motion, number)))
        .collect();
    let of_number = |&(motion, number): &(Motion, usize)| {
        let found = of_string(motion, number);
        done();
        found
    };
    let found: Vec<Result<Vec<Found>>> =
        numbers.par_iter().with_max_len(1).map(of_number).collect();
    let found = found.into_iter().collect::<Result<Vec<_>>>()?;
    Ok(found.concat())
}

fn promises(problem: &Problem, limit: &Limit) -> Vec<Promise> {
    let truth = match problem.motion {
        Motion::StickSlip => stick_slip::truth(problem),
        Motion::Whirl => whirl::truth(problem),
    };
    let truth = truth.map_err(|reason| format!("{reason:#}"));
    let promise = |asked: f64| {
        let chosen = chosen(problem, asked, limit);
        let kept = chosen.and_then(|sweep| kept(problem, &sweep, truth.as_ref().ok()));
        Promise {
            problem: problem.clone(),
            truth: truth.clone(),
            asked,
            kept: kept.map_err(|reason| format!("{reason:#}")),
        }
    };
    ASKED.map(promise).to_vec()
}

/// The sweep of a problem with what is chosen for an accuracy.
fn chosen(problem: &Problem, asked: f64, limit: &Limit) -> Result<Sweep> {
    let sweep = problem.sweep(&format!("accuracy = {asked}\n"))?;
    let found = choose(&sweep, false, limit, &|_| {})?;
    let (method, choice) = found.context("an accuracy is asked for")?;
    Ok(sweep.with_choice(method, choice)?)
}

fn kept(problem: &Problem, sweep: &Sweep, truth: Option<&Truth>) -> Result<Kept> {
    let choice = sweep.choice.as_ref().context("something was chosen")?;
    let finder = truth.map(|truth| Finder::new(problem, sweep, truth.limit));
    let finder = finder.transpose()?;
    let near = finder.as_ref().zip(truth);
    let limit = near.and_then(|(finder, truth)| finder.nearest(truth.limit));
    let scanned = finder.as_ref().zip(limit);
    Ok(Kept {
        method: choice.chosen.method.clone(),
        sampling_frequency: choice.chosen.sampling_frequency_hz,
        estimated: choice.delivered,
        limit,
        furthest_reported: choice.islands.as_ref().map(|islands| islands.furthest),
        furthest: scanned.map(|(finder, limit)| finder.furthest_island(limit, choice.asked)),
    })
}
