//! Where a mud motor stalls: the weight on bit, or the torque, from which on turning the bit takes more
//! than the stall torque of its chart.

use campaign::plan::{Bit, Sweep};
use campaign::quantities::Axis;

use crate::axes::{position, range_of_axis};
use crate::torsion_limit::{StickSlipPoint, TorsionLimit};

/// Speeds at which the limit is found: it depends on them where the torque falls with speed.
const SPEEDS: usize = 17;

/// The limit is looked for from this part of the least value on.
const BELOW: f64 = 1e-3;

/// What the limit follows from.
const CHART: &str = "chart";

/// The limit over the weight on bit or the torque of a design, at each of some of its surface speeds;
/// without points where there is no motor, or it stalls nowhere within the range.
pub(crate) fn motor_stall_points(sweep: &Sweep) -> Vec<StickSlipPoint> {
    let is_torque = |axis| matches!(axis, Axis::WeightOnBitKn | Axis::TorqueDynamicNm);
    let (Some(bit), Some(place)) = (&sweep.bit, position(sweep, is_torque)) else {
        return Vec::new();
    };
    let axis = sweep.design.axes()[place];
    let speeds = match position(sweep, |axis| axis == Axis::SurfaceSpeedRpm) {
        Some(place) => range_of_axis(sweep, place),
        None => match sweep.conditions.surface_speed_rpm {
            Some(speed) => [speed; 2],
            None => return Vec::new(),
        },
    };
    let [least, most] = range_of_axis(sweep, place);
    // A limit below all of the range is said, too, where the torque is known there.
    let below = BELOW * least;
    let at_below = sweep.conditions.with(axis, below);
    let is_known = matches!(bit.torque_dynamic(&at_below), Ok(Some(_)));
    let range = [if is_known { below } else { least }, most];
    let point = |(speed, value): (f64, Option<f64>)| {
        let conditions = sweep.conditions.with(axis, value?);
        Some(StickSlipPoint {
            weight_on_bit_kn: conditions.weight_on_bit_kn,
            torque_dynamic_nm: bit.torque_dynamic(&conditions).ok()??,
            surface_speed_rpm: speed,
            method: CHART.to_owned(),
            limit: TorsionLimit::MotorStall,
        })
    };
    let stalls = motor_stalls(sweep, bit, axis, (range, speeds));
    // Where it stalls at any torque there is no limit.
    let limits = stalls.filter(|(_, value)| value.is_some_and(|value| value > range[0]));
    limits.filter_map(point).collect()
}

/// Each of some surface speeds between two (rpm), with the value of an axis from which on the motor
/// stalls there, where it does within a range; nothing without a motor, or where other axes give each
/// case its own torque.
pub fn motor_stalls<'a>(
    sweep: &'a Sweep,
    bit: &'a Bit,
    axis: Axis,
    (range, [slowest, fastest]): ([f64; 2], [f64; 2]),
) -> impl Iterator<Item = (f64, Option<f64>)> + 'a {
    let mut axes = sweep.design.axes().iter();
    let is_own = axes.any(|axis| axis.changes_bit() || *axis == Axis::TorqueDecay);
    let count = match sweep.setting.motor.is_some() && !is_own {
        false => 0,
        true if slowest < fastest => SPEEDS,
        true => 1,
    };
    (0..count).map(move |index| {
        let part = index as f64 / (SPEEDS - 1) as f64;
        let speed = slowest + (fastest - slowest) * part;
        let conditions = sweep.conditions.with(Axis::SurfaceSpeedRpm, speed);
        let setting = &sweep.setting;
        (
            speed,
            setting.motor_stalls_from((bit, &conditions), axis, range),
        )
    })
}
