//! The greatest torque along the string.

use serde::{Deserialize, Serialize};

/// Where the string was twisted most in all the time, whichever way: joints are made up to a
/// torque.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct StringTorque {
    /// That torque, N m.
    pub peak_torque: f64,
    /// The distance from the bit of the node next to it, m.
    pub from_bit: f64,
}

/// Watches the torques next to all nodes step by step.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct StringTorqueWatch {
    peak_torque: f64,
    node: usize,
}

impl StringTorqueWatch {
    pub(crate) fn see(&mut self, torques: impl Iterator<Item = [f64; 2]>) {
        for (node, [above, below]) in torques.enumerate() {
            let torque = above.abs().max(below.abs());
            if torque > self.peak_torque {
                self.peak_torque = torque;
                self.node = node;
            }
        }
    }

    /// What came out, of nodes at these distances from the bit, m.
    pub(crate) fn measures(&self, distances_from_bit: &[f64]) -> StringTorque {
        StringTorque {
            peak_torque: self.peak_torque,
            from_bit: distances_from_bit[self.node],
        }
    }
}
