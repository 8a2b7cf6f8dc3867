//! Where the regime of a problem changes, by one method.

use anyhow::Result;
use sim::Stopping;

use super::problem::Problem;
use campaign::accuracy::bisection::{WITHIN, bisected, geometric, nearest};
use campaign::accuracy::is_inside;
use campaign::accuracy::trial;
use campaign::engine::{MethodSystem, Recipe};
use campaign::plan::Sweep;
use campaign::quantities::Axis;

/// What a bracket is halved to.
pub const HALVED: f64 = 3e-4;

/// Finds limits of a problem by the one method of a sweep.
pub struct Finder<'a> {
    axis: Axis,
    sweep: &'a Sweep,
    system: MethodSystem,
}

impl<'a> Finder<'a> {
    /// By the sweep's own method, for limits about `middle`.
    ///
    /// # Errors
    /// Where the method cannot treat the string.
    pub fn new(problem: &Problem, sweep: &'a Sweep, middle: f64) -> Result<Self> {
        let longest = longest(problem, sweep, middle)?;
        let system = Recipe::of(sweep, &sweep.setting, sweep.methods[0], longest).build()?;
        Ok(Self::by(problem, sweep, system))
    }

    /// By a system.
    pub fn by(problem: &Problem, sweep: &'a Sweep, system: MethodSystem) -> Self {
        let axis = problem.motion.axis();
        Self {
            axis,
            sweep,
            system,
        }
    }

    /// The limit nearest to a place, within [`WITHIN`].
    pub fn nearest(&self, place: f64) -> Option<f64> {
        nearest(place, |bracket| self.between(bracket))
    }

    /// The limit in a bracket; `None` where the regime is the same at both ends.
    pub fn between(&self, [low, high]: [f64; 2]) -> Option<f64> {
        let is_inside = |value: f64| {
            let conditions = self.sweep.conditions.with(self.axis, value);
            let outcome = trial::outcome(self.sweep, &self.system, &conditions, Stopping::Early);
            outcome.ok().map(|outcome| is_inside(&outcome))
        };
        let first = is_inside(low)?;
        if is_inside(high)? == first {
            return None;
        }
        let halvings = ((high / low).ln() / HALVED).log2().ceil() as usize;
        bisected([low, high], first, halvings, geometric, is_inside)
    }
}

/// The longest time that cases take about `middle`, s.
pub fn longest(problem: &Problem, sweep: &Sweep, middle: f64) -> Result<f64> {
    let mut longest = 0.0f64;
    for end in [middle / WITHIN, middle * WITHIN] {
        let conditions = sweep.conditions.with(problem.motion.axis(), end);
        let case = trial::case(sweep, &sweep.setting, &conditions)?;
        longest = longest.max(case.scene.timing.duration);
    }
    Ok(longest)
}
