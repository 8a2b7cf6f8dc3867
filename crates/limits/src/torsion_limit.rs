//! Points of limits of torsion, and of steady drilling, as `boundary.csv` has them.

use campaign::quantities::Axis;
use serde::Deserialize;

/// What limits of small motion are computed by.
pub(crate) const WAVES: &str = "waves";

/// The limit of a mud motor in legends.
pub(crate) const MOTOR_STALLS: &str = "the mud motor stalls from here on";

/// Which limit of torsion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TorsionLimit {
    /// One-slip estimate of stick-slip (Eq. 74): below it a bit that turns evenly sticks again after one
    /// drop of torque. No limit of stick-slip, which may last above it and die away below.
    #[default]
    StickSlip,
    /// Below it smooth rotation does not last, as the torque on the bit falls too steeply with its
    /// speed.
    SmoothRotation,
    /// Where steady drilling with blades that cut what they leave is about to grow.
    SteadyDrilling,
    /// From this weight or torque on the mud motor above the bit stalls in steady rotation.
    MotorStall,
}

impl TorsionLimit {
    /// The word in the table.
    pub(crate) fn name(self) -> &'static str {
        match self {
            TorsionLimit::StickSlip => "stick_slip",
            TorsionLimit::SmoothRotation => "smooth_rotation",
            TorsionLimit::SteadyDrilling => "steady_drilling",
            TorsionLimit::MotorStall => "motor_stall",
        }
    }
}

/// One point of a limit of torsion.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct StickSlipPoint {
    /// Weight on bit, kN; empty where the design varies the torque itself.
    pub weight_on_bit_kn: Option<f64>,
    /// T_d, N m.
    pub torque_dynamic_nm: f64,
    /// The limit, rpm; of a motor that stalls, where the limit is the weight or the torque, the speed
    /// at which it is that.
    pub surface_speed_rpm: f64,
    /// The method whose Δ is used; of smooth rotation, the exact waves; of a motor, its chart.
    pub method: String,
    /// Which limit; of earlier versions, that of stick-slip.
    #[serde(default)]
    pub limit: TorsionLimit,
}

impl StickSlipPoint {
    /// Its place along an axis, of the weight on bit or of the torque.
    pub fn along(&self, axis: Axis) -> Option<f64> {
        match axis {
            Axis::WeightOnBitKn => self.weight_on_bit_kn,
            _ => Some(self.torque_dynamic_nm),
        }
    }
}
