//! Bits that scenes have.

use sim::BitTorque;

/// One whose torque (N m) falls at once as it slips.
pub fn bit(torque_static: f64, torque_dynamic: f64) -> BitTorque {
    BitTorque {
        torque_static,
        torque_dynamic,
        decay_speed: 0.0,
    }
}
