//! `[top_drive]`: the keys of what turns the string at the surface.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::number_or::{is_false, is_zero};

/// A motor with inertia that a controller holds at the surface speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TopDriveTable {
    /// Moment of inertia as the string meets it: rotor times the gear ratio squared, gears,
    /// quill. Makers state it; large drives have 1000 to 4000.
    #[schemars(range(min = 0.0, max = 1e6))]
    pub inertia_kg_m2: f64,
    /// Where K_p and K_i come from.
    pub controller: ControllerName,
    /// K_p, with `gains`.
    #[schemars(range(min = 1e-6, max = 1e6))]
    pub proportional_gain_knms_rad: Option<f64>,
    /// K_i, with `gains`; or, with `impedance-matched`, instead of the default.
    #[schemars(range(min = 1e-6, max = 1e6))]
    pub integral_gain_knm_rad: Option<f64>,
    /// The part of the inertia that the controller makes up for by the measured acceleration:
    /// if left out 0, but 1 where the impedance is matched. More than all of it is unstable on
    /// any string.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub inertia_compensation: Option<f64>,
    /// How long ago speed and acceleration were measured that the controller answers to; 10 to 100 in drives as
    /// they are. It then gives energy at high frequencies: a string that takes less grows unstable below it,
    /// and is refused with the longest delay that it bears.
    #[schemars(!skip_serializing_if, range(min = 0.0, max = 1e4))]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub delay_ms: f64,
    /// The most torque that the drive can give. Without `saturates` the drive of the model is linear
    /// and gives what its controller asks for; `run`, `simulate` and `inspect` warn where steady
    /// rotation, or a start from rest, takes more.
    #[schemars(range(min = 0.001, max = 1e6))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque_limit_kn_m: Option<f64>,
    /// Whether the drive gives no more than `torque_limit_kn_m`: while its controller asks for
    /// more, the integral stands still.
    #[schemars(!skip_serializing_if)]
    #[serde(default, skip_serializing_if = "is_false")]
    pub saturates: bool,
}

/// Where the gains come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ControllerName {
    /// It turns at its speed at any torque, as without this table; the inertia shows in the
    /// motor's torque alone, which is followed with `[string_friction]` or `surface_torque =
    /// true`, for a speed that was recorded or rises.
    Prescribed,
    /// 100 times the impedance of the uppermost tube, as a plain speed controller.
    Stiff,
    /// The gains that damp the first mode most; for a drive at least as heavy as that mode.
    SoftTorque,
    /// The impedance of the uppermost tube, the inertia made up for, and a K_i that hardly
    /// matters to the first mode.
    ImpedanceMatched,
    /// `proportional_gain_knms_rad` and `integral_gain_knm_rad`.
    Gains,
}
