//! The time history of one case, kept only where it is asked for.

/// Samples at k / f_s, one entry a step.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Trajectory {
    /// Rotation speed of each site, from the surface down, rad/s.
    pub speeds: Vec<Vec<f64>>,
    /// Torque on the bit, positive in the direction of rotation, N m; empty
    /// where the bit is free.
    pub bit_torque: Vec<f64>,
}
