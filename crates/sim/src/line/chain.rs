//! Ports in a row, each of which feels within a step only those next to it.

/// Torques per speed within a step of ports in a row, N m s/rad: a symmetric matrix of three
/// diagonals.
#[derive(Debug, Clone)]
pub(crate) struct Chain {
    /// Of each port at itself.
    pub(crate) own: Vec<f64>,
    /// Of each port at the next.
    pub(crate) next: Vec<f64>,
}

impl Chain {
    /// Torque, N m, that the speeds of its neighbours take at a port.
    #[inline]
    pub(crate) fn taken_by_neighbours(&self, port: usize, speeds: &[f64]) -> f64 {
        let mut torque = 0.0;
        if port > 0 {
            torque += self.next[port - 1] * speeds[port - 1];
        }
        if let Some(next) = self.next.get(port) {
            torque += next * speeds[port + 1];
        }
        torque
    }

    /// Torque, N m, that it takes to turn a port at its speed while the others turn at theirs.
    pub(crate) fn taken(&self, port: usize, speeds: &[f64]) -> f64 {
        self.own[port] * speeds[port] + self.taken_by_neighbours(port, speeds)
    }
}
