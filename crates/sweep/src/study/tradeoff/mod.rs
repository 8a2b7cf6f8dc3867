//! Accuracy against speed: what each configuration of each method gives for a
//! dozen measures, how far that is from references that none of them made, and
//! what it costs.

mod analysis;
mod configuration;
mod history;
mod lateral;
mod limit;
mod measure;
mod paper;
mod torsion;

use std::collections::BTreeMap;
use std::time::Instant;

use anyhow::{Context, Result};
use sim::Stopping;

pub use analysis::{Cheapest, PaperRatio, cheapest, front, orders};
pub use configuration::{Configuration, configurations};
pub use measure::{Measure, Reference};
pub use paper::PaperSteps;

use crate::engine::{Case, MethodSystem};
use crate::plan::Sweep;
use configuration::Scheme;
use lateral::Lateral;
use measure::Found;
use torsion::Torsion;

/// Sampling frequencies compared, Hz.
pub const LADDER: [f64; 10] = [
    20.0, 40.0, 80.0, 160.0, 320.0, 640.0, 1280.0, 2560.0, 5120.0, 10_240.0,
];

/// The sweep that costs are told for: cases, and seconds simulated of each.
pub const CASES: f64 = 1000.0;
/// Seconds simulated of each case.
pub const CASE_SECONDS: f64 = 10.0;

/// A step of Radau quadrature sums over the past four times, from both stages to
/// both.
const RADAU_SUMS: f64 = 4.0;

/// A timing is the best of this many.
const REPEATS: usize = 5;

/// Timing stops after this long, s.
const LONGEST_TIMING: f64 = 0.5;

/// What the measures should be.
type References = BTreeMap<Measure, Reference>;

/// One configuration, measured.
struct Measured {
    build_seconds: f64,
    /// Time per simulated second, s, where the configuration can simulate.
    step_seconds: Option<f64>,
    found: Vec<Found>,
}

impl Measured {
    /// What Radau quadrature gives, if its one measure is wanted: it simulates nothing.
    fn by_radau(build_seconds: f64, wanted: &[Measure], found: Found) -> Self {
        let is_wanted = wanted.contains(&found.measure);
        Self {
            build_seconds,
            step_seconds: None,
            found: is_wanted.then_some(found).into_iter().collect(),
        }
    }
}

/// One configuration and one measure.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Which measure.
    pub measure: Measure,
    /// Which configuration.
    pub configuration: Configuration,
    /// Its value, where it is one number.
    pub value: Option<f64>,
    /// What it should be.
    pub reference: Reference,
    /// Its relative error; `None` where there is no answer.
    pub error: Option<f64>,
    /// Time to build the responses, s.
    pub build_seconds: f64,
    /// Time per simulated second, s.
    pub step_seconds: f64,
}

impl Row {
    /// Time for a sweep of [`CASES`] cases on one core, build included, s.
    pub fn cost(&self) -> f64 {
        cost(self.build_seconds, self.step_seconds)
    }
}

/// Time for a sweep of [`CASES`] cases on one core, s.
fn cost(build_seconds: f64, step_seconds: f64) -> f64 {
    build_seconds + CASES * CASE_SECONDS * step_seconds
}

/// Measures configurations one after the other, so that timings mean something;
/// the highest of their frequencies is a multiple of all. `tell` hears of each that
/// is done.
///
/// # Errors
/// Where a reference or a configuration cannot be built.
pub fn study(
    configurations: &[Configuration],
    wanted: &[Measure],
    tell: &dyn Fn(),
) -> Result<Vec<Row>> {
    let frequencies = configurations.iter().map(|one| one.sampling_frequency);
    let highest = frequencies.fold(0.0, f64::max);
    let (lateral, torsion): (Vec<Measure>, Vec<Measure>) =
        wanted.iter().partition(|measure| measure.is_lateral());
    let torsion = (!torsion.is_empty())
        .then(|| Torsion::new(&torsion, highest))
        .transpose()?;
    let lateral = (!lateral.is_empty())
        .then(|| Lateral::new(&lateral, highest))
        .transpose()?;
    let mut rows = Vec::new();
    for configuration in configurations {
        if let Some(torsion) = &torsion {
            let measured = torsion.measure(configuration, wanted)?;
            add_rows(&mut rows, configuration, measured, &torsion.references)?;
        }
        if let Some(lateral) = lateral
            .as_ref()
            .filter(|lateral| lateral.has(configuration))
        {
            let measured = lateral.measure(configuration, wanted)?;
            add_rows(&mut rows, configuration, measured, &lateral.references)?;
        }
        tell();
    }
    rows.sort_by_key(|row| row.measure);
    Ok(rows)
}

fn add_rows(
    rows: &mut Vec<Row>,
    configuration: &Configuration,
    measured: Measured,
    references: &References,
) -> Result<()> {
    for found in measured.found {
        let step_seconds = match measured.step_seconds {
            Some(seconds) => seconds,
            None => RADAU_SUMS * quadrature_step(rows, found.measure, configuration)?,
        };
        rows.push(Row {
            measure: found.measure,
            configuration: *configuration,
            value: found.value,
            reference: references[&found.measure],
            error: found.error,
            build_seconds: measured.build_seconds,
            step_seconds,
        });
    }
    Ok(())
}

/// Time per simulated second of quadrature at the same frequency, s.
fn quadrature_step(rows: &[Row], measure: Measure, like: &Configuration) -> Result<f64> {
    let quadrature = rows.iter().find(|row| {
        row.measure == measure
            && row.configuration.scheme == Scheme::Method(linear::Method::Quadrature)
            && row.configuration.sampling_frequency == like.sampling_frequency
    });
    quadrature
        .map(|row| row.step_seconds)
        .context("quadrature is measured first")
}

/// The system of one configuration, for times up to the longest (s).
fn build(sweep: &Sweep, configuration: &Configuration, longest: f64) -> Result<MethodSystem> {
    let Scheme::Method(method) = configuration.scheme else {
        anyhow::bail!("Radau quadrature simulates nothing");
    };
    let mut sweep = sweep.clone();
    sweep.methods = vec![method];
    sweep.setting.sampling_frequency = configuration.sampling_frequency;
    let systems = MethodSystem::build_all(&sweep, &sweep.setting, longest)?;
    systems
        .into_iter()
        .next()
        .context("one method is one system")
}

/// Time to simulate a second of a case, every step of it, s: the best of some.
fn seconds_per_second(system: &MethodSystem, case: &Case) -> f64 {
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
