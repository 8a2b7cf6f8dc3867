//! Accuracy against speed: what each configuration of each method gives for a
//! dozen measures, how far that is from references that none of them made, and
//! what it costs.

mod analysis;
mod configuration;
mod history;
mod lateral;
mod limit;
mod measure;
mod measured;
mod paper;
mod row;
mod torsion;

use anyhow::{Context, Result};

pub use analysis::{Cheapest, PaperRatio, cheapest, front, orders};
pub use configuration::{Configuration, configurations};
pub use measure::Measure;
pub use paper::PaperSteps;
pub use row::{CASE_SECONDS, CASES, Row};

use configuration::Scheme;
use lateral::Lateral;
use measured::{Measured, References};
use torsion::Torsion;

/// Sampling frequencies compared, Hz.
pub const LADDER: [f64; 10] = [
    20.0, 40.0, 80.0, 160.0, 320.0, 640.0, 1280.0, 2560.0, 5120.0, 10_240.0,
];

/// A step of Radau quadrature sums over the past four times, from both stages to
/// both.
const RADAU_SUMS: f64 = 4.0;

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
