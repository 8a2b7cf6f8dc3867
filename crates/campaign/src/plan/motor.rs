//! `[motor]`: a mud motor between string and bit.

use std::f64::consts::TAU;

use sim::MudMotor;

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
