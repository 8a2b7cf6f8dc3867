//! Certified labels put to the test: cases near the limits of random strings, each with a
//! label that is certain or not, and what is true of it by methods that have no part in that.

use anyhow::{Context, Result};
use linear::estimates::sampling_frequency;
use sim::Stopping;

use super::draw::Draw;
use super::finder::{Finder, longest};
use super::problem::{Begins, Motion, Problem};
use super::{of_each, stick_slip, whirl};
use crate::stick_slip::exact;
use campaign::accuracy::is_inside;
use campaign::accuracy::trial;
use campaign::engine::{self, MethodSystem, Recipe, RunOptions};
use campaign::plan::Sweep;
use campaign::records::{Record, certified};

/// Cases of a string: each at most so far from its limit, as a natural logarithm.
const NEAR: [f64; 6] = [0.02, 0.05, 0.05, 0.15, 0.15, 0.3];

/// And this number in torsion, anywhere between these parts of Eq. 74's limit.
const ANYWHERE: usize = 3;
const PARTS_OF_LIMIT: [f64; 2] = [0.33, 1.5];

/// Where the limit of whirl is about, coefficient of friction, if it is not found.
const USUAL_FRICTION: f64 = 1.4;

/// An impulse of 20 ms has four samples from this sampling frequency on, Hz: a string of which
/// the rule has a lower one is sampled at that.
const LEAST_OF_IMPULSES: f64 = 200.0;

/// Random numbers of the cases: no string has these.
const STREAM: u64 = 1 << 32;

/// A case and its label.
#[derive(Debug, Clone, PartialEq)]
pub struct Tested {
    /// On which string.
    pub problem: Problem,
    /// Sampling frequency, Hz; the label is certified in shorter steps, too.
    pub sampling_frequency: f64,
    /// Surface speed in rpm, or coefficient of friction.
    pub value: f64,
    /// Whether the motion is sustained vibration by [`linear::Method::Held`].
    pub label: bool,
    /// Whether that is certain.
    pub is_certain: bool,
    /// Whether it is in truth; `None` where those that say so differ.
    pub truth: Option<bool>,
}

impl Tested {
    /// Whether the label is wrong, where that is known.
    pub fn is_wrong(&self) -> Option<bool> {
        self.truth.map(|truth| truth != self.label)
    }
}

/// Tests the labels of cases of a number of strings for each motion; `done` is called after each
/// string.
///
/// # Errors
/// Where a string cannot be drawn, or its responses cannot be built.
pub fn test_labels(
    (motions, begins): (&[Motion], Begins),
    strings: usize,
    seed: u64,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<Tested>> {
    of_each(motions, strings, done, |motion, number| {
        let problem = match motion {
            Motion::StickSlip => Problem::draw_family(number, seed, begins)?,
            Motion::Whirl => Problem::draw(motion, number, seed)?,
        };
        let stream = STREAM + 2 * number as u64 + u64::from(motion == Motion::Whirl);
        of_string(&problem, &mut Draw::new(seed, stream))
            .with_context(|| format!("{} of string {number}", motion.name()))
    })
}

fn of_string(problem: &Problem, draw: &mut Draw) -> Result<Vec<Tested>> {
    let given = match problem.motion {
        // As a file has it that gives none.
        Motion::StickSlip => String::new(),
        Motion::Whirl => {
            let sweep = problem.sweep("sampling_frequency_hz = 1000\n")?;
            let of_cell = sampling_frequency(&sweep.setting.string);
            let frequency = of_cell.max(LEAST_OF_IMPULSES);
            format!("sampling_frequency_hz = {frequency}\n")
        }
    };
    let sweep = problem.sweep(&format!(
        "methods = [\"held\", \"finite-element\"]\ncertify = true\n{given}"
    ))?;
    let sweep = sweep.for_run()?;
    let middle = middle(problem, &sweep)?;
    let limit = limit(problem, &sweep, middle)?;
    let longest = longest(problem, &sweep, limit)?;
    let systems = (sweep.methods.iter().enumerate())
        .map(|(place, method)| {
            let system = Recipe::of(&sweep, &sweep.setting, *method, longest).build()?;
            system.with_finer(&sweep, place, longest)
        })
        .collect::<Result<Vec<_>>>()?;
    let judges = judges(problem, longest)?;
    let mut tested = Vec::new();
    let mut values: Vec<f64> = (NEAR.iter())
        .map(|near| limit * (near * draw.uniform(-1.0, 1.0)).exp())
        .collect();
    if problem.motion == Motion::StickSlip {
        let [least, most] = PARTS_OF_LIMIT.map(|part| part * middle);
        values.extend((0..ANYWHERE).map(|_| draw.uniform(least, most)));
    }
    for value in values {
        let conditions = sweep.conditions.with(problem.motion.axis(), value);
        let case = trial::case(&sweep, &sweep.setting, &conditions)?;
        let answer = |(place, system): (usize, &MethodSystem)| {
            engine::answer(system, &case, place, RunOptions::default(), &sweep)
        };
        let records: Vec<Record> = systems.iter().enumerate().map(answer).collect();
        // Of a case without an answer there is no label.
        let Ok(outcome) = &records[0].outcome else {
            continue;
        };
        let certified = certified(&records, [0, 1]);
        let mut said = judges
            .iter()
            .map(|(sweep, system)| {
                let outcome = trial::outcome(sweep, system, &conditions, Stopping::Early);
                outcome.ok().map(|outcome| is_inside(&outcome))
            })
            .collect::<Vec<_>>();
        if problem.motion == Motion::StickSlip {
            said.extend(exact::labels(&sweep, value)?.map(Some));
        }
        tested.push(Tested {
            problem: problem.clone(),
            sampling_frequency: sweep.setting.sampling_frequency,
            value,
            label: is_inside(outcome),
            is_certain: match problem.motion {
                Motion::StickSlip => certified.labels[sim::Motion::Torsion].is_some(),
                Motion::Whirl => certified.labels[sim::Motion::Lateral].is_some(),
            },
            truth: (said[0]).filter(|first| said.iter().all(|other| *other == Some(*first))),
        });
    }
    Ok(tested)
}

/// Where the limit is about: in torsion that of Eq. 74.
fn middle(problem: &Problem, sweep: &Sweep) -> Result<f64> {
    match problem.motion {
        Motion::StickSlip => stick_slip::guess(sweep),
        Motion::Whirl => Ok(USUAL_FRICTION),
    }
}

/// Where the limit is by [`linear::Method::Held`] in steps of the rule, about which cases are drawn.
fn limit(problem: &Problem, sweep: &Sweep, middle: f64) -> Result<f64> {
    let finder = Finder::new(problem, sweep, middle)?;
    let found = match problem.motion {
        Motion::StickSlip => finder.nearest(middle),
        Motion::Whirl => finder.between(whirl::BRACKET),
    };
    Ok(found.unwrap_or(middle))
}

/// Systems that say what is true, where they agree: with a wall those of the true limit of
/// whirl; in torsion alone no system of the program, but two waveguides that share no code with
/// it.
fn judges(problem: &Problem, longest: f64) -> Result<Vec<(Sweep, MethodSystem)>> {
    match problem.motion {
        Motion::StickSlip => Ok(Vec::new()),
        Motion::Whirl => (whirl::FREQUENCIES.iter())
            .map(|frequency| {
                let sweep = problem.sweep(&format!("sampling_frequency_hz = {frequency}\n"))?;
                let system = whirl::system(&sweep, longest)?;
                Ok((sweep, system))
            })
            .collect(),
    }
}
