//! `[top_drive]`: the drive below which the string hangs, its gains given or by a preset.

use linear::drive_delay::{growing_roots, longest_delay};
use linear::estimates::first_mode;
use linear::{Drillstring, TopDrive, controllers};

use crate::sweep_file::{ControllerName, FileContent, Source, SweepFileError, TopDriveTable};

/// The string below the drive of the file, where that has one; and the inertia (kg m²) of a
/// rotor that turns at a speed at any torque.
///
/// # Errors
/// Where a number of it is refused.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    string: Drillstring,
) -> Result<(Drillstring, f64), SweepFileError> {
    let Some(table) = &content.top_drive else {
        return Ok((string, 0.0));
    };
    let (drive, inertia) = drive(source, table, &string)?;
    let Some(drive) = drive else {
        let message = "a rotor that is held at its speed shows in the motor's torque alone, \
                       which is followed with [string_friction] or `surface_torque = true`";
        let is_idle = content.string_friction.is_none() && !content.surface_torque;
        source.refuse_if(is_idle, "top_drive.controller", message)?;
        let message = "a rotor that is at its speed at once takes an infinite torque: give \
                       `surface_speed_rise_s`, or what was recorded";
        let is_at_once =
            content.surface_speed_file.is_none() && content.surface_speed_rise_s == 0.0;
        source.refuse_if(
            is_at_once && inertia > 0.0,
            "top_drive.inertia_kg_m2",
            message,
        )?;
        return Ok((string, inertia));
    };
    let error = |error: linear::DrillstringError| source.error("top_drive", error.to_string());
    let string = string.with_top_drive(drive).map_err(error)?;
    bears_delay(source, &string)?;
    Ok((string, 0.0))
}

/// Refuses a delay below which the string grows unstable.
fn bears_delay(source: &Source, string: &Drillstring) -> Result<(), SweepFileError> {
    let key = "top_drive.delay_ms";
    let message = match source.checked(key, growing_roots(string))? {
        Some(0) => return Ok(()),
        None => "whether the string is stable below a drive with a delay is not known: it needs an inertia \
                 that is not all made up for, and a string that loses something"
            .to_owned(),
        Some(_) => match source.checked(key, longest_delay(string))? {
            Some(longest) => format!(
                "the string grows unstable below this drive, as it does from {:.3} ms on",
                1e3 * longest
            ),
            None => "the string grows unstable below this drive".to_owned(),
        },
    };
    Err(source.error(key, message))
}

/// The drive, where it gives way at all, and the inertia that its controller leaves, kg m².
fn drive(
    source: &Source,
    table: &TopDriveTable,
    string: &Drillstring,
) -> Result<(Option<TopDrive>, f64), SweepFileError> {
    let within = |key: &str, value, least, most, unit| {
        source.within(&format!("top_drive.{key}"), value, least, most, unit)
    };
    let gain = |key: &str, given: Option<f64>, unit| {
        let value = given.map(|value| within(key, value, 1e-6, 1e6, unit));
        Ok::<_, SweepFileError>(value.transpose()?.map(|value| 1e3 * value))
    };
    let inertia = within("inertia_kg_m2", table.inertia_kg_m2, 0.0, 1e6, "kg m²")?;
    let (key, given) = (
        "proportional_gain_knms_rad",
        table.proportional_gain_knms_rad,
    );
    let proportional_gain = gain(key, given, "kN m s/rad")?;
    let (key, given) = ("integral_gain_knm_rad", table.integral_gain_knm_rad);
    let integral_gain = gain(key, given, "kN m/rad")?;
    // More would make a drive of negative inertia, which is unstable on any string.
    let (key, given) = ("inertia_compensation", table.inertia_compensation);
    let compensated = given
        .map(|part| within(key, part, 0.0, 1.0, ""))
        .transpose()?;
    if let Some(limit) = table.torque_limit_kn_m {
        within("torque_limit_kn_m", limit, 1e-3, 1e6, "kN m")?;
    }
    let delay = within("delay_ms", table.delay_ms, 0.0, 1e4, "ms")?;
    let is_prescribed = table.controller == ControllerName::Prescribed;
    let message =
        "is of a controller that measures its speed: a surface that turns as prescribed has none";
    let is_idle = is_prescribed && delay > 0.0;
    source.refuse_if(is_idle, "top_drive.delay_ms", message)?;
    refuse_idle(source, table)?;
    let left = inertia * (1.0 - compensated.unwrap_or(0.0));
    let drive = match table.controller {
        ControllerName::Prescribed => return Ok((None, left)),
        ControllerName::Stiff => controllers::stiff(string, left),
        ControllerName::SoftTorque => {
            let of_mode = first_mode(string).inertia;
            let message = format!(
                "soft torque needs a drive at least as heavy as the string's first mode, \
                 {of_mode:.0} kg m², not {left:.0}: a lighter one is better matched \
                 (`controller = \"impedance-matched\"`)"
            );
            source.refuse_if(left < of_mode, "top_drive.controller", message)?;
            controllers::soft_torque(string, left)
        }
        ControllerName::ImpedanceMatched => {
            let matched = controllers::impedance_matched(string);
            TopDrive {
                inertia: inertia * (1.0 - compensated.unwrap_or(1.0)),
                integral_gain: integral_gain.unwrap_or(matched.integral_gain),
                ..matched
            }
        }
        ControllerName::Gains => {
            let required = |key: &str, value: Option<f64>| {
                let message = format!("the controller \"gains\" needs `{key}`");
                value.ok_or_else(|| source.error("top_drive.controller", message))
            };
            TopDrive {
                inertia: left,
                proportional_gain: required("proportional_gain_knms_rad", proportional_gain)?,
                integral_gain: required("integral_gain_knm_rad", integral_gain)?,
                delay: 0.0,
                late_inertia: 0.0,
            }
        }
    };
    let drive = TopDrive {
        delay: 1e-3 * delay,
        late_inertia: inertia - drive.inertia,
        ..drive
    };
    Ok((Some(drive), left))
}

/// Gains together with a preset, which has its own, would be ignored.
fn refuse_idle(source: &Source, table: &TopDriveTable) -> Result<(), SweepFileError> {
    let has_own = |controller| match controller {
        ControllerName::Gains => [false, false],
        ControllerName::ImpedanceMatched => [true, false],
        ControllerName::Prescribed | ControllerName::Stiff | ControllerName::SoftTorque => {
            [true, true]
        }
    };
    let given = [
        (
            "proportional_gain_knms_rad",
            table.proportional_gain_knms_rad,
        ),
        ("integral_gain_knm_rad", table.integral_gain_knm_rad),
    ];
    for ((key, value), has_own) in given.into_iter().zip(has_own(table.controller)) {
        let message = "this controller has its own; to give it, write `controller = \"gains\"`";
        let is_idle = has_own && value.is_some();
        source.refuse_if(is_idle, &format!("top_drive.{key}"), message)?;
    }
    Ok(())
}
