//! The one-slip estimate of stick-slip (Eq. 74) along the torque or the weight on bit.

use linear::estimates::stick_slip_speed_limit;

use crate::plan::{Bit, Conditions, TorqueError};

use crate::quantities::Axis;
use crate::records::to_rpm;

/// Where the limit is at one value of its axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LimitPoint {
    /// The value.
    pub value: f64,
    /// Weight on bit, kN, where one makes the torque.
    pub weight_on_bit_kn: Option<f64>,
    /// T_d, N m.
    pub torque_dynamic_nm: f64,
    /// Surface speed below which a bit that slips once from even rotation sticks again, rpm.
    pub surface_speed_rpm: f64,
}

/// The limit at values of an axis under conditions that are the same otherwise, by the undershoot
/// Δ of a string, rad/s per N m; values that make no torque have none.
///
/// # Errors
/// Where a rock gives no torque for a weight on bit.
pub fn stick_slip_limit(
    (bit, conditions): (&Bit, &Conditions),
    (axis, values): (Axis, impl Iterator<Item = f64>),
    undershoot: f64,
) -> Result<Vec<LimitPoint>, TorqueError> {
    let at = |value| {
        let conditions = conditions.with(axis, value);
        let Some(torque) = bit.torque_dynamic(&conditions)? else {
            return Ok(None);
        };
        let torques = conditions.torques(torque);
        let limit =
            stick_slip_speed_limit(undershoot, torques.torque_static, torques.torque_dynamic);
        Ok(Some(LimitPoint {
            value,
            weight_on_bit_kn: conditions.weight_on_bit_kn,
            torque_dynamic_nm: torque,
            surface_speed_rpm: to_rpm(limit),
        }))
    };
    values.filter_map(|value| at(value).transpose()).collect()
}
