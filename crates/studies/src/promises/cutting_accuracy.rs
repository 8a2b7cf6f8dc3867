//! Accuracies asked for above bits that cut, put to the test: near where steady drilling is lost, the limit and
//! the rates of penetration of what is chosen.
//!
//! The limit is that of the surface speed beyond which small motion grows a hundredfold in the time of a case. By
//! the chosen method it is simulated, in long cases, and compared with the exact criterion
//! ([`linear::regenerative`]). Rates of penetration are means over starts, compared with those of other starts by `held`
//! in finer steps than any that was tried.

use anyhow::{Context, Result, ensure};
use linear::Method;
use linear::waves::lattice::Lattice;
use rayon::prelude::*;
use sim::{Stopping, Trajectory};

use super::chosen;
use super::cutting::{CuttingProblem, WITHIN};
use super::cutting_limits::variation;
use super::problem::Problem;
use campaign::accuracy::bisection::{bisected, geometric};
use campaign::accuracy::trial;
use campaign::engine::{MethodSystem, Recipe};
use campaign::memory::Limit;
use campaign::plan::{Conditions, Sweep};
use campaign::quantities::Axis;

/// Accuracies asked for on every string, parts of one.
pub const ASKED_ABOVE_CUTTING: [f64; 3] = [0.2, 0.1, 0.05];

/// Cases are at speeds this part of one below and above that of the problem, in rock that is a tenth harder than
/// that in which small motion begins to grow there, and last until what grows this part as fast counts.
const APART: f64 = 0.1;
const PART_OF_GROWTH: f64 = 0.4;

/// Times of cases, s, at most and at least.
const LONGEST: f64 = 120.0;
const SHORTEST: f64 = 60.0;

/// The limit by a method is looked for within this factor of the exact one, in a number of halvings.
const NEAR: f64 = 1.5;
const HALVINGS: usize = 11;

/// What small motion grows by in the time of a case where it counts.
const GROWN: f64 = 100.0;

/// Cases in which growth is simulated last this number of times as long as those of the sweep.
const LONGER: f64 = 4.0;

/// Their disturbance at first, a part of torque and weight; a depth of cut that varies by more than the second
/// part of itself has grown, however fast that was.
const DISTURBANCE: f64 = 1e-5;
const LARGE: f64 = 1e-2;

/// Starts of the rates that others are compared with, none of which the choice has; and their steps, in pieces of
/// the lattice: no step of the choice is as short.
const STARTS: std::ops::Range<usize> = 101..117;
const PIECES: f64 = 0.4;

/// Rates of penetration of two speeds, m/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rates {
    /// The root mean square of what they are off by, a part of one.
    pub error: f64,
    /// By how much chance may have changed that.
    pub chance: f64,
}

/// What came of an accuracy that was asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct KeptAboveCutting {
    /// What was chosen.
    pub method: String,
    /// Its sampling frequency, Hz.
    pub sampling_frequency: f64,
    /// The error that was estimated, a part of one.
    pub estimated: f64,
    /// The limit by it, rpm; `None` where it is not near the exact one, or there is none.
    pub limit: Option<f64>,
    /// Rates of penetration by it.
    pub rates: Rates,
}

/// A promise above a bit that cuts.
#[derive(Debug, Clone, PartialEq)]
pub struct CuttingPromise {
    /// On which string, under which bit.
    pub problem: CuttingProblem,
    /// What was asked for, a part of one.
    pub asked: f64,
    /// The exact limit, rpm, where there is one near the cases and no other near that.
    pub exact: Option<f64>,
    /// What came of it, or why it was refused.
    pub kept: Result<KeptAboveCutting, String>,
}

impl CuttingPromise {
    /// The error of the limit, a part of one: infinite where it is not found near the exact one; `None` where
    /// there is nothing to compare.
    pub fn limit_error(&self) -> Option<f64> {
        let (kept, exact) = (self.kept.as_ref().ok()?, self.exact?);
        let error = |limit: f64| (limit / exact - 1.0).abs();
        Some(kept.limit.map_or(f64::INFINITY, error))
    }

    /// The larger error relative to what was asked for, less what chance has in it: a broken promise is above
    /// one.
    pub fn broken_by(&self) -> Option<f64> {
        let rates = self.kept.as_ref().ok()?.rates;
        let rate = (rates.error - rates.chance).max(0.0);
        Some(rate.max(self.limit_error().unwrap_or(0.0)) / self.asked)
    }
}

