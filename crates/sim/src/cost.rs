//! What preparing and simulating cost in memory, told before anything is prepared:
//! upper bounds in bytes, from numbers of sites, taps and steps.

use linear::cost::Memory;

use crate::history::partition::{history_memory, kernels_memory};

/// Bytes of a number.
const REAL: f64 = 8.0;

/// Numbers for each tap of a look ahead: its spectrum, the step response and the plans
/// of two transforms of any length.
const FUTURE: f64 = 40.0;

/// Numbers for each tap while one looks ahead: torques, their spectrum, speeds.
const LOOK: f64 = 8.0;

/// Numbers for each step that a watch of the bit keeps: speeds of two cycles.
const WATCH: f64 = 2.0;

/// Numbers for each site and step of a time history with lateral motion: speed,
/// position, wall force, all forces.
const RECORDED: f64 = 7.0;

/// What [`crate::System::new`] takes: responses of so many taps to a torque at the bit,
/// prepared for cases of so many steps.
pub fn torsion_system(sites: usize, taps: f64, steps: f64) -> Memory {
    let from_surface = REAL * sites as f64 * taps;
    let to_sites = REAL * sites as f64 * taps;
    let held = 2.0 * REAL * steps;
    let kept = from_surface + to_sites + held + REAL * FUTURE * taps + kernels_memory(1, taps);
    Memory {
        peak: kept + history_memory(1, 1, taps, steps),
        kept,
    }
}

/// What [`crate::System::new`] takes where no torque acts.
pub fn free_system(sites: usize, taps: f64) -> Memory {
    Memory::lasting(REAL * sites as f64 * taps)
}

/// What [`crate::LateralSystem::new`] takes: responses of so many taps in torsion and in
/// bending.
pub fn lateral_system(sites: usize, torsion_taps: f64, bending_taps: f64) -> Memory {
    let from_surface = REAL * sites as f64 * torsion_taps;
    let kernels = kernels_memory(sites, torsion_taps) + kernels_memory(sites, bending_taps);
    Memory::lasting(from_surface + kernels)
}

/// What [`crate::simulate`] takes for a case of so many steps, stepped to its end.
pub fn torsion_case(taps: f64, steps: f64) -> f64 {
    history_memory(1, 1, taps, steps) + REAL * (WATCH * steps + LOOK * taps)
}

/// What [`crate::simulate_lateral`] takes for a case of so many steps.
pub fn lateral_case(sites: usize, torsion_taps: f64, bending_taps: f64, steps: f64) -> f64 {
    history_memory(sites, 1, torsion_taps, steps)
        + history_memory(sites, 2, bending_taps, steps)
        + REAL * WATCH * steps
}

/// What a [`crate::Trajectory`] of so many steps takes, with lateral motion or not.
pub fn trajectory(sites: usize, is_lateral: bool, steps: f64) -> f64 {
    let recorded = if is_lateral { RECORDED } else { 1.0 };
    REAL * steps * (1.0 + recorded * sites as f64)
}

/// Steps of a case of a given duration (s).
pub fn steps(duration: f64, sampling_frequency: f64) -> f64 {
    (duration * sampling_frequency).ceil() + 1.0
}
