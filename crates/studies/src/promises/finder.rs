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

/// Islands are looked for at this many distances from a limit, up to this part of it.
const SCANNED: u32 = 100;
const SCANNED_TO: f64 = 0.3;

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

    fn is_inside(&self, value: f64) -> Option<bool> {
        let conditions = self.sweep.conditions.with(self.axis, value);
        let outcome = trial::outcome(self.sweep, &self.system, &conditions, Stopping::Early);
        outcome.ok().map(|outcome| is_inside(&outcome))
    }

    /// How far from a limit the furthest label of its other side is, of some beyond a part of it, a
    /// part of the limit; 0 without any.
    pub fn furthest_island(&self, limit: f64, beyond: f64) -> f64 {
        // A bit sticks below its limit of speed, and whirls above one of friction.
        let inside = match self.axis {
            Axis::SurfaceSpeedRpm => -1.0,
            _ => 1.0,
        };
        let steps = (1..=SCANNED).map(|step| f64::from(step) / f64::from(SCANNED));
        let distances = steps.map(|part| beyond + part * (SCANNED_TO - beyond));
        let is_island = |distance: &f64| {
            [-1.0, 1.0].into_iter().any(|side| {
                let regime = self.is_inside(limit * (1.0 + side * distance));
                regime == Some(side != inside)
            })
        };
        distances.rev().find(is_island).unwrap_or(0.0)
    }

    /// The limit in a bracket; `None` where the regime is the same at both ends.
    pub fn between(&self, [low, high]: [f64; 2]) -> Option<f64> {
        let is_inside = |value: f64| self.is_inside(value);
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
