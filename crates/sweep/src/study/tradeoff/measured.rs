//! One configuration, built, timed and measured.

use std::collections::BTreeMap;
use std::time::Instant;

use anyhow::Result;
use sim::Stopping;

use super::configuration::{Configuration, Scheme};
use super::measure::{Found, Measure, Reference};
use crate::engine::{Case, MethodSystem};
use crate::plan::Sweep;

/// A timing is the best of this many.
const REPEATS: usize = 5;

/// Timing stops after this long, s.
const LONGEST_TIMING: f64 = 0.5;

/// What the measures should be.
pub type References = BTreeMap<Measure, Reference>;

/// One configuration, measured.
pub struct Measured {
    /// Time to build the responses, s.
    pub build_seconds: f64,
    /// Time per simulated second, s, where the configuration can simulate.
    pub step_seconds: Option<f64>,
    /// What it gives.
    pub found: Vec<Found>,
}

impl Measured {
    /// What Radau quadrature gives, if its one measure is wanted: it simulates nothing.
    pub fn by_radau(build_seconds: f64, wanted: &[Measure], found: Found) -> Self {
        let is_wanted = wanted.contains(&found.measure);
        Self {
            build_seconds,
            step_seconds: None,
            found: is_wanted.then_some(found).into_iter().collect(),
        }
    }
}

/// The system of one configuration, for times up to the longest (s).
///
/// # Errors
/// Where its responses cannot be built.
pub fn build(sweep: &Sweep, configuration: &Configuration, longest: f64) -> Result<MethodSystem> {
    let Scheme::Method(method) = configuration.scheme else {
        anyhow::bail!("Radau quadrature simulates nothing");
    };
    let setting = sweep.setting.sampled_at(configuration.sampling_frequency);
    MethodSystem::build_for(sweep, &setting, method, longest)
}

/// Time to simulate a second of a case, every step of it, s: the best of some.
pub fn seconds_per_second(system: &MethodSystem, case: &Case) -> f64 {
    let begun = Instant::now();
    let mut best = f64::INFINITY;
    for _ in 0..REPEATS {
        let start = Instant::now();
        // Whether it gives an answer is seen elsewhere; it took its time.
        let _ = system.simulate(case, Stopping::Full, None);
        best = best.min(start.elapsed().as_secs_f64());
        if begun.elapsed().as_secs_f64() > LONGEST_TIMING {
            break;
        }
    }
    best / case.scene.timing.duration
}
