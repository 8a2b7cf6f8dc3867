//! `[feed]`: the keys of what lets the string down.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::number_or::is_zero;

/// What lets the string down above a bit with `[bit.cutting]`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FeedTable {
    /// What is set at the surface.
    #[serde(default)]
    pub kind: FeedName,
    /// Speed at which the surface lets the string down, with `kind = "speed"`; needed unless it
    /// is an axis.
    #[schemars(range(min = 0.001, max = 1e4))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed_m_h: Option<f64>,
    /// Time in which the weight on bit, or the feed, reaches its value, evenly.
    #[schemars(range(min = 0.0, max = 1e4))]
    #[serde(default = "default_rise")]
    pub rise_s: f64,
    /// What moves with the upper end of the string, with `"hook-load"`: travelling block and top
    /// drive. At the frequencies of a bit a heavy one hardly moves.
    #[schemars(!skip_serializing_if, range(min = 0.0, max = 1e6))]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub hoist_mass_kg: f64,
    /// Force per speed with which the hoist opposes motion, with `"hook-load"`; it takes its part of
    /// the weight on bit while the string goes down.
    #[schemars(range(min = 1.0, max = 1e9))]
    #[serde(default = "default_damping")]
    pub hoist_damping_ns_m: f64,
}

/// What is set at the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FeedName {
    /// The hook load, so that `weight_on_bit_kn` is on the bit of a string at rest.
    #[default]
    HookLoad,
    /// The speed, `feed_m_h`.
    Speed,
}

impl Default for FeedTable {
    fn default() -> Self {
        Self {
            kind: FeedName::default(),
            feed_m_h: None,
            rise_s: default_rise(),
            hoist_mass_kg: 0.0,
            hoist_damping_ns_m: default_damping(),
        }
    }
}

fn default_rise() -> f64 {
    5.0
}

/// With it a hoist sends back 0.7 of a wave of a 5-inch pipe, as in studies of drilling by
/// U. J. F. Aarsnes and co-workers.
fn default_damping() -> f64 {
    25e3
}
