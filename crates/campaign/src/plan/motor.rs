//! `[motor]`: a mud motor between string and bit.

use std::f64::consts::TAU;

use linear::steady::rotation_speed;
use sim::MudMotor;

use super::bit::Bit;
use super::conditions::Conditions;
use super::setting::Setting;
use crate::quantities::Axis;
use crate::sweep_file::{FileContent, Source, SweepFileError};

/// The motor of a file that has one.
///
/// # Errors
/// Where a number of it is refused, or something else in the file does not go with it.
pub fn resolve(source: &Source, content: &FileContent) -> Result<Option<MudMotor>, SweepFileError> {
    let Some(table) = &content.motor else {
        return Ok(None);
    };
    let within = |key: &str, value, least, most, unit| {
        source.within(&format!("motor.{key}"), value, least, most, unit)
    };
    let rpm = TAU / 60.0;
    let speed = within("speed_rpm", table.speed_rpm, 1.0, 2000.0, "rpm")?;
    let stall_torque = within(
        "stall_torque_kn_m",
        table.stall_torque_kn_m,
        0.01,
        1e3,
        "kN m",
    )?;
    let at_stall = match table.speed_at_stall_rpm {
        None => speed,
        Some(given) => within("speed_at_stall_rpm", given, 0.0, 2000.0, "rpm")?,
    };
    let message = format!("is more than the {speed} rpm without load, of which a motor slips");
    source.refuse_if(at_stall > speed, "motor.speed_at_stall_rpm", message)?;
    let rotor_inertia = within(
        "rotor_inertia_kg_m2",
        table.rotor_inertia_kg_m2,
        0.01,
        1e3,
        "kg m²",
    )?;
    check_scene(source, content)?;
    Ok(Some(MudMotor {
        speed: rpm * speed,
        slip: rpm * (speed - at_stall) / (1e3 * stall_torque),
        stall_torque: 1e3 * stall_torque,
        rotor_inertia,
    }))
}

/// Refuses what does not go together with a motor.
fn check_scene(source: &Source, content: &FileContent) -> Result<(), SweepFileError> {
    let refusals = [
        (
            "motor",
            content.bit.is_none(),
            "needs a torque at the bit: [bit]",
        ),
        (
            "accuracy",
            content.accuracy.is_some(),
            "nothing is known of the error of a bit below a motor: give `methods` and \
             `sampling_frequency_hz` instead",
        ),
        (
            "certify",
            content.certify,
            "a label is certain far from its limit, and with a motor none is known: leave \
             it out",
        ),
    ];
    for (key, is_wrong, message) in refusals {
        source.refuse_if(is_wrong, key, message)?;
    }
    Ok(())
}

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
