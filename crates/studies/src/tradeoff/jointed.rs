//! Measures of jointed pipe with collars that damps a wave little, from a bit that has been held: as
//! strings in wells are. Every joint sends waves back, so that what the bit feels next depends on
//! lengths of half a metre.

use std::collections::BTreeMap;

use anyhow::{Context, Result};
use linear::deviation::exact_undershoot;

use super::measure::Measure;
use super::part::Part;
use super::row::Reference;
use super::torsion;
use crate::scenes::{Loss, shipped_with};
use crate::stick_slip;

/// The string, with what the measures wanted should be.
///
/// # Errors
/// Where a reference cannot be computed.
pub fn part(wanted: &[Measure], loss: Loss) -> Result<Part> {
    let sweep = shipped_with("jointed_collar.toml", loss)?;
    let mut references = BTreeMap::new();
    for &measure in wanted {
        let reference = if measure == Measure::JointedUndershoot {
            Reference::exact(exact_undershoot(&sweep.setting.string)?)
        } else {
            let truth = stick_slip::true_limit(&sweep, loss)?;
            Reference {
                value: torsion::per_torque(&sweep, truth.limit).context("the bit has no torque")?,
                uncertainty: truth.uncertainty,
            }
        };
        references.insert(measure, reference);
    }
    Ok(Part {
        longest: torsion::longest_time(&sweep, stick_slip::bracket(&sweep)?)?,
        sweep,
        impulse_duration: f64::INFINITY,
        highest: f64::INFINITY,
        whole_steps_of: None,
        history: None,
        references,
        number: torsion::number,
    })
}
