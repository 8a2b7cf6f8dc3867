//! All nodes of a step at once.

use super::scene::NodeTorque;
use super::system::CascadeSystem;
use crate::laws::pipe::PipeMotion;
use crate::laws::torque::LoadLine;

/// Nodes have settled if none changes its speed by more than what takes this fraction of the
/// largest torque within a step: ten thousand times rounding.
const TOLERANCE: f64 = 1e-12;

/// Passes down and up the string after which nodes that do not settle are given up.
const MOST_PASSES: usize = 10_000;

/// Speeds and torques at the nodes in one step.
#[derive(Debug, Clone)]
pub struct Solution {
    /// rad/s.
    pub speeds: Vec<f64>,
    /// N m, positive with the rotation.
    pub torques: Vec<f64>,
    /// What the laws were doing in the last step, and in this.
    before: Vec<PipeMotion>,
    pub motions: Vec<PipeMotion>,
}

impl Solution {
    /// So many nodes at rest.
    pub fn at_rest(nodes: usize) -> Self {
        Self {
            speeds: vec![0.0; nodes],
            torques: vec![0.0; nodes],
            before: vec![PipeMotion::default(); nodes],
            motions: vec![PipeMotion::default(); nodes],
        }
    }

    /// Finds speeds and torques under which every node obeys its law and
    /// Σ stiffness · speed = torque + driving; says whether they settled.
    ///
    /// Each node in turn meets the load line that the others leave it. Without laws that is
    /// Gauss and Seidel's method for a symmetric positive matrix. The faster a node the faster
    /// are those that it drives and, whatever its law, the faster it is itself: nothing is
    /// undone from pass to pass.
    pub fn solve(
        &mut self,
        system: &CascadeSystem,
        laws: &[NodeTorque],
        driving: &[f64],
        time: f64,
    ) -> bool {
        self.before.copy_from_slice(&self.motions);
        let size = driving
            .iter()
            .fold(0.0, |size: f64, torque| size.max(torque.abs()));
        let nodes = self.speeds.len();
        for _ in 0..MOST_PASSES {
            let mut change: f64 = 0.0;
            for node in 0..nodes {
                change = change.max(self.meet(system, laws, driving, time, node));
            }
            for node in (0..nodes.saturating_sub(1)).rev() {
                change = change.max(self.meet(system, laws, driving, time, node));
            }
            if change <= TOLERANCE * size {
                return true;
            }
        }
        false
    }

    /// One node; gives by how much torque its speed has changed.
    fn meet(
        &mut self,
        system: &CascadeSystem,
        laws: &[NodeTorque],
        driving: &[f64],
        time: f64,
        node: usize,
    ) -> f64 {
        let own = system.own[node];
        let mut left = driving[node];
        if node > 0 {
            left -= system.next[node - 1] * self.speeds[node - 1];
        }
        if let Some(next) = system.next.get(node) {
            left -= next * self.speeds[node + 1];
        }
        let line = LoadLine {
            time,
            free_speed: left / own,
            compliance: 1.0 / own,
        };
        let before = self.speeds[node];
        let met = laws[node].meet(&self.before[node], line);
        self.speeds[node] = met.speed;
        self.torques[node] = met.torque;
        self.motions[node] = met.state;
        own * (self.speeds[node] - before).abs()
    }
}
