//! The operating conditions of a case: what the file says, unless an axis does.

use crate::design::Design;
use crate::quantities::Axis;
use crate::sweep_file::{BitTable, FileContent, Source, SweepFileError};

/// One turn a minute, rad/s.
pub const RPM: f64 = std::f64::consts::TAU / 60.0;

/// Operating conditions of a case, in the units of their names.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Conditions {
    /// Surface speed, rpm.
    pub surface_speed_rpm: Option<f64>,
    /// Weight on bit, kN.
    pub weight_on_bit_kn: Option<f64>,
    /// Dynamic torque, N m.
    pub torque_dynamic_nm: Option<f64>,
    /// Lateral impulse in multiples of I₀, by an axis.
    pub impulse_ratio: Option<f64>,
    /// Friction of the wall, by an axis.
    pub friction: Option<f64>,
    /// What the friction of every wall is multiplied by, whoever gives it.
    pub friction_factor: Option<f64>,
}

impl Conditions {
    /// The axes that change them.
    pub const AXES: [Axis; 5] = [
        Axis::SurfaceSpeedRpm,
        Axis::WeightOnBitKn,
        Axis::TorqueDynamicNm,
        Axis::ImpulseRatio,
        Axis::Friction,
    ];

    /// These conditions with one of them changed. Weight on bit and torque
    /// replace one another.
    pub fn with(mut self, axis: Axis, value: f64) -> Self {
        match axis {
            Axis::SurfaceSpeedRpm => self.surface_speed_rpm = Some(value),
            Axis::WeightOnBitKn => {
                self.weight_on_bit_kn = Some(value);
                self.torque_dynamic_nm = None;
            }
            Axis::TorqueDynamicNm => {
                self.torque_dynamic_nm = Some(value);
                self.weight_on_bit_kn = None;
            }
            Axis::ImpulseRatio => self.impulse_ratio = Some(value),
            Axis::Friction => self.friction = Some(value),
            // Part of the setting.
            Axis::String(_) => {}
        }
        self
    }

    /// The value along an axis, where it is known.
    pub fn value(&self, axis: Axis) -> Option<f64> {
        match axis {
            Axis::SurfaceSpeedRpm => self.surface_speed_rpm,
            Axis::WeightOnBitKn => self.weight_on_bit_kn,
            Axis::TorqueDynamicNm => self.torque_dynamic_nm,
            Axis::ImpulseRatio => self.impulse_ratio,
            Axis::Friction => self.friction,
            Axis::String(_) => None,
        }
    }

    /// Surface speed, rad/s.
    pub fn surface_speed(&self) -> Option<f64> {
        self.surface_speed_rpm.map(|speed| speed * RPM)
    }

    /// Whether every case knows its value along an axis.
    pub fn has(&self, axis: Axis, design: &Design) -> bool {
        self.value(axis).is_some() || design.axes().contains(&axis)
    }
}

/// A radian per second in rpm.
pub fn to_rpm(speed: f64) -> f64 {
    speed / RPM
}

/// What the file says of the conditions.
///
/// # Errors
/// Where a value is refused.
pub fn resolve(source: &Source, content: &FileContent) -> Result<Conditions, SweepFileError> {
    let bit = content.bit.as_ref();
    let conditions = Conditions {
        surface_speed_rpm: content.surface_speed_rpm,
        weight_on_bit_kn: bit.and_then(|bit| bit.weight_on_bit_kn),
        torque_dynamic_nm: bit.and_then(|bit| bit.torque_dynamic_nm),
        ..Conditions::default()
    };
    for (key, axis) in [
        ("surface_speed_rpm", Axis::SurfaceSpeedRpm),
        ("bit.weight_on_bit_kn", Axis::WeightOnBitKn),
        ("bit.torque_dynamic_nm", Axis::TorqueDynamicNm),
    ] {
        if let Some(value) = conditions.value(axis) {
            source.check_axis(key, axis, value)?;
        }
    }
    let has_both = conditions.weight_on_bit_kn.is_some() && conditions.torque_dynamic_nm.is_some();
    let message = "give the torque itself or a weight on bit, not both";
    source.refuse_if(has_both, "bit.torque_dynamic_nm", message)?;
    Ok(conditions)
}

/// Every case must know its surface speed and, with a bit, its torque.
///
/// # Errors
/// Names what is missing, or there twice.
pub fn are_complete(
    source: &Source,
    bit: Option<&BitTable>,
    conditions: &Conditions,
    design: &Design,
) -> Result<(), SweepFileError> {
    let has = |axis| conditions.has(axis, design);
    let message = "is needed: give a number, or make it an axis of the design";
    source.refuse_if(!has(Axis::SurfaceSpeedRpm), "surface_speed_rpm", message)?;
    let gives_torque = |axis: &&Axis| matches!(axis, Axis::WeightOnBitKn | Axis::TorqueDynamicNm);
    let mut torques = design.axes().iter().filter(gives_torque);
    let Some(bit) = bit else {
        return torques.next().map_or(Ok(()), |axis| {
            let message = format!("the axis {} needs a table [bit]", axis.name());
            Err(source.error("design", message))
        });
    };
    let has_weight = has(Axis::WeightOnBitKn);
    let message = "a weight on bit needs a rock to give a torque: \
                   `sandstone`, `shale`, `law` or `table`";
    source.refuse_if(has_weight && bit.rock.is_none(), "bit.rock", message)?;
    let message = "weight on bit and torque cannot both be axes: one gives the other";
    source.refuse_if(torques.count() > 1, "design", message)?;
    let message = "needs `torque_dynamic_nm`, or a rock and `weight_on_bit_kn`, \
                   or one of them as an axis of the design";
    source.refuse_if(!has_weight && !has(Axis::TorqueDynamicNm), "bit", message)
}
