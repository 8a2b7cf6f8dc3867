//! The worst load of a system: what its margins say, and what an oscillator tuned to
//! where they are smallest gains.

use anyhow::{Context, Result};
use sim::oscillator::worst_load_gain;

use super::verdict::Findings;
use campaign::engine::MethodSystem;

/// The margins of a system, and what its worst loads gain.
///
/// # Errors
/// Where it has no responses in torsion.
pub fn worst(system: &MethodSystem) -> Result<Findings> {
    let torsion = (system.responses.torsion()).context("there are no responses in torsion")?;
    let torsion = worst_load_gain(&torsion.driving_points())?;
    let mut findings = Findings {
        margin_torsion: system.torsion_margin,
        energy_gained: Some(torsion),
        ..Findings::default()
    };
    if let Some(velocities) = system.responses.velocities() {
        let taps: Vec<Vec<&[f64]>> = (velocities.iter())
            .map(|inputs| inputs.iter().map(Vec::as_slice).collect())
            .collect();
        findings.margin_bending = system.bending_margin;
        findings.energy_gained = Some(torsion.max(worst_load_gain(&taps)?));
        findings.margin_wall = system.responses.margin_of_differences()?;
    }
    Ok(findings)
}
