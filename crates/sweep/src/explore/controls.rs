//! What a page lets its reader change: what the design varies, and what else a case depends on.

use campaign::engine::{Case, unused_reason};
use campaign::plan::Sweep;
use campaign::quantities::{Axis, RockConstant, StringAxis, Units};
use campaign::sweep_file::ControllerName;
use serde::Serialize;

/// How far a slider goes from a value that no axis varies, in parts of it.
const AROUND: [f64; 2] = [0.25, 4.0];

/// A quantity with its value in the case, and the range of its slider.
#[derive(Debug, Clone, Serialize)]
pub struct Control {
    /// Its name.
    pub axis: Axis,
    /// Its name in the units that are shown.
    pub name: String,
    /// What it is, with the unit in which it is shown.
    pub title: String,
    /// That unit; empty where it has none.
    pub unit: String,
    /// How much of the unit of its name that is.
    pub size: f64,
    /// Its value, as it is shown.
    pub value: f64,
    /// The least of the slider.
    pub least: f64,
    /// The greatest.
    pub most: f64,
    /// The least and the greatest that may be asked for.
    pub lowest: f64,
    /// See `lowest`.
    pub highest: f64,
    /// Whether only whole numbers make sense.
    pub counted: bool,
    /// Whether the linear system depends on it, which takes longer than a case.
    pub of_string: bool,
}

/// The controls of a case: first what the design varies.
pub fn controls(sweep: &Sweep, case: &Case) -> Vec<Control> {
    let axes = sweep.design.axes();
    let units = sweep.content.units;
    let mut controls: Vec<Control> = (axes.iter().enumerate())
        .map(|(place, &axis)| control(axis, units, case.values[place], range_of(sweep, place)))
        .collect();
    let has_torque = |axis: &Axis| matches!(axis, Axis::WeightOnBitKn | Axis::TorqueDynamicNm);
    let varies_torque = axes.iter().any(has_torque);
    let others = [
        Axis::SurfaceSpeedRpm,
        Axis::WeightOnBitKn,
        Axis::TorqueDynamicNm,
        Axis::FeedMH,
        Axis::Rock(RockConstant::SpecificEnergy),
        Axis::Rock(RockConstant::WearFlat),
        Axis::TorqueStaticRatio,
        Axis::StringFriction,
        Axis::StringFrictionRatio,
        Axis::StringFrictionSpeed,
        Axis::String(StringAxis::TorsionalDamping),
        Axis::String(StringAxis::MudViscosity),
        Axis::String(StringAxis::LossFactor),
        Axis::FRICTION,
        Axis::ImpulseRatio,
        Axis::String(StringAxis::ProportionalGain),
        Axis::String(StringAxis::IntegralGain),
        Axis::String(StringAxis::DriveInertia),
    ];
    for axis in others {
        if axes.contains(&axis) || is_idle(sweep, axis) {
            continue;
        }
        if varies_torque && has_torque(&axis) {
            continue;
        }
        // What is zero says nothing of how far it may go.
        let Some(value) = value_of(sweep, case, axis).filter(|value| *value != 0.0) else {
            continue;
        };
        let range = AROUND.map(|part| (part * value).clamp(axis.least(), axis.most()));
        controls.push(control(axis, units, value, range));
    }
    controls
}

/// Whether a page has no use for a slider: nothing depends on it, or the bit has no such law.
fn is_idle(sweep: &Sweep, axis: Axis) -> bool {
    let cuts = sweep.setting.cutting.is_some();
    let is_of_other_bits = match axis {
        Axis::TorqueStaticRatio | Axis::TorqueDynamicNm => cuts,
        Axis::Rock(_) => !cuts,
        _ => false,
    };
    is_of_other_bits || unused_reason(sweep, axis).is_some()
}

fn control(axis: Axis, units: Units, value: f64, range: [f64; 2]) -> Control {
    let unit = axis.unit(units);
    let [least, most] = range.map(|end| unit.number(end));
    Control {
        axis,
        name: axis.name_in(units),
        title: axis.title(units),
        size: 1.0 / unit.number(1.0),
        value: unit.number(value),
        least,
        most,
        lowest: unit.number(axis.least()),
        highest: unit.number(axis.most()),
        counted: axis.is_counted(),
        of_string: axis.is_of_string(),
        unit: unit.name,
    }
}

/// From the least to the greatest value of an axis; where it has one value alone, around that.
fn range_of(sweep: &Sweep, place: usize) -> [f64; 2] {
    let values = (0..sweep.design.cases()).map(|case| sweep.design.values(case)[place]);
    let [least, most] = values.fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[least, most], value| [least.min(value), most.max(value)],
    );
    if least < most {
        [least, most]
    } else {
        AROUND.map(|part| part * least)
    }
}

/// What a case says of a quantity that no axis varies.
fn value_of(sweep: &Sweep, case: &Case, axis: Axis) -> Option<f64> {
    let content = &sweep.content;
    let drive = content.top_drive.as_ref();
    match axis {
        Axis::FRICTION => {
            let lateral = case.scene.lateral.as_ref()?;
            Some(lateral.walls.first()?.friction)
        }
        Axis::TorqueStaticRatio => content.bit.as_ref().map(|bit| bit.torque_static_ratio),
        Axis::StringFriction => content.string_friction.as_ref()?.static_coefficient,
        Axis::StringFrictionRatio => Some(content.string_friction.as_ref()?.dynamic_ratio),
        Axis::StringFrictionSpeed => Some(content.string_friction.as_ref()?.stribeck_rpm),
        Axis::ImpulseRatio => content.impulses.iter().find_map(|impulse| impulse.ratio),
        Axis::String(StringAxis::TorsionalDamping) => {
            Some(content.string.torsional_damping_nms_rad_m)
        }
        Axis::String(StringAxis::MudViscosity) => Some(content.mud?.viscosity_cp),
        Axis::String(StringAxis::LossFactor) => Some(content.string.loss_factor),
        Axis::String(StringAxis::ProportionalGain) => drive?.proportional_gain_knms_rad,
        Axis::String(StringAxis::IntegralGain) => drive?.integral_gain_knm_rad,
        Axis::String(StringAxis::DriveInertia) => {
            let drive = drive.filter(|drive| drive.controller != ControllerName::Prescribed);
            Some(drive?.inertia_kg_m2)
        }
        _ => case.conditions.value(axis),
    }
}
