//! Backward whirl: Fig. 12 against softer and harder walls, at two sites, for a
//! long time.

use anyhow::Result;
use linear::Method;
use sim::diagnosis::roughness;
use sim::{LateralRegime, Outcome, SteadyWhirl, Stopping, Trajectory};

use super::families::Cell;
use super::loads;
use super::verdict::Findings;
use crate::scenes::{Loss, shipped_with};
use campaign::accuracy::trial::case;
use campaign::engine::{Case, Recipe};
use campaign::plan::{Setting, Sweep};
use campaign::quantities::Axis;
use limits::rolling_whirls;

/// Cells that differ in their wall alone.
pub fn examine(group: &[Cell], method: Method, loss: Loss) -> Result<Vec<Findings>> {
    let first = &group[0];
    let sweep = match first.site_spacing {
        Some(_) => shipped_with("two_sites.toml", loss)?,
        None => shipped_with("fig12.toml", loss)?,
    };
    let place = Axis::from_name("site_0_distance_from_bit_m").zip(first.site_spacing);
    let setting = sweep.setting_with(place.into_iter())?;
    let mut setting = setting.sampled_at(first.sampling_frequency);
    let mut duration = case(&sweep, &setting, &sweep.conditions)?
        .scene
        .timing
        .duration;
    if let Some(steps) = first.steps {
        duration = steps as f64 / first.sampling_frequency;
    }
    let system = Recipe::alone(&setting, method, false, duration).build()?;
    let worst_loads = loads::worst(&system)?;
    (group.iter())
        .map(|cell| {
            let walls = setting.lateral.iter_mut();
            for wall in walls.flat_map(|lateral| &mut lateral.walls) {
                wall.stiffness = cell.stiffness.unwrap_or(wall.stiffness);
            }
            let mut case = case(&sweep, &setting, &sweep.conditions)?;
            case.scene.timing.duration = duration;
            let mut findings = worst_loads.clone();
            let mut record = Trajectory::default();
            match system.simulate(&case, Stopping::Full, Some(&mut record)) {
                Err(error) => findings.no_answer = Some(error.to_string()),
                Ok(outcome) => {
                    let steady = steady_whirls(&sweep, &setting)?;
                    watch(&case, cell, &outcome, &record, &steady, &mut findings);
                }
            }
            Ok(findings)
        })
        .collect()
}

/// The motion in the closing window, where the bit whirls.
fn watch(
    case: &Case,
    cell: &Cell,
    outcome: &Outcome,
    record: &Trajectory,
    steady: &[SteadyWhirl],
    findings: &mut Findings,
) {
    let whirl = (outcome.lateral()).filter(|it| it.regime == LateralRegime::BackwardWhirl);
    let (Some(whirl), Some(forces)) = (whirl, record.wall_forces.last()) else {
        return;
    };
    let window = (case.scene.timing.closing_window * cell.sampling_frequency) as usize;
    let normal: Vec<f64> = (forces.iter()).map(|[x, y]| x.hypot(*y)).collect();
    let late = &normal[normal.len().saturating_sub(window)..];
    let earlier = &normal[normal.len().saturating_sub(2 * window)..normal.len() - late.len()];
    let mean = late.iter().sum::<f64>() / late.len() as f64;
    findings.chatter = Some(roughness(late) / mean);
    findings.growth = Some(roughness(late) / roughness(earlier));
    let drifts = (steady.iter()).map(|steady| whirl.mean_radius / steady.radius - 1.0);
    findings.drift = drifts.min_by(|one, other| one.abs().total_cmp(&other.abs()));
}

/// Where rolling contact at one site is steady, by the balance of forces.
fn steady_whirls(sweep: &Sweep, setting: &Setting) -> Result<Vec<SteadyWhirl>> {
    let (Some(lateral), Some(speed)) = (&setting.lateral, sweep.conditions.surface_speed()) else {
        return Ok(Vec::new());
    };
    if lateral.walls.len() > 1 {
        return Ok(Vec::new());
    }
    Ok(rolling_whirls(setting, lateral, 0, speed)?)
}
