//! Where a mud motor stalls: where turning the bit steadily takes more than the stall torque of its chart.

use linear::steady::rotation_speed;

use super::bit::Bit;
use super::conditions::Conditions;
use super::setting::Setting;
use crate::quantities::Axis;

/// Halvings of a range in which the motor begins to stall.
const HALVINGS: usize = 60;

impl Setting {
    /// Whether steady rotation takes more torque than the motor can pass on: where the rotor is about to
    /// stall, the bit turns as much faster than the string as the chart says, and the rock opposes
    /// more than the stall torque there. `None` without a motor, or where conditions do not say.
    pub fn stalls_motor(&self, bit: &Bit, conditions: &Conditions) -> Option<bool> {
        let motor = self.motor?;
        if self.cutting.is_some() {
            let (steady, _) = self.steady_drilling(bit, conditions)?;
            return Some(steady.torque >= motor.stall_torque);
        }
        let torque_dynamic = bit.torque_dynamic(conditions).ok()??;
        let law = conditions.torques(torque_dynamic);
        let speed = conditions.surface_speed().unwrap_or_default();
        let speed = rotation_speed(&self.string, speed, motor.stall_torque);
        Some(law.torque_at((speed + motor.speed_at_stall()).abs()) > motor.stall_torque)
    }

    /// The value of an axis, the weight on bit or the torque, from which on the motor stalls under
    /// conditions; `None` where it does not within a range.
    pub fn motor_stalls_from(
        &self,
        (bit, conditions): (&Bit, &Conditions),
        axis: Axis,
        [from, to]: [f64; 2],
    ) -> Option<f64> {
        let stalls = |value| self.stalls_motor(bit, &conditions.with(axis, value)) == Some(true);
        if stalls(from) || !stalls(to) {
            return stalls(from).then_some(from);
        }
        let (mut low, mut high) = (from, to);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if stalls(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some(high)
    }
}
