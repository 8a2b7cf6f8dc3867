//! `[motor]`: the keys of a mud motor above the bit.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A mud motor (positive displacement) between string and bit, by its chart.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MotorTable {
    /// Speed of the rotor against its housing without load: of the chart, for the flow of mud. The
    /// bit turns as much faster than the string.
    #[schemars(range(min = 1.0, max = 2000.0))]
    pub speed_rpm: f64,
    /// Torque at which it stalls: the rotor stops, and mud leaks by.
    #[schemars(range(min = 0.01, max = 1000.0))]
    pub stall_torque_kn_m: f64,
    /// Speed of the rotor where it is about to stall, to which it falls evenly with torque; left
    /// out, `speed_rpm`. By charts it is a tenth to a third less than without load.
    #[schemars(range(min = 0.0, max = 2000.0))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed_at_stall_rpm: Option<f64>,
    /// Moment of inertia of the rotor and of what turns with it, bit included.
    #[schemars(range(min = 0.01, max = 1000.0))]
    #[serde(default = "usual_inertia")]
    pub rotor_inertia_kg_m2: f64,
}

/// Of a motor of 8 inches with its shaft and bit.
fn usual_inertia() -> f64 {
    3.0
}
