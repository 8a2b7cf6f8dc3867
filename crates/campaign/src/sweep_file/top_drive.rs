//! `[top_drive]`: the keys of what turns the string at the surface.

use serde::{Deserialize, Serialize};

/// A motor with inertia that a controller holds at the surface speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TopDriveTable {
    /// Moment of inertia as the string meets it, rotor and gears included, kg m².
    pub inertia_kg_m2: f64,
    /// What holds its speed.
    pub controller: ControllerName,
    /// K_p, kN m s/rad, with `controller = "gains"`.
    pub proportional_gain_knms_rad: Option<f64>,
    /// K_i, kN m/rad, with `controller = "gains"`, or with `"impedance-matched"` instead of
    /// its own.
    pub integral_gain_knm_rad: Option<f64>,
    /// Part of the inertia that the controller makes up for. Default 0; all of it where the
    /// impedance is matched.
    pub inertia_compensation: Option<f64>,
    /// The greatest torque that the drive can give, kN m. The model's drive gives more where its
    /// controller asks for it; what needs more is warned of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque_limit_kn_m: Option<f64>,
}

/// Where the gains come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ControllerName {
    /// One that holds the surface speed whatever it takes: the inertia shows in the motor's
    /// torque alone.
    Prescribed,
    /// Far stiffer than the pipe.
    Stiff,
    /// What damps the first mode most.
    SoftTorque,
    /// The impedance of the pipe.
    ImpedanceMatched,
    /// From the file.
    Gains,
}
