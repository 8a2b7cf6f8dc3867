//! A bit that is held, and one that sticks and slips.

use anyhow::{Context, Result};
use linear::estimates::{torsional_settling_time, torsional_stiffness};
use linear::{Drillstring, Method, Section, Sites};
use sim::{Stopping, diagnosis};

use super::families::Cell;
use super::loads;
use super::verdict::Findings;
use crate::scenes::{Loss, shipped_with};
use campaign::accuracy::trial::outcome;
use campaign::engine::Recipe;
use campaign::plan::{Setting, Sweep};

/// The bit is held for this time, s, as long as Fig. 8(b) is simulated: every
/// wave of the paper's string has died away by half of it.
const HELD_FOR: f64 = 40.0;

/// Long strings are held until what seeps along them has settled, in its time
/// constants: four times shorter where the bit is held than where it is free.
const SETTLING_TIMES: f64 = 2.5;

/// Holds the bit, lets it stick and slip, and hangs the worst load on it.
pub fn examine(cell: &Cell, method: Method, loss: Loss) -> Result<Findings> {
    let sweep = shipped_with("fig08b.toml", loss)?;
    let setting = setting_of(&sweep, cell)?;
    let settled = SETTLING_TIMES * torsional_settling_time(&setting.string);
    let by_scene = (HELD_FOR.max(settled) * cell.sampling_frequency) as usize;
    let longest = cell.steps.unwrap_or(by_scene) as f64 / cell.sampling_frequency;
    let system = Recipe::alone(&setting, method, true, longest).build()?;
    let no_bit = "the scene has no torque at the bit";
    let held = system.stuck_torque().context(no_bit)?;
    let instant = system.driving_point().context(no_bit)?[0];
    let stiffness = torsional_stiffness(&setting.string);
    let sticking = diagnosis::sticking(held, cell.sampling_frequency, stiffness, instant);
    let mut findings = Findings {
        chatter: Some(sticking.chatter),
        growth: Some(sticking.growth),
        drift: Some(sticking.drift),
        ..loads::worst(&system)?
    };
    // Other strings have another stick-slip.
    if cell.sections.is_none() {
        match outcome(&sweep, &system, &sweep.conditions, Stopping::Full) {
            Ok(outcome) => findings.recaptures = outcome.torsion().map(|torsion| torsion.sticks),
            Err(error) => findings.no_answer = Some(error.to_string()),
        }
    }
    Ok(findings)
}

/// The scene's setting, or that of a plain row of its drillpipe.
fn setting_of(sweep: &Sweep, cell: &Cell) -> Result<Setting> {
    let mut setting = sweep.setting.sampled_at(cell.sampling_frequency);
    if let Some(repeat) = cell.sections {
        let string = &setting.string;
        let pipe = Section {
            repeat,
            ..string.sections()[0].clone()
        };
        setting.string =
            Drillstring::new(string.material(), vec![pipe], string.torsional_damping())?;
        setting.sites = Sites::bit();
    }
    Ok(setting)
}
