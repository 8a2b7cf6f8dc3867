//! What preparing and simulating cost in memory, told before anything is prepared:
//! upper bounds in bytes, from numbers of sites, taps and steps.

use linear::cost::Memory;

use crate::convolution::partition::{convolution_memory, kernels_memory};

/// Bytes of a number.
const REAL: f64 = 8.0;

/// Numbers for each tap of a look ahead: its spectrum, the step response and the plans
/// of two transforms of any length.
const LOOK_AHEAD: f64 = 40.0;

/// Numbers for each tap while one looks ahead: torques, their spectrum, speeds.
const LOOK: f64 = 8.0;

/// Numbers for each step that a watch of the bit keeps: speeds of two cycles.
const WATCH: f64 = 2.0;

/// Numbers for each site and step of a time history with lateral motion: speed,
/// position, force, normal force and torque of the wall, all forces; and a byte of how it
/// touches.
const RECORDED: f64 = 9.0 + 1.0 / REAL;

/// What [`crate::Simulator::new`] takes: responses of so many taps in torsion and, where
/// there are any, in bending, to torques at so many of the sites.
pub fn simulator(sites: usize, loads: usize, taps: Taps, steps: f64) -> Memory {
    let from_surface = REAL * sites as f64 * taps.torsion;
    let torsion = kernels_memory(loads, taps.torsion);
    if taps.bending > 0.0 {
        return Memory::lasting(from_surface + torsion + kernels_memory(sites, taps.bending));
    }
    if loads == 0 {
        return Memory::lasting(from_surface);
    }
    let to_others = REAL * (sites - loads.min(sites)) as f64 * taps.torsion;
    let stuck = 2.0 * REAL * steps;
    let kept = from_surface + to_others + stuck + REAL * LOOK_AHEAD * taps.torsion + torsion;
    Memory {
        peak: kept + convolution_memory(1, 1, taps.torsion, steps),
        kept,
    }
}

/// What [`crate::Simulator::stepped`] takes besides the mesh that it copies: of so many sites,
/// whose responses to the surface have so many taps.
pub fn stepped_simulator(sites: usize, taps: f64) -> f64 {
    let sites = sites as f64;
    REAL * (sites * taps + 2.0 * sites * sites)
}

/// What a case of so many steps takes besides the motion of that.
pub fn stepped_case(sites: usize, steps: f64) -> f64 {
    let sites = sites as f64;
    REAL * (3.0 * sites * steps + 2.0 * sites * sites + WATCH * steps)
}

/// What [`crate::Simulator::simulate`] takes for a case of so many steps, stepped to its
/// end.
pub fn case(sites: usize, taps: Taps, steps: f64) -> f64 {
    let watch = REAL * WATCH * steps;
    if taps.bending > 0.0 {
        return convolution_memory(sites, 1, taps.torsion, steps)
            + convolution_memory(sites, 2, taps.bending, steps)
            + watch;
    }
    convolution_memory(1, 1, taps.torsion, steps) + watch + REAL * LOOK * taps.torsion
}

/// What a [`crate::Trajectory`] of so many steps takes, with lateral motion or not.
pub fn trajectory(sites: usize, is_lateral: bool, steps: f64) -> f64 {
    let recorded = if is_lateral { RECORDED } else { 1.0 };
    REAL * steps * (1.0 + recorded * sites as f64)
}

/// Numbers for each node of a string in pieces that a case holds: speeds, torques, what drives
/// it, its law and its motion.
const NODE: f64 = 32.0;

/// Past waves that a port keeps, for each tap.
const PAST: f64 = 4.0;

/// Responses of a piece, and numbers for each step that all cases share.
const OF_PIECE: f64 = 3.0;
const SET: f64 = 8.0;

/// What a simulator takes of a string that rubs at a number of nodes, each of which feels every
/// other by responses of a number of taps; and what a case takes that is stepped against it.
pub fn rubbing(nodes: usize, taps: f64, steps: f64) -> (Memory, f64) {
    let from_surface = REAL * nodes as f64 * taps;
    let shares = 3.0 * REAL * (nodes * nodes) as f64;
    let kept = from_surface + kernels_memory(nodes, taps) + shares;
    let case = convolution_memory(nodes, 1, taps, steps) + shares + REAL * WATCH * steps;
    (Memory::lasting(kept), case)
}

/// What [`crate::Simulator::in_pieces`] keeps of a number of nodes, of responses of a number of
/// taps, for a number of steps.
pub fn cascade(nodes: usize, taps: f64, steps: f64) -> f64 {
    REAL * (OF_PIECE * (nodes + 2) as f64 * taps + SET * steps)
}

/// What a case takes that is stepped against it.
pub fn cascade_case(nodes: usize, taps: f64, steps: f64) -> f64 {
    REAL * (nodes as f64 * (NODE + 2.0 * PAST * taps) + WATCH * steps)
}

/// What a [`crate::SurfaceTorque`] takes, of responses of so many taps in torsion.
pub fn surface_torque(sites: usize, taps: f64) -> f64 {
    sites as f64 * kernels_memory(1, taps) + REAL * taps
}

/// What finding it takes for a motion of so many steps, besides the motion.
pub fn surface_torque_of(taps: f64, steps: f64) -> f64 {
    convolution_memory(1, 1, taps, steps) + 2.0 * REAL * steps
}

/// Taps of responses; none in bending where it is not modelled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taps {
    /// In torsion.
    pub torsion: f64,
    /// In bending.
    pub bending: f64,
}

/// Steps of a case of a given duration (s).
pub fn steps(duration: f64, sampling_frequency: f64) -> f64 {
    (duration * sampling_frequency).ceil() + 1.0
}
