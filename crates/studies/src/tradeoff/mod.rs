//! Accuracy against speed: what each configuration of each method gives for a
//! number of measures, how far that is from references that none of them made, and
//! what it costs.

mod analysis;
mod configuration;
mod history;
mod jointed;
mod lateral;
mod measure;
mod paper;
mod part;
mod row;
mod torsion;
mod tube;
mod tube_waves;

use anyhow::{Result, bail};

pub use analysis::{Cheapest, PaperRatio, cheapest, front, orders};
pub use configuration::{Configuration, configurations};
pub use measure::{Measure, MeasureSubject};
pub use paper::PaperSteps;
pub use row::{CASE_SECONDS, CASES, TradeoffRow};

use crate::scenes::Loss;
use part::Part;

/// Sampling frequencies compared, Hz.
pub const LADDER: [f64; 10] = [
    20.0, 40.0, 80.0, 160.0, 320.0, 640.0, 1280.0, 2560.0, 5120.0, 10_240.0,
];

/// Measures configurations one after the other, so that timings mean something;
/// the highest of their frequencies is a multiple of all. `tell` hears of each that
/// is done.
///
/// # Errors
/// Where a reference or a configuration cannot be built: waves of the tube are in closed form with
/// constants alone.
pub fn study(
    configurations: &[Configuration],
    wanted: &[Measure],
    loss: Loss,
    tell: &dyn Fn(),
) -> Result<Vec<TradeoffRow>> {
    let frequencies = configurations.iter().map(|one| one.sampling_frequency);
    let highest = frequencies.fold(0.0, f64::max);
    let mut parts: Vec<Part> = Vec::new();
    for subject in [
        MeasureSubject::Torsion,
        MeasureSubject::Bending,
        MeasureSubject::Tube,
        MeasureSubject::Jointed,
    ] {
        let of_subject = |measure: &Measure| measure.subject() == subject;
        let wanted: Vec<Measure> = wanted.iter().copied().filter(of_subject).collect();
        if wanted.is_empty() {
            continue;
        }
        match subject {
            MeasureSubject::Torsion => parts.push(torsion::part(&wanted, highest, loss)?),
            MeasureSubject::Bending => parts.push(lateral::part(&wanted, highest, loss)?),
            MeasureSubject::Tube if loss == Loss::Mud => bail!("the tube has no reference in mud"),
            MeasureSubject::Tube => parts.extend(tube::parts(&wanted)?),
            MeasureSubject::Jointed => parts.push(jointed::part(&wanted, loss)?),
        }
    }
    let mut rows = Vec::new();
    for configuration in configurations {
        for part in parts.iter().filter(|part| part.has(configuration)) {
            part.measure(configuration, &mut rows)?;
        }
        tell();
    }
    rows.sort_by_key(|row| row.measure);
    Ok(rows)
}
