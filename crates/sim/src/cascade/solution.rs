//! All nodes of a step at once.

use super::scene::NodeLaw;
use super::system::CascadeSystem;
use crate::laws::bit::BitMotion;
use crate::laws::pipe::PipeMotion;
use crate::laws::torque::LoadLine;

/// Nodes have settled if none changes its speed by more than what takes this fraction of the
/// largest torque within a step: ten thousand times rounding.
const TOLERANCE: f64 = 1e-12;

/// Passes down the string after which nodes that do not settle are given up.
const MOST_PASSES: usize = 10_000;

/// Passes after which nodes are no longer brought nearer all at once: where some are about to
/// break loose or to be caught, that may throw them to and fro.
const MOST_CORRECTIONS: usize = 20;

/// Speeds and torques at the nodes in one step.
#[derive(Debug, Clone)]
pub struct Solution {
    /// rad/s.
    pub speeds: Vec<f64>,
    /// N m, positive with the rotation.
    pub torques: Vec<f64>,
    /// Of a correction, from above: how a node's step depends on the next one's, and its own.
    steps: Vec<(f64, f64)>,
    /// What drove each node when it was solved last, N m.
    solved_for: Vec<f64>,
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
            steps: vec![(0.0, 0.0); nodes],
            solved_for: vec![0.0; nodes],
            before: vec![PipeMotion::default(); nodes],
            motions: vec![PipeMotion::default(); nodes],
        }
    }

    /// Finds speeds and torques under which every node obeys its law and
    /// Σ stiffness · speed = torque + driving; says whether they settled.
    ///
    /// Each node in turn meets the load line that the others leave it (without laws that is Gauss
    /// and Seidel's method for a symmetric positive matrix), which says what is stuck and what
    /// turns; and all that turn are then brought nearer at once ([`Solution::correct`]). The nodes
    /// have settled when meeting changes nothing any more.
    pub fn solve(
        &mut self,
        system: &CascadeSystem,
        laws: &[NodeLaw],
        driving: &[f64],
        time: f64,
    ) -> bool {
        self.before.copy_from_slice(&self.motions);
        let size = driving
            .iter()
            .fold(0.0, |size: f64, torque| size.max(torque.abs()));
        let nodes = self.speeds.len();
        self.solved_for.fill(f64::INFINITY);
        let least = TOLERANCE * size;
        for pass in 0..MOST_PASSES {
            let mut change: f64 = 0.0;
            for node in 0..nodes {
                change = change.max(self.meet(system, laws, driving, (time, least), node));
            }
            if change <= least {
                return true;
            }
            if pass < MOST_CORRECTIONS {
                self.correct(system, laws, driving);
            }
        }
        false
    }

    /// A step of Newton's method for all nodes that turn, as their laws fall with speed there:
    /// equations of a node and its neighbours, solved from the surface down and back.
    fn correct(&mut self, system: &CascadeSystem, laws: &[NodeLaw], driving: &[f64]) {
        let nodes = self.speeds.len();
        let mut above = (0.0, 0.0);
        for node in 0..nodes {
            let turns = self.motions[node].motion != BitMotion::Stuck || !laws[node].holds();
            self.steps[node] = if turns {
                let cross = if node > 0 { system.next[node - 1] } else { 0.0 };
                let fall = laws[node].fall(self.speeds[node]);
                let pivot = system.own[node] - fall - cross * above.0;
                let left = driving[node] + self.torques[node] - self.resisted(system, node);
                let next = system.next.get(node).copied().unwrap_or(0.0);
                (next / pivot, (left - cross * above.1) / pivot)
            } else {
                (0.0, 0.0)
            };
            above = self.steps[node];
        }
        let mut below = 0.0;
        for node in (0..nodes).rev() {
            let (share, own) = self.steps[node];
            below = own - share * below;
            // What would turn round is left to its law.
            if below.is_finite() && (self.speeds[node] + below) * self.speeds[node] > 0.0 {
                self.speeds[node] += below;
            }
        }
    }

    /// Torque that it takes to turn a node at its speed beside its neighbours at theirs, N m.
    fn resisted(&self, system: &CascadeSystem, node: usize) -> f64 {
        let mut torque = system.own[node] * self.speeds[node];
        if node > 0 {
            torque += system.next[node - 1] * self.speeds[node - 1];
        }
        if let Some(next) = system.next.get(node) {
            torque += next * self.speeds[node + 1];
        }
        torque
    }

    /// One node, unless what drives it has changed by less than the `least` since it was solved;
    /// gives by how much torque its speed has changed.
    fn meet(
        &mut self,
        system: &CascadeSystem,
        laws: &[NodeLaw],
        driving: &[f64],
        (time, least): (f64, f64),
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
        if (left - self.solved_for[node]).abs() <= least {
            return 0.0;
        }
        self.solved_for[node] = left;
        let line = LoadLine {
            time,
            free_speed: left / own,
            compliance: 1.0 / own,
        };
        let before = self.speeds[node];
        let met = laws[node].meet(&self.before[node], line, self.speeds[node]);
        self.speeds[node] = met.speed;
        self.torques[node] = met.torque;
        self.motions[node] = met.state;
        own * (self.speeds[node] - before).abs()
    }
}
