//! `[map]`: the keys of the regime map.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::quantities::Axis;
use crate::records::Measure;

/// How the regime map is drawn.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MapTable {
    /// The axis to the right; left out, the next axis of the design.
    pub x: Option<Axis>,
    /// The axis upwards; left out, the first axis of the design.
    pub y: Option<Axis>,
    /// A measure of `labels.csv`, drawn as colour on maps in addition to those of the regimes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub colour: Option<Measure>,
    /// Cases to point out.
    pub marks: Vec<MarkTable>,
}

/// A case pointed out on the map, by any quantities that place it there.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MarkTable {
    /// What is written next to it.
    pub name: String,
    /// Surface speed.
    #[schemars(range(min = 1e-4, max = 1e4))]
    pub surface_speed_rpm: Option<f64>,
    /// Weight on bit.
    #[schemars(range(min = 0.0, max = 2000.0))]
    pub weight_on_bit_kn: Option<f64>,
    /// Dynamic torque T_d.
    #[schemars(range(min = 0.0, max = 1e7))]
    pub torque_dynamic_nm: Option<f64>,
    /// Impulse in multiples of I₀.
    #[schemars(range(min = 0.0, max = 1e6))]
    pub impulse_ratio: Option<f64>,
    /// Coefficient of friction.
    #[schemars(range(min = 0.0, max = 50.0))]
    pub friction: Option<f64>,
}