/// Promises on a number of strings; `done` is called after each string.
///
/// # Errors
/// Where a string cannot be drawn, or its responses cannot be built.
pub fn cutting_promises(
    strings: usize,
    seed: u64,
    limit: &Limit,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<CuttingPromise>> {
    let of_string = |number: usize| {
        let problem = CuttingProblem::draw(number, seed)?;
        let promises = promises(&problem, limit).with_context(|| format!("string {number}"));
        done();
        promises
    };
    // Each takes all threads itself, and much memory.
    let found: Vec<Result<Vec<CuttingPromise>>> = (0..strings).map(of_string).collect();
    Ok(found.into_iter().collect::<Result<Vec<_>>>()?.concat())
}

fn promises(problem: &CuttingProblem, limit: &Limit) -> Result<Vec<CuttingPromise>> {
    let Ok(hardest) = &problem.exact else {
        return Ok(Vec::new());
    };
    let time = GROWN.ln() / (PART_OF_GROWTH * hardest.growth);
    if time > LONGEST {
        return Ok(Vec::new());
    }
    let near = problem.at_speeds(WITHIN * hardest.energy, APART, time.max(SHORTEST));
    let reference = reference_rates(&near)?;
    let exact = exact_limit(&near, problem.speed)?;
    let promise = |asked: f64| {
        let kept =
            chosen(&near, asked, limit).and_then(|sweep| kept(&near, &sweep, exact, &reference));
        CuttingPromise {
            problem: problem.clone(),
            asked,
            exact,
            kept: kept.map_err(|reason| format!("{reason:#}")),
        }
    };
    Ok(ASKED_ABOVE_CUTTING.map(promise).to_vec())
}

fn kept(
    problem: &Problem,
    sweep: &Sweep,
    exact: Option<f64>,
    reference: &[Mean],
) -> Result<KeptAboveCutting> {
    let choice = sweep.choice.as_ref().context("something was chosen")?;
    let found = rates(sweep, sweep.setting.sampling_frequency, sweep.methods[0])?;
    let pairs = || found.iter().zip(reference);
    let mean = |of: &dyn Fn(&Mean, &Mean) -> f64| {
        let squares: f64 = pairs().map(|(found, other)| of(found, other).powi(2)).sum();
        (squares / reference.len() as f64).sqrt()
    };
    Ok(KeptAboveCutting {
        method: choice.chosen.method.clone(),
        sampling_frequency: choice.chosen.sampling_frequency_hz,
        estimated: choice.delivered,
        limit: exact.map_or(Ok(None), |exact| simulated_limit(problem, sweep, exact))?,
        rates: Rates {
            error: mean(&|found, other| found.value / other.value - 1.0),
            chance: mean(&|found, other| found.chance.hypot(other.chance) / other.value),
        },
    })
}

/// A mean over starts, with its standard error.
#[derive(Debug, Clone, Copy)]
struct Mean {
    value: f64,
    chance: f64,
}

/// Rates of penetration by `held` in fine steps.
fn reference_rates(problem: &Problem) -> Result<Vec<Mean>> {
    let sweep = problem.sweep("methods = [\"held\"]\n")?;
    let lattice = Lattice::new(&sweep.setting.string, &sweep.setting.sites)?;
    rates(&sweep, 1.0 / (PIECES * lattice.step), Method::Held)
}

/// The mean rates of penetration of the cases of a sweep by a method at a sampling frequency, Hz.
fn rates(sweep: &Sweep, sampling_frequency: f64, method: Method) -> Result<Vec<Mean>> {
    let setting = sweep.setting_sampled(&[], sampling_frequency)?;
    let conditions = |case: usize| sweep.conditions_at(&sweep.design.values(case));
    let cases: Vec<Conditions> = (0..sweep.design.cases()).map(conditions).collect();
    let mut longest = 0.0f64;
    for under in &cases {
        let case = trial::case(sweep, &setting, under)?;
        longest = longest.max(case.scene.timing.duration);
    }
    let system = Recipe::of(sweep, &setting, method, longest).build()?;
    cases
        .iter()
        .map(|under| rate(sweep, &system, under))
        .collect()
}

fn rate(sweep: &Sweep, system: &MethodSystem, under: &Conditions) -> Result<Mean> {
    let of_start = |number: usize| {
        let conditions = under.with(Axis::StartNumber, number as f64);
        let outcome = trial::outcome(sweep, system, &conditions, Stopping::Full)?;
        let axial = outcome.axial().context("the bit cuts")?;
        anyhow::Ok(axial.rate_of_penetration)
    };
    let values: Vec<Result<f64>> = STARTS.into_par_iter().map(of_start).collect();
    let values = values.into_iter().collect::<Result<Vec<f64>>>()?;
    let count = values.len() as f64;
    let value = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|other| (other - value).powi(2)).sum();
    let chance = (squares / (count - 1.0) / count).sqrt();
    Ok(Mean { value, chance })
}

