//! The loads of all ports, of which most bear none.

/// What acts on a port in a step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Load {
    /// Force, N.
    pub(crate) force: [f64; 2],
    /// Torque, N m.
    pub(crate) torque: f64,
}

/// The largest torque, N m.
pub(super) fn largest_torque(loads: &[Load]) -> f64 {
    let torques = loads.iter().map(|load| load.torque.abs());
    torques.fold(0.0, f64::max)
}
