//! What is known of all of several cases.

use campaign::engine::Simulation;

/// Whether there is a torque at the bit.
pub fn has_torque(simulations: &[Simulation]) -> bool {
    let mut motions = simulations.iter().map(|simulation| &simulation.trajectory);
    motions.any(|motion| !motion.bit_torque.is_empty())
}

/// Whether the torque at the surface is known of all.
pub fn has_surface_torque(simulations: &[Simulation]) -> bool {
    let mut motions = simulations.iter().map(|simulation| &simulation.trajectory);
    motions.all(|motion| !motion.surface_torque.is_empty())
}

/// Whether the speed of the surface is known of all.
pub fn has_surface_speed(simulations: &[Simulation]) -> bool {
    let mut motions = simulations.iter().map(|simulation| &simulation.trajectory);
    motions.all(|motion| !motion.surface_speed.is_empty())
}
