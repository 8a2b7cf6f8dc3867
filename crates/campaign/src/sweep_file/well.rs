//! `[well]`, `[mud]`, `[axial_force]` and `[string_friction]`: the keys of what the string lies in.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::number_or::is_zero;

/// The well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WellTable {
    /// Its survey, for `[string_friction]`, `[axial_force]` and a string that lies on its `[wall]`: a
    /// CSV file or a workbook of
    /// measured depth, inclination and azimuth (`measured_depth_m`, `MD (ft)`;
    /// `inclination_deg`, `Inc`; `azimuth_deg`, `Azi (deg)`), from the surface (depth 0) to the
    /// bit at least. Between its stations the well is an arc of a circle (minimum curvature);
    /// one so sharp that pipe would yield is warned of.
    pub survey: Option<String>,
    /// Instead of `survey`: the angle from the vertical of a well that is straight from the surface on.
    #[schemars(range(min = 0.0, max = 180.0))]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inclination_deg: Option<f64>,
    /// Radius of the hole where it is the same all along, for `[mud]` that is viscous or around a
    /// string that bends, and for `clearance = "hole"`. Every part of the string is narrower, or a bit or
    /// blades of full gauge.
    #[schemars(range(min = 0.001, max = 2.0))]
    pub hole_radius_m: Option<f64>,
    /// Instead of `hole_radius_m`: the sections of the hole, from the surface down, each where
    /// the one above ends.
    #[schemars(!skip_serializing_if)]
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub holes: Vec<HoleTable>,
}

/// A section of hole, such as a casing or a washout.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HoleTable {
    /// Measured depth where it begins.
    #[schemars(range(min = 0.0, max = 2e4))]
    pub from_m: f64,
    /// Measured depth where it ends.
    #[schemars(range(min = 0.0, max = 2e4))]
    pub to_m: f64,
    /// Its radius; every part of the string in it is narrower.
    #[schemars(range(min = 0.001, max = 2.0))]
    pub hole_radius_m: f64,
}

/// The fluid inside and around the string.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MudTable {
    /// Its density. With `[string_friction]` or `[axial_force]` the string is buoyed by it;
    /// with a `[wall]` it moves with the string in bending, inside and around it; viscous mud
    /// turns with the string in part.
    #[schemars(range(min = 1.0, max = 3000.0))]
    pub density_kg_m3: f64,
    /// Its viscosity at the rates of shear of vibration; water has 1, muds have 5 to 50. In the
    /// bore and in the annulus to the hole of `[well]` it holds the string back, more at high
    /// frequencies than at low ones.
    #[schemars(!skip_serializing_if, range(min = 0.0, max = 1e4))]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub viscosity_cp: f64,
}

/// The axial force along a string that bends.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxialForceTable {
    /// The largest relative error of natural frequencies that the pieces of constant force may
    /// cause; it decides their number.
    #[schemars(range(min = 1e-4, max = 0.1))]
    #[serde(default = "default_tolerance")]
    pub tolerance: f64,
}

/// Friction of the string against the borehole while it turns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StringFrictionTable {
    /// Static coefficient μ_s; needed unless it is an axis.
    #[schemars(range(min = 0.0, max = 50.0))]
    pub static_coefficient: Option<f64>,
    /// Dynamic by static coefficient, μ_d/μ_s.
    #[schemars(range(min = 0.0, max = 1.0))]
    #[serde(default = "default_ratio")]
    pub dynamic_ratio: f64,
    /// Stribeck speed ω_s: at ω the coefficient is μ_d + (μ_s − μ_d) exp(−(ω/ω_s)²). With 0 it
    /// falls with the first slip.
    #[schemars(!skip_serializing_if, range(min = 0.0, max = 1e4))]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub stribeck_rpm: f64,
    /// What presses the string on its wall.
    #[serde(default)]
    pub pressed_by: PressedByName,
    /// Equal lengths of string, each of which slips as a whole.
    #[schemars(range(min = 1, max = 2000))]
    #[serde(default = "default_pieces")]
    pub pieces: usize,
    /// Instead of `pieces`: the largest error of the torque at the surface that they may cause,
    /// as a part of the torque at which the whole string breaks loose, and in most starts no
    /// larger; it decides their number, which `inspect` and `manifest.json` state. That is a
    /// quarter of its inverse for an even string, more where a bend bears much. Where the
    /// weight on bit is an axis it holds from end to end of that (at nine weights).
    #[schemars(range(min = 1e-4, max = 0.1))]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<f64>,
    /// Whether the greatest torque in the string is followed in all the time: `labels.csv` then
    /// has two more columns, its amount in either direction (`string_torque_peak_nm`) and its
    /// distance from the bit (`string_torque_peak_from_bit_m`), next to the middle of a piece.
    /// The motor's torque at the surface includes the inertia of its rotor, this does not.
    #[schemars(!skip_serializing_if)]
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub torque_along_string: bool,
}

/// What presses the string against its well.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PressedByName {
    /// Its buoyed weight across the well, and its tension where that turns (a string without
    /// stiffness in bending).
    #[default]
    WeightAndTension,
    /// Its buoyed weight across the well alone.
    Weight,
}

impl Default for AxialForceTable {
    fn default() -> Self {
        Self {
            tolerance: default_tolerance(),
        }
    }
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
