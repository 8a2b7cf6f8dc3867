//! `start`: the names of the motions that a case may begin with.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The motion that every case begins with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum StartName {
    /// Steady rotation, the bit sliding, and a small step of the torque on it at t = 0. A string
    /// that lies in its hole slides steadily on its walls.
    Smooth,
    /// Of a string that lies in its hole: steady rotation, lying as it does at rest; the friction of
    /// its walls begins at t = 0.
    Turning,
    /// Rest: the surface starts to turn, at once or over `surface_speed_rise_s`.
    Ramp,
    /// The bit has been held while the surface turned steadily, and breaks loose at t = 0.
    Stuck,
    /// Both `stuck` and `smooth`, one after the other.
    Both,
}

impl StartName {
    /// As it is written.
    pub fn name(self) -> &'static str {
        match self {
            StartName::Smooth => "smooth",
            StartName::Turning => "turning",
            StartName::Ramp => "ramp",
            StartName::Stuck => "stuck",
            StartName::Both => "both",
        }
    }
}
