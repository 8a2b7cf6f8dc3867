//! `[well]`, `[mud]`, `[axial_force]` and `[string_friction]`: the keys of what the string lies in.

use serde::{Deserialize, Serialize};

use super::number_or::is_zero;

/// The well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WellTable {
    /// Its survey: measured depth, inclination and azimuth, as CSV or a workbook.
    pub survey: Option<String>,
    /// Radius of the hole, m, where it is the same from the surface to the bit.
    pub hole_radius_m: Option<f64>,
    /// Else its sections, from the surface down.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub holes: Vec<HoleTable>,
}

/// A section of hole, such as a casing or a washout.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HoleTable {
    /// Measured depth where it begins, m.
    pub from_m: f64,
    /// Measured depth where it ends, m.
    pub to_m: f64,
    /// Its radius, m.
    pub hole_radius_m: f64,
}

/// The fluid inside and around the string.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MudTable {
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

/// The axial force along a string that bends.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AxialForceTable {
    /// What natural frequencies in bending may be off by, as a part. Default 0.01.
    #[serde(default = "default_tolerance")]
    pub tolerance: f64,
}

/// Friction of the string against the borehole while it turns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StringFrictionTable {
    /// Static coefficient of friction, unless an axis gives it.
    pub static_coefficient: Option<f64>,
    /// Dynamic coefficient in parts of the static one. Default 1.
    #[serde(default = "default_ratio")]
    pub dynamic_ratio: f64,
    /// Stribeck speed, over which friction falls from static to dynamic, rpm. Default 0: with the
    /// first slip.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub stribeck_rpm: f64,
    /// What presses the string against its well. Default `weight-and-tension`.
    #[serde(default)]
    pub pressed_by: PressedByName,
    /// Equal pieces of the string, each of which slips as a whole. Default 20.
    #[serde(default = "default_pieces")]
    pub pieces: usize,
    /// Else as many of them as keep the torque at the surface to this part of that at which the
    /// string breaks loose.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Whether the greatest torque along the string is followed. Default false.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub torque_along_string: bool,
}

/// What presses the string against its well.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PressedByName {
    /// Its weight, and its tension where the well turns.
    #[default]
    WeightAndTension,
    /// Its weight alone.
    Weight,
}

fn default_tolerance() -> f64 {
    0.01
}

fn default_ratio() -> f64 {
    1.0
}

fn default_pieces() -> usize {
    20
}
