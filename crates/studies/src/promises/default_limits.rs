//! The limit of stick-slip at the sampling frequency that a sweep file gets if it gives none:
//! on random strings of every family, against exact waves; or on such strings in viscous mud, of a
//! material with loss, against `held` in steps so short that shorter ones change nothing.
//!
//! Limits of strings that damp a wave little are ragged: next to them are islands of the other
//! regime. The exact limit is where the coarser of two waveguides, halving a bracket about
//! Eq. 74's limit, sees the regime change, and the finer one nearest to that; where these two
//! differ by more than [`CERTAIN`] the string tests nothing. A method's limit is its change of
//! regime nearest to the exact one.

use anyhow::{Context, Result};
use linear::Method;
use linear::estimates::{sampling_frequency, torsional_travel_time};
use linear::sampling;
use linear::waves::lattice::Lattice;

use super::finder::{Finder, HALVED, longest};
use super::problem::{Begins, Motion, Problem};
use super::{of_each, stick_slip};
use crate::stick_slip::FINE_STEPS;
use campaign::accuracy::bisection::Truth;
use campaign::engine::Recipe;
use campaign::plan::{Setting, Sweep};

/// An exact limit tests others where it is known to this part of itself.
const CERTAIN: f64 = 0.025;

/// The coarser of them looks for the limit within this factor of Eq. 74's, and above it, where the
/// bit sticks there, within the square: as on waveguides.
const ABOUT: f64 = 2.0;

/// How the sampling frequency was chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rule {
    /// The program's own.
    Default,
    /// One step a piece of the string's lattice: no front is rounded off.
    OnePiece,
    /// The paper's: four times the first mode of one cell of the drillpipe.
    OneCell,
}

impl Rule {
    /// The word in the table.
    pub fn name(self) -> &'static str {
        match self {
            Rule::Default => "default",
            Rule::OnePiece => "one-piece",
            Rule::OneCell => "one-cell",
        }
    }
}

/// A limit by a method.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// On which string.
    pub problem: Problem,
    /// The exact limit there, or why it is not known.
    pub truth: Result<Truth, String>,
    /// The method.
    pub method: &'static str,
    /// How its sampling frequency was chosen,
    pub rule: Rule,
    /// Hz,
    pub sampling_frequency: f64,
    /// and in steps per travel time of a wave from the surface to the bit.
    pub steps_per_travel: f64,
    /// The limit, rpm; `None` where there is none near the exact one.
    pub limit: Option<f64>,
}

impl Found {
    /// What the exact limit is by, a word in the table.
    pub fn reference(&self) -> &'static str {
        match self.problem.surroundings {
            None => "waveguide",
            Some(_) => "held-in-fine-steps",
        }
    }

    /// The error of the limit, a part of one, with its sign: infinite where it is not near the
    /// exact one; `None` where that is not known.
    pub fn error(&self) -> Option<f64> {
        let truth = self.truth.as_ref().ok()?;
        let error = |limit: f64| limit / truth.limit - 1.0;
        let is_known = truth.uncertainty <= CERTAIN;
        is_known.then(|| self.limit.map_or(f64::INFINITY, error))
    }
}

/// Which limits are wanted.
#[derive(Debug, Clone, Copy)]
pub struct Wanted<'a> {
    /// By which methods.
    pub methods: &'a [Method],
    /// From which motion.
    pub begins: Begins,
    /// Of strings in viscous mud, of a material with loss.
    pub in_mud: bool,
}

impl Wanted<'_> {
    fn draw(&self, number: usize, seed: u64) -> Result<Problem> {
        if self.in_mud {
            return Problem::draw_in_mud(number, seed, self.begins);
        }
        Problem::draw_family(number, seed, self.begins)
    }

    fn truth(&self, problem: &Problem) -> Result<Truth> {
        if self.in_mud {
            return in_fine_steps(problem);
        }
        stick_slip::truth_of_family(problem)
    }
}