/// Growth that counts in the cases of a sweep, 1/s.
fn growth_that_counts(sweep: &Sweep) -> Result<f64> {
    let conditions = sweep.conditions_at(&sweep.design.values(0));
    let case = trial::case(sweep, &sweep.setting, &conditions)?;
    Ok(GROWN.ln() / case.scene.timing.duration)
}

/// The exact limit about a speed, rpm; `None` where none is near, or several are.
fn exact_limit(problem: &Problem, speed: f64) -> Result<Option<f64>> {
    let sweep = problem.sweep("methods = [\"held\"]\n")?;
    let setting = &sweep.setting;
    let bit = sweep.bit.as_ref().context("there is a bit")?;
    let cutting = setting.cutting_loop()?.context("the bit cuts")?;
    let cutting = cutting.faster_than(growth_that_counts(&sweep)?);
    let grows = |speed: f64| {
        let conditions = sweep.conditions.with(Axis::SurfaceSpeedRpm, speed);
        let cut = setting.steady_drilling(bit, &conditions)?.1?;
        Some(cutting.growing(&cut)? > 0)
    };
    const PLACES: i32 = 24;
    let place = |index: i32| speed * NEAR.powf(f64::from(index) / f64::from(PLACES));
    let known: Option<Vec<bool>> = (-PLACES..=PLACES)
        .map(|index| grows(place(index)))
        .collect();
    let Some(known) = known else {
        return Ok(None);
    };
    let changes: Vec<usize> = (1..known.len())
        .filter(|index| known[*index] != known[index - 1])
        .collect();
    let [one] = changes[..] else {
        return Ok(None);
    };
    let ends = [one as i32 - 1 - PLACES, one as i32 - PLACES].map(place);
    Ok(bisected(ends, known[one - 1], HALVINGS, geometric, grows))
}

/// The same as simulated by what was chosen.
fn simulated_limit(problem: &Problem, chosen: &Sweep, exact: f64) -> Result<Option<f64>> {
    let growth = growth_that_counts(chosen)?;
    let duration = LONGER * GROWN.ln() / growth;
    let first = format!("methods = [\"held\"]\nstart_disturbance = {DISTURBANCE}\n");
    let sweep = problem.sweep(&first)?;
    let setting = sweep.setting_sampled(&[], chosen.setting.sampling_frequency)?;
    let system = Recipe::of(&sweep, &setting, chosen.methods[0], duration).build()?;
    let grows = |speed: f64| -> Result<bool> {
        let conditions = sweep.conditions.with(Axis::SurfaceSpeedRpm, speed);
        let mut case = trial::case(&sweep, &setting, &conditions)?;
        case.scene.timing.duration = duration;
        let mut motion = Trajectory::default();
        system.simulate(&case, Stopping::Full, Some(&mut motion))?;
        let depths: Vec<f64> = motion.cut.iter().map(|step| step.depth_of_cut).collect();
        let window = depths.len() / 8;
        ensure!(window > 0, "no steps were taken");
        let [early, late] = [5, 7].map(|place| variation(&depths[place * window..][..window]));
        let grown = (late / early).ln() / (duration / 4.0);
        Ok(late > LARGE || grown > growth)
    };
    let ends = [exact / NEAR, exact * NEAR];
    let [below, above] = [grows(ends[0])?, grows(ends[1])?];
    if below == above {
        return Ok(None);
    }
    Ok(bisected(ends, below, HALVINGS, geometric, |speed| {
        grows(speed).ok()
    }))
}
