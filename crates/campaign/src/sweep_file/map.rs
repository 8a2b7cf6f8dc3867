//! `[map]`: the keys of the regime map.

use serde::{Deserialize, Serialize};

use crate::quantities::Axis;
use crate::records::Measure;

/// How the regime map is drawn.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct MapTable {
    /// Axis to the right. Default: the first of the design's axes that is not that upwards.
    pub x: Option<Axis>,
    /// Axis upwards. Default: the first of the design's axes that is not that to the right.
    /// Operating conditions come before quantities of the string.
    pub y: Option<Axis>,
    /// A measure to be drawn as colour.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub colour: Option<Measure>,
    /// Cases to point out.
    pub marks: Vec<MarkTable>,
}

/// A case pointed out on the map, by any quantities that place it there.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MarkTable {
    /// What is written beside it.
    pub name: String,
    /// Surface speed, rpm.
    pub surface_speed_rpm: Option<f64>,
    /// Weight on bit, kN; with a rock, T_d will do.
    pub weight_on_bit_kn: Option<f64>,
    /// T_d, N m.
    pub torque_dynamic_nm: Option<f64>,
    /// Impulse in multiples of I₀.
    pub impulse_ratio: Option<f64>,
    /// Friction.
    pub friction: Option<f64>,
}