/// Limits on a number of strings; `known` gives exact limits that have been found before, and
/// `done` is called after each string.
///
/// # Errors
/// Where a string cannot be drawn, or its responses cannot be built.
pub fn default_limits(
    wanted: Wanted,
    strings: usize,
    seed: u64,
    known: &(dyn Fn(usize) -> Option<Result<Truth, String>> + Sync),
    done: &(dyn Fn() + Sync),
) -> Result<Vec<Found>> {
    of_each(&[Motion::StickSlip], strings, done, |_, number| {
        let problem = wanted.draw(number, seed)?;
        let truth = known(number)
            .unwrap_or_else(|| (wanted.truth(&problem)).map_err(|reason| format!("{reason:#}")));
        let found = wanted.methods.iter().flat_map(|method| {
            let rules: &[Rule] = match method {
                Method::Held => &[Rule::Default, Rule::OnePiece, Rule::OneCell],
                // They would take minutes in such steps, and smear fronts all the same.
                _ => &[Rule::Default, Rule::OneCell],
            };
            let of_rule = |rule: &Rule| found(&problem, &truth, *method, *rule);
            rules.iter().map(of_rule).collect::<Vec<_>>()
        });
        let found: Result<Vec<Found>> = found.collect();
        found.with_context(|| format!("string {number}"))
    })
}

/// The limit by `held` in the shorter of two steps; what it differs by in the other is its
/// uncertainty.
fn in_fine_steps(problem: &Problem) -> Result<Truth> {
    let sweep = problem.sweep(&format!("methods = [\"{}\"]\n", Method::Held.name()))?;
    let guess = stick_slip::guess(&sweep)?;
    let low = guess / ABOUT;
    let at = |steps| {
        let frequency = sampling::frequency(&sweep.setting.string, steps);
        finder(problem, &sweep, &sweep.setting.sampled_at(frequency), low)
    };
    let ([coarse, fine], high) = (FINE_STEPS, guess * ABOUT);
    let coarse = at(coarse)?;
    let one = (coarse.between([low, high])).or_else(|| coarse.between([low, high * ABOUT]));
    let one = one.context("there is no limit")?;
    let other = at(fine)?.nearest(one).context("the limit is ragged")?;
    Ok(Truth {
        limit: other,
        uncertainty: (other / one - 1.0).abs() + HALVED,
    })
}

fn found(
    problem: &Problem,
    truth: &Result<Truth, String>,
    method: Method,
    rule: Rule,
) -> Result<Found> {
    let mut found = Found {
        problem: problem.clone(),
        truth: truth.clone(),
        method: method.name(),
        rule,
        sampling_frequency: 0.0,
        steps_per_travel: 0.0,
        limit: None,
    };
    // A string without an undershoot has no sweep file either.
    let Ok(truth) = truth else {
        return Ok(found);
    };
    let sweep = problem.sweep(&format!("methods = [\"{}\"]\n", method.name()))?;
    let setting = match rule {
        Rule::Default => sweep.setting.clone(),
        Rule::OnePiece => {
            let lattice = Lattice::new(&sweep.setting.string, &sweep.setting.sites)?;
            sweep.setting.sampled_at(lattice.step.recip())
        }
        Rule::OneCell => sweep
            .setting
            .sampled_at(sampling_frequency(&sweep.setting.string)),
    };
    found.sampling_frequency = setting.sampling_frequency;
    found.steps_per_travel = setting.sampling_frequency * torsional_travel_time(&setting.string);
    found.limit = finder(problem, &sweep, &setting, truth.limit)?.nearest(truth.limit);
    Ok(found)
}

/// Finds limits of the sweep's method in a setting, about `middle` (rpm).
fn finder<'a>(
    problem: &Problem,
    sweep: &'a Sweep,
    setting: &Setting,
    middle: f64,
) -> Result<Finder<'a>> {
    let longest = longest(problem, sweep, middle)?;
    let system = Recipe::of(sweep, setting, sweep.methods[0], longest).build()?;
    Ok(Finder::by(problem, sweep, system))
}
