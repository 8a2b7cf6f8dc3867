//! A torque law of one's own at the bit, stepped against a string's responses:
//! what is left of Eqs. 14–18 for whoever uses this crate as a library.

use linear::TorsionResponses;

use crate::error::SimulationError;
use crate::history::{History, Kernels};
use crate::scene::{finite, not_negative};
use crate::stepper::{lasts_no_longer, steps_of, surface_steps};

/// What a step leaves open (Eq. 16): the bit's speed is
/// `free_speed + compliance × torque`, and a law says which torque.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadLine {
    /// Time of the step, s.
    pub time: f64,
    /// Speed without a torque in this step, rad/s.
    pub free_speed: f64,
    /// A(0): speed per torque within the step, rad/s per N m.
    pub compliance: f64,
}

/// The bit's speed (rad/s) in every step up to `duration` (s), the surface turning
/// at `surface_speed` (rad/s) from t = 0 on. The first torque input of the
/// responses is the bit; `law` answers every step with the torque on it (N m,
/// positive in the direction of rotation), and may keep a state of its own.
///
/// # Errors
/// Where the responses have no torque input at the bit or end before the case, or
/// the motion is not finite.
pub fn bit_speeds(
    responses: &TorsionResponses,
    surface_speed: f64,
    duration: f64,
    mut law: impl FnMut(LoadLine) -> f64,
) -> Result<Vec<f64>, SimulationError> {
    responses.check()?;
    finite("surface speed in rad/s", surface_speed)?;
    not_negative("time simulated in s", duration)?;
    lasts_no_longer(duration, responses.longest_time())?;
    let (Some(site), Some(taps)) = (responses.sites.bit_site(), responses.at_bit()) else {
        return Err(SimulationError::NoTorqueInput);
    };
    let step_length = 1.0 / responses.sampling_frequency;
    let steps = steps_of(duration, step_length);
    let surface = &surface_steps(responses)[site];
    let kernels = Kernels::new(&[vec![taps.to_vec()]]);
    let compliance = kernels.instant(0, 0);
    let mut history = History::new(&kernels, 1, steps);
    let mut speeds = Vec::with_capacity(steps);
    for step in 0..steps {
        let time = step as f64 * step_length;
        let mut past = [0.0];
        history.past(&mut past);
        let free_speed = past[0] + surface_speed * surface[step.min(surface.len() - 1)];
        let torque = law(LoadLine {
            time,
            free_speed,
            compliance,
        });
        let speed = free_speed + compliance * torque;
        if !(torque.is_finite() && speed.is_finite()) {
            return Err(SimulationError::NotFinite { site, time });
        }
        history.push(&[torque]);
        speeds.push(speed);
    }
    Ok(speeds)
}
