//! Labels of steady drilling that begins with a disturbance, in rocks about the hardest in which it
//! lasts: by two methods at their default sampling frequency and time, against the number of roots that
//! grow, which is exact.

use anyhow::{Context, Result};
use linear::regenerative::CuttingLoop;
use rayon::prelude::*;
use sim::{Label, Motion, Stopping};

use super::cutting::{CuttingProblem, cut_in, growth, in_rock};
use super::draw::Draw;
use campaign::accuracy::trial;
use campaign::engine::Recipe;

/// Rocks of a string: each at most so far from the limit, as a natural logarithm.
const NEAR: [f64; 6] = [0.05, 0.15, 0.15, 0.5, 0.5, 1.0];

/// Random numbers of the rocks: no string has these.
const STREAM: u64 = 1 << 38;

/// A case and its labels.
#[derive(Debug, Clone, PartialEq)]
pub struct CuttingLabel {
    /// On which string, under which bit.
    pub problem: CuttingProblem,
    /// Specific energy of its rock, MPa.
    pub energy: f64,
    /// Hz.
    pub sampling_frequency: f64,
    /// The labels of axial motion and of torsion by [`linear::Method::Held`] and by finite elements; none of a
    /// case without an answer.
    pub labels: [[Option<Label>; 2]; 2],
    /// How many roots grow; none where they cannot be counted.
    pub growing: Option<usize>,
    /// By how many natural logarithms that which grows first at the limit has grown until the closing
    /// window begins; none where its root is not found.
    pub folds: Option<f64>,
}

/// A disturbance of a hundredth, the default, has grown to steady drilling itself in this number of
/// natural logarithms.
const GROWN: f64 = 4.6;

/// What small motion does in the time of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Small {
    /// It dies away.
    DiesAway,
    /// It grows, but the case is too short for a disturbance of a hundredth to stop the bit.
    GrowsSlowly,
    /// It grows to that.
    Grows,
}

impl CuttingLabel {
    /// What small motion does; `None` where that is not known.
    pub fn small(&self) -> Option<Small> {
        if self.growing? == 0 {
            return Some(Small::DiesAway);
        }
        match self.folds? {
            folds if folds >= GROWN => Some(Small::Grows),
            folds if folds > 0.0 && self.growing? <= 2 => Some(Small::GrowsSlowly),
            // It is another root that grows.
            _ => None,
        }
    }

    /// Whether both methods have the same labels; `None` where one has no answer.
    pub fn agree(&self) -> Option<bool> {
        let [held, elements] = self.labels.map(|labels| Some([labels[0]?, labels[1]?]));
        Some(held? == elements?)
    }

    /// Whether [`linear::Method::Held`] calls steady what grows, or vibration what dies away; `None` where one
    /// of both is not known.
    pub fn is_wrong(&self) -> Option<bool> {
        let vibrates = self.labels[0].map(|label| label?.is_sustained());
        let vibrates = vibrates[0]? || vibrates[1]?;
        Some(vibrates != (self.growing? > 0))
    }
}

/// Labels on a number of strings; `done` is called after each string.
///
/// # Errors
/// Where a string cannot be drawn, or its responses cannot be built.
pub fn cutting_labels(
    strings: usize,
    seed: u64,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<CuttingLabel>> {
    let of_string = |number: usize| {
        let problem = CuttingProblem::draw(number, seed)?;
        let labels = labels(&problem, &mut Draw::new(seed, STREAM + number as u64));
        done();
        labels.with_context(|| format!("string {number}"))
    };
    let numbers = (0..strings).into_par_iter().with_max_len(1);
    let found: Vec<Result<Vec<CuttingLabel>>> = numbers.map(of_string).collect();
    Ok(found.into_iter().collect::<Result<Vec<_>>>()?.concat())
}

fn labels(problem: &CuttingProblem, draw: &mut Draw) -> Result<Vec<CuttingLabel>> {
    let Ok(exact) = &problem.exact else {
        return Ok(Vec::new());
    };
    let sweep = problem
        .problem
        .sweep("methods = [\"held\", \"finite-element\"]\n")?
        .for_run()?;
    let case = trial::case(&sweep, &sweep.setting, &in_rock(&sweep, exact.energy))?;
    let timing = case.scene.timing;
    let systems = (sweep.methods.iter())
        .map(|method| Recipe::of(&sweep, &sweep.setting, *method, timing.duration).build())
        .collect::<Result<Vec<_>>>()?;
    let settings = (sweep.setting.cutting.as_ref()).context("the bit cuts")?;
    let cutting = CuttingLoop::new(&sweep.setting.string, &settings.rod)?;
    let label = |near: &f64| {
        let energy = exact.energy * (near * draw.uniform(-1.0, 1.0)).exp();
        let conditions = in_rock(&sweep, energy);
        let of_method = |place: usize| {
            let outcome = trial::outcome(&sweep, &systems[place], &conditions, Stopping::Early);
            let labels = outcome.ok().map(|outcome| outcome.labels());
            [Motion::Axial, Motion::Torsion].map(|motion| labels.and_then(|it| it[motion]))
        };
        let cut = cut_in(&sweep, energy).ok();
        let growth = cut.and_then(|cut| growth(&cutting, &cut, exact.frequency));
        CuttingLabel {
            problem: problem.clone(),
            energy,
            sampling_frequency: sweep.setting.sampling_frequency,
            labels: [0, 1].map(of_method),
            growing: cut.and_then(|cut| cutting.growing(&cut)),
            folds: growth.map(|growth| growth * (timing.duration - timing.closing_window)),
        }
    };
    Ok(NEAR.iter().map(label).collect())
}
