//! The surface speed up to which the bit of a sweep sticks and slips.

pub mod exact;

use anyhow::{Context, Result};
use linear::Method;
use linear::deviation::exact_undershoot;
use linear::estimates::stick_slip_speed_limit;
use linear::sampling::{self, FEWEST_STEPS};
use sim::{Stopping, TorsionRegime};

use crate::scenes::Loss;
use campaign::accuracy::bisection::{Truth, limit_between, nearest};
use campaign::accuracy::trial;
use campaign::engine::{MethodSystem, Recipe};
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::records::to_rpm;
use campaign::sweep_file::AutoOr;

/// A limit is looked for between these parts of Eq. 74's.
const BRACKET: [f64; 2] = [0.5, 2.0];

/// The limit of Eq. 74 with the exact undershoot of the string, rpm.
///
/// # Errors
/// Where the bit has no torque, or the undershoot is not found.
pub fn equation_limit(sweep: &Sweep) -> Result<f64> {
    let undershoot = exact_undershoot(&sweep.setting.string)?;
    let bit = exact::torque(sweep)?;
    let limit = stick_slip_speed_limit(undershoot, bit.torque_static, bit.torque_dynamic);
    Ok(to_rpm(limit))
}

/// The exact limit, rpm, by waves that are handed on in time.
///
/// # Errors
/// Where the string has none.
pub fn exact_limit(sweep: &Sweep) -> Result<Truth> {
    exact::truth(sweep, equation_limit(sweep)?, exact::USUAL_PLACES)
}

/// Steps per travel time of two systems that limits in mud are compared with: 8 and 16 times the
/// fewest of the rule, for any string alike. No waveguide has loss that depends on
/// frequency.
pub const FINE_STEPS: [f64; 2] = [8.0 * FEWEST_STEPS, 16.0 * FEWEST_STEPS];

/// The limit, rpm: exact, or in mud by `held` in ever finer steps.
///
/// # Errors
/// Where the string has none.
pub fn true_limit(sweep: &Sweep, loss: Loss) -> Result<Truth> {
    if loss == Loss::Constants {
        return exact_limit(sweep);
    }
    let bracket = bracket(sweep)?;
    let longest = longest_time(sweep, bracket)?;
    let [coarse, fine] = FINE_STEPS.map(|steps| {
        let frequency = sampling::frequency(&sweep.setting.string, steps);
        let setting = sweep.setting.sampled_at(frequency);
        Recipe::of(sweep, &setting, Method::Held, longest).build()
    });
    let coarse = limit(sweep, &coarse?, bracket).context("there is no limit")?;
    let fine = limit_near(sweep, &fine?, coarse).context("the limit is ragged")?;
    Ok(Truth {
        limit: fine,
        uncertainty: (fine / coarse - 1.0).abs(),
    })
}

/// Where a limit is looked for about that of Eq. 74, rpm.
///
/// # Errors
/// As [`equation_limit`].
pub fn bracket(sweep: &Sweep) -> Result<[f64; 2]> {
    let of_equation = equation_limit(sweep)?;
    Ok(BRACKET.map(|part| part * of_equation))
}

/// The limit by a method's system in a bracket, rpm, each case lasting as long as its regime
/// needs; `None` where there is none.
pub fn limit(sweep: &Sweep, system: &MethodSystem, bracket: [f64; 2]) -> Option<f64> {
    limit_between(bracket, |speed| is_smooth(sweep, system, speed))
}

/// The same nearest to a place, rpm: where damping is light there are more than one.
pub fn limit_near(sweep: &Sweep, system: &MethodSystem, place: f64) -> Option<f64> {
    nearest(place, |bracket| {
        limit_between(bracket, |speed| is_smooth(sweep, system, speed))
    })
}

/// Whether the bit does not stick again and again at a surface speed, rpm.
fn is_smooth(sweep: &Sweep, system: &MethodSystem, speed: f64) -> Option<bool> {
    let sweep = until_regime_is_decided(sweep);
    let conditions = sweep.conditions.with(Axis::SurfaceSpeedRpm, speed);
    let outcome = trial::outcome(&sweep, system, &conditions, Stopping::Early).ok()?;
    Some(outcome.torsion()?.regime == TorsionRegime::Smooth)
}

/// The longest time that a case takes in a bracket (rpm), s.
///
/// # Errors
/// Where the bit has no torque.
pub fn longest_time(sweep: &Sweep, bracket: [f64; 2]) -> Result<f64> {
    let sweep = until_regime_is_decided(sweep);
    let mut longest = 0.0f64;
    for speed in bracket {
        let conditions = sweep.conditions.with(Axis::SurfaceSpeedRpm, speed);
        let case = trial::case(&sweep, &sweep.setting, &conditions)?;
        longest = longest.max(case.scene.timing.duration);
    }
    Ok(longest)
}

fn until_regime_is_decided(sweep: &Sweep) -> Sweep {
    Sweep {
        time: AutoOr::Auto,
        ..sweep.clone()
    }
}
