//! High-frequency torsional oscillation (HFTO): vibration of the lower assembly at tens to hundreds
//! of hertz, which a torque that falls with the bit's speed feeds. Of each resonance of the bit
//! the linear criterion −T′(Ω)·Re g(f) > 1 says whether it grows, with T the torque on the bit and g
//! the response of its speed; so each has a speed below which it does.

use linear::DrillstringError;
use linear::falling_torque::{HIGHEST_FREQUENCY, Resonance, resonances};
use serde::Serialize;

use crate::axes::range_of_axis;
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::records::to_rpm;

/// A resonance of the bit, and the speed below which it grows.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BitResonance {
    /// Hz.
    pub frequency_hz: f64,
    /// Speed of the bit per torque on it, in phase there, rad/s per N m.
    pub mobility_rad_s_nm: f64,
    /// The torque on the bit may fall by this with its speed before vibration grows, N m s/rad.
    pub steepest_fall_nms_rad: f64,
    /// Below this speed it falls more steeply, by the law of the bit at the largest torque of all
    /// cases, rpm; empty where it never does, and below a motor, through which the bit feels another
    /// string.
    pub grows_below_rpm: Option<f64>,
}

/// The resonances of the bit up to 1 kHz, from the slowest on.
///
/// # Errors
/// Where the string cannot be cut up.
pub fn bit_resonances(sweep: &Sweep) -> Result<Vec<BitResonance>, DrillstringError> {
    let found = resonances(&sweep.setting.string, HIGHEST_FREQUENCY)?;
    let describe = |resonance: Resonance| BitResonance {
        frequency_hz: resonance.frequency,
        mobility_rad_s_nm: resonance.mobility,
        steepest_fall_nms_rad: resonance.steepest_fall(),
        grows_below_rpm: speed_of_growth(sweep, resonance.steepest_fall()),
    };
    Ok(found.into_iter().map(describe).collect())
}

/// The speed (rpm) at which the torque of the bit falls by this with its speed, N m s/rad, at the
/// largest torque of all cases.
fn speed_of_growth(sweep: &Sweep, fall: f64) -> Option<f64> {
    let bit = (sweep.bit.as_ref()).filter(|_| sweep.setting.motor.is_none())?;
    let mut conditions = sweep.conditions.clone();
    for (place, &axis) in sweep.design.axes().iter().enumerate() {
        if matches!(axis, Axis::WeightOnBitKn | Axis::TorqueDynamicNm) {
            let [_, greatest] = range_of_axis(sweep, place);
            conditions = conditions.with(axis, greatest);
        }
    }
    let torque = bit.torque_dynamic(&conditions).ok()??;
    conditions.torques(torque).speed_of_fall(fall).map(to_rpm)
}
