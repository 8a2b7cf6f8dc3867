//! Step by step: the waves that come out of each piece, the load lines that they leave at the
//! nodes, the laws that meet these, and the waves that go in.

use super::scene::{CascadeScene, NodeLaw};
use super::solution::Solution;
use super::system::CascadeSystem;
use super::waves::Past;
use crate::convolution::Kernel;
use crate::error::SimulationError;

/// A scene under way.
#[derive(Debug)]
pub struct CascadeStepper<'a> {
    system: &'a CascadeSystem,
    scene: &'a CascadeScene,
    laws: Vec<NodeLaw>,
    /// Waves that have gone into the ports: up from the uppermost node, into top and bottom of
    /// each link, and down from the lowest node.
    up: Past,
    into: Vec<[Past; 2]>,
    down: Past,
    /// What comes out of each port in this step but for what goes in within it.
    out_of_top: f64,
    out_of: Vec<[f64; 2]>,
    out_of_end: f64,
    driving: Vec<f64>,
    pub now: CascadeStep,
    next: usize,
    steps: usize,
}

/// One step.
#[derive(Debug, Clone)]
pub struct CascadeStep {
    pub nodes: Solution,
    /// Torque that turns the surface, N m.
    pub surface_torque: f64,
    /// Speed of the surface, rad/s.
    pub surface_speed: f64,
}

impl<'a> CascadeStepper<'a> {
    /// A scene at rest.
    pub fn new(
        system: &'a CascadeSystem,
        scene: &'a CascadeScene,
    ) -> Result<Self, SimulationError> {
        scene.check()?;
        let (torques, nodes) = (scene.torques.len(), system.nodes.len());
        if torques != nodes {
            return Err(SimulationError::NotALawForEachNode { torques, nodes });
        }
        let (duration, prepared) = (scene.timing.duration, system.longest_time);
        if duration > prepared {
            return Err(SimulationError::LongerThanPrepared { duration, prepared });
        }
        let mut at_top = vec![&system.top.reflection, &system.torque_by_wave];
        at_top.extend(&system.speed_by_wave);
        let end: Vec<_> = system.end.iter().map(|end| &end.reflection).collect();
        Ok(Self {
            system,
            scene,
            laws: std::iter::zip(&scene.torques, &system.own)
                .map(|(torque, own)| torque.on_lines(1.0 / own))
                .collect(),
            up: Past::empty(&at_top),
            into: (system.links.iter())
                .map(|link| {
                    [
                        Past::empty(&[&link.top, &link.across]),
                        Past::empty(&[&link.across, &link.bottom]),
                    ]
                })
                .collect(),
            down: Past::empty(&end),
            out_of_top: 0.0,
            out_of: vec![[0.0; 2]; system.links.len()],
            out_of_end: 0.0,
            driving: vec![0.0; nodes],
            now: CascadeStep {
                nodes: Solution::at_rest(nodes),
                surface_torque: 0.0,
                surface_speed: 0.0,
            },
            next: 0,
            steps: (duration * system.sampling.frequency).ceil() as usize + 1,
        })
    }

    /// Number of steps, that at the start included.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// The next step; `None` at the end of the scene's time.
    pub fn step(&mut self) -> Result<Option<&CascadeStep>, SimulationError> {
        if self.next == self.steps {
            return Ok(None);
        }
        let time = self.system.sampling.time_of(self.next);
        self.find_driving_torques();
        let settled = (self.now.nodes).solve(self.system, &self.laws, &self.driving, time);
        let mut speeds = self.now.nodes.speeds.iter();
        if let Some(site) = speeds.position(|speed| !speed.is_finite()) {
            return Err(SimulationError::NotFinite { site, time });
        }
        if !settled {
            return Err(SimulationError::NotSettled { time });
        }
        self.send_waves();
        self.next += 1;
        Ok(Some(&self.now))
    }

    /// Torques in the string in this step just above and just below each node, N m, positive where
    /// what is above turns what is below. A piece turns its lower end with −f, and f = a − b and
    /// a + b = Z v leave Z v − 2 a of that.
    pub fn string_torques(&self) -> impl Iterator<Item = [f64; 2]> {
        let top = (self.system.top.impedance, self.up.last());
        let links = std::iter::zip(&self.system.links, &self.into);
        let links = links.map(|(link, [_, at_bottom])| (link.impedance, at_bottom.last()));
        let nodes = std::iter::zip(&self.now.nodes.speeds, &self.now.nodes.torques);
        let ports = std::iter::once(top).chain(links);
        std::iter::zip(ports, nodes).map(|((impedance, wave), (speed, torque))| {
            let above = impedance * speed - 2.0 * wave;
            [above, above + torque]
        })
    }

    /// What comes out of the pieces, and with which torques that drives the nodes: at each
    /// port f = (stiffness) v − 2 (1 + S(0))⁻¹ b.
    fn find_driving_torques(&mut self) {
        let system = self.system;
        self.driving.fill(0.0);
        let sent = self.scene.surface_speed * system.sent[self.next];
        self.out_of_top = sent + self.up.sum(&system.top.reflection);
        self.driving[0] = 2.0 * system.top.inverse() * self.out_of_top;
        for (node, (link, [at_top, at_bottom])) in system.links.iter().zip(&self.into).enumerate() {
            let out = [
                at_top.sum(&link.top) + at_bottom.sum(&link.across),
                at_top.sum(&link.across) + at_bottom.sum(&link.bottom),
            ];
            let drives = link.solved(out);
            self.driving[node] += 2.0 * drives[0];
            self.driving[node + 1] += 2.0 * drives[1];
            self.out_of[node] = out;
        }
        if let (Some(end), Some(last)) = (&system.end, self.driving.last_mut()) {
            self.out_of_end = self.down.sum(&end.reflection);
            *last += 2.0 * end.inverse() * self.out_of_end;
        }
    }

    /// The waves that go into the pieces, (1 + S(0))⁻¹ (Z v − b), and what they do at the surface.
    fn send_waves(&mut self) {
        let (system, speeds) = (self.system, &self.now.nodes.speeds);
        let top = &system.top;
        let up = top.inverse() * (top.impedance * speeds[0] - self.out_of_top);
        let scale = self.scene.surface_speed;
        let by_wave = |kernel: &Kernel| self.up.sum(kernel) + kernel.instant() * up;
        self.now.surface_torque =
            scale * system.torque[self.next] + by_wave(&system.torque_by_wave);
        self.now.surface_speed =
            scale * system.speed[self.next] + system.speed_by_wave.as_ref().map_or(0.0, by_wave);
        self.up.push(up);
        let ports = self.into.iter_mut().zip(&self.out_of);
        for (node, (link, (into, out))) in system.links.iter().zip(ports).enumerate() {
            let wave = |end: usize| link.impedance * speeds[node + end] - out[end];
            let [at_top, at_bottom] = link.solved([wave(0), wave(1)]);
            into[0].push(at_top);
            into[1].push(at_bottom);
        }
        if let Some(end) = &system.end {
            let speed = speeds[speeds.len() - 1];
            self.down
                .push(end.inverse() * (end.impedance * speed - self.out_of_end));
        }
    }
}
