//! The ports that bend, in two planes: what disturbs them, where that and the past bring them, and
//! where their walls leave them.

use crate::coupling::{Load, Solved, Unloaded};
use crate::error::SimulationError;
use crate::laws::contact::{Approach, Contact, ContactError, Spin, WallLaw};
use crate::laws::torque::LoadLine;
use crate::line::{Bending, Past, WallPorts};
use crate::port::turned_by_wall;
use crate::scene::Lateral;
use crate::system::System;

/// A spring is taken back within a step only if it moves the site by less than this part of what it
/// does itself.
const MOST_OF_SPRING: f64 = 0.5;

/// The motion at the walls, in two planes.
#[derive(Debug)]
pub(crate) struct LateralMotion<'a, W> {
    system: &'a System,
    scene: &'a Lateral<W>,
    channel: &'a Bending,
    /// Which ports have these.
    walls: &'a WallPorts,
    /// Forces at the sites, along x and along y.
    forces: Past<'a, 2, 2>,
    /// The last step's state.
    positions: Vec<[f64; 2]>,
    sliding_speeds: Vec<Option<f64>>,
    rotations: Vec<f64>,
    /// This step without contact: forces of disturbances, and displacements; x of all
    /// sites and then y.
    external: Vec<f64>,
    /// Whether any of these forces is not zero.
    is_disturbed: bool,
    free_positions: Vec<f64>,
    step_forces: Vec<f64>,
    /// Springs at the walls that the linear string has and the case has not, N/m, which are taken
    /// back from what acts on it; nothing where there are none.
    springs: &'a [f64],
    /// Of a string that lies in its hole: the forces of its walls at rest, and where it would be
    /// at rest without what they do within a step; x of all walls and then y. Else nothing.
    resting_forces: Vec<f64>,
    resting_positions: Vec<f64>,
}

impl<'a, W: WallLaw> LateralMotion<'a, W> {
    /// At rest: in the middle, or where the string lies.
    ///
    /// # Errors
    /// Where the string does not bend, or has other walls.
    pub(crate) fn new(
        system: &'a System,
        scene: &'a Lateral<W>,
        steps: usize,
    ) -> Result<Self, SimulationError> {
        let channel = (system.from_forces.as_ref()).ok_or(SimulationError::NoForceInput)?;
        let (walls, sites) = (scene.walls.len(), system.walls.len());
        if walls != sites {
            return Err(SimulationError::NotAWallForEachSite { walls, sites });
        }
        let springs = system.springs.as_slice();
        let too_stiff = (springs.iter().enumerate())
            .find(|(site, spring)| channel.instant(*site, *site) * *spring > MOST_OF_SPRING);
        if let Some((site, _)) = too_stiff {
            return Err(SimulationError::SpringTooStiff { site });
        }
        let lying = scene.lying.as_ref();
        let resting_forces = lying.map_or_else(Vec::new, |it| {
            let forces = by_axis(&it.forces);
            let places = by_axis(&it.positions);
            let springs = springs.iter().copied().chain(std::iter::repeat(0.0));
            let springs = springs.take(sites).collect::<Vec<f64>>().repeat(2);
            let acting = forces.iter().zip(places).zip(springs);
            acting
                .map(|((force, place), spring)| force + spring * place)
                .collect()
        });
        let resting_positions = lying.map_or_else(Vec::new, |it| {
            let mut positions = by_axis(&it.positions);
            let planes = positions.chunks_exact_mut(sites);
            for (positions, forces) in planes.zip(resting_forces.chunks_exact(sites)) {
                for (input, force) in forces.iter().enumerate() {
                    for (site, position) in positions.iter_mut().enumerate() {
                        *position -= channel.instant(site, input) * force;
                    }
                }
            }
            positions
        });
        Ok(Self {
            system,
            scene,
            channel,
            walls: &system.walls,
            forces: channel.past(steps),
            positions: lying.map_or_else(|| vec![[0.0; 2]; sites], |it| it.positions.clone()),
            sliding_speeds: vec![None; sites],
            rotations: vec![0.0; sites],
            external: vec![0.0; 2 * sites],
            is_disturbed: false,
            free_positions: vec![0.0; 2 * sites],
            step_forces: vec![0.0; 2 * sites],
            springs,
            resting_forces,
            resting_positions,
        })
    }

    /// What a step does without contact, the speeds of all ports in the last step given, rad/s.
    pub(crate) fn find_free_motion(&mut self, time: f64, last_speeds: &[f64]) {
        let sites = self.positions.len();
        self.find_external_forces(time, last_speeds);
        self.forces.write_past(&mut self.free_positions);
        let resting = self.resting_positions.iter();
        for (position, resting) in self.free_positions.iter_mut().zip(resting) {
            *position += resting;
        }
        if !self.is_disturbed {
            return;
        }
        let planes = self.free_positions.chunks_exact_mut(sites);
        for (positions, external) in planes.zip(self.external.chunks_exact(sites)) {
            let acting = external
                .iter()
                .enumerate()
                .filter(|(_, force)| **force != 0.0);
            for (input, force) in acting {
                for (site, position) in positions.iter_mut().enumerate() {
                    *position += self.channel.instant(site, input) * force;
                }
            }
        }
    }

    /// Disturbances of this step; an eccentric mass pulls as the last step
    /// left it.
    fn find_external_forces(&mut self, time: f64, last_speeds: &[f64]) {
        let sampling = self.system.sampling;
        let sites = self.positions.len();
        if self.is_disturbed {
            self.external.fill(0.0);
            self.is_disturbed = false;
        }
        let mut add = |site: usize, [x, y]: [f64; 2]| {
            self.is_disturbed = true;
            self.external[site] += x;
            self.external[sites + site] += y;
        };
        for impulse in &self.scene.impulses {
            let force = impulse.force(time);
            if force != [0.0; 2] {
                add(impulse.site, force);
            }
        }
        for mass in &self.scene.eccentric_masses {
            let [x, y] = self.positions[mass.site];
            let speed = last_speeds[self.walls.ports()[mass.site]];
            let since = sampling.collocation_offset / sampling.frequency;
            let rotation = self.rotations[mass.site] + since * speed;
            // What the string carries has its inertia there; and the centre of a string that lies in
            // its hole does not turn about the middle of it.
            let carried = self
                .system
                .masses
                .get(mass.site)
                .is_some_and(|it| *it > 0.0);
            let radius = match carried || self.scene.lying.is_some() {
                true => 0.0,
                false => x.hypot(y),
            };
            add(mass.site, mass.force(radius, rotation, speed));
        }
    }

    /// The torques of the walls on a string that slides at the beginning, N m, with their ports.
    pub(crate) fn resting_torques(&self) -> impl Iterator<Item = (usize, f64)> + use<'_, 'a, W> {
        let lying = self.scene.lying.as_ref();
        let torques = lying.map_or(&[][..], |lying| &lying.torques).iter();
        (self.walls.ports().iter().copied())
            .zip(torques.copied())
            .filter(|(_, torque)| *torque != 0.0)
    }

    /// Where the walls would be without contact, x of all and then y, m.
    #[inline]
    pub(crate) fn free_positions(&self) -> &[f64] {
        &self.free_positions
    }

    /// The wall of a port, where it has one, with its number.
    #[inline]
    pub(crate) fn wall_at(&self, port: usize) -> Option<(usize, &'a W)> {
        let wall = self.walls.at(port)?;
        Some((wall, &self.scene.walls[wall]))
    }

    /// The spring at a wall that is taken back, N/m, where there are any.
    #[inline]
    pub(crate) fn spring(&self, site: usize) -> Option<f64> {
        self.springs.get(site).copied()
    }

    /// Approach to a wall under the loads of the others, on the load line of its turning, what it did last given.
    /// Where a spring is taken back, u = p + A (F + k u) leaves u = (p + A F)/(1 − A k).
    #[inline(always)]
    pub(crate) fn approach(
        &self,
        site: usize,
        (unloaded, last): (&Unloaded, &Contact),
        line: LoadLine,
    ) -> Approach<'static> {
        let mut compliance = self.channel.instant(site, site);
        let mut free_position = unloaded.position;
        if !self.springs.is_empty() {
            let give = 1.0 - compliance * self.springs[site];
            free_position = free_position.map(|it| it / give);
            compliance /= give;
        }
        Approach {
            free_position,
            previous_position: self.positions[site],
            previous_sliding_speed: self.sliding_speeds[site],
            last_force: last.force,
            present_position: unloaded.present,
            compliance,
            spin: Spin {
                free_speed: line.free_speed,
                compliance: line.compliance,
                resistance: None,
            },
            sampling: self.system.sampling,
        }
    }

    /// Contact at a port that a wall alone turns, and the solution that the other ports get; what the
    /// wall did last is given.
    ///
    /// # Errors
    /// Where the wall has no answer.
    #[inline(always)]
    pub(crate) fn meet(
        &self,
        site: usize,
        wall: &W,
        unloaded_and_last: (&Unloaded, &Contact),
        line: LoadLine,
    ) -> Result<(Contact, Solved), ContactError> {
        let approach = self.approach(site, unloaded_and_last, line);
        let contact = wall.meet(&approach)?;
        let mut solved = turned_by_wall(&contact, line);
        match self.spring(site) {
            Some(spring) => solved.take_back(spring, contact.position),
            None if solved.load == Load::default() => {
                solved.slack = approach.slack(wall.clearance());
            }
            None => {}
        }
        Ok((contact, solved))
    }

    /// Ends a step with what all walls did and the speeds of all ports, rad/s.
    pub(crate) fn end_step(&mut self, contacts: &[Contact], speeds: &[f64]) {
        let (sites, sampling) = (self.positions.len(), self.system.sampling);
        for (site, contact) in contacts.iter().enumerate() {
            for axis in 0..2 {
                let place = axis * sites + site;
                self.step_forces[place] = self.external[place] + contact.force[axis];
                if let Some(spring) = self.springs.get(site) {
                    self.step_forces[place] += spring * contact.position[axis];
                }
            }
            self.positions[site] = sampling.end_of_step(contact.position, self.positions[site]);
            self.sliding_speeds[site] = contact.touches().then_some(contact.sliding_speed);
        }
        if !self.scene.eccentric_masses.is_empty() {
            for (rotation, &port) in self.rotations.iter_mut().zip(self.walls.ports()) {
                *rotation += speeds[port] / sampling.frequency;
            }
        }
        let resting = self.resting_forces.iter();
        for (force, resting) in self.step_forces.iter_mut().zip(resting) {
            *force -= resting;
        }
        self.forces.add(&self.step_forces);
    }

    /// All forces at a wall so far along an axis, disturbances included, less those that hold a
    /// string at rest, N.
    pub(crate) fn forces(&self, axis: usize, site: usize) -> &[f64] {
        self.forces.loads(axis, site)
    }

    /// At the beginning of a block, displacements through it, x of all walls and then y, as long as
    /// nothing acts.
    pub(crate) fn free_block(&self) -> Option<&[f64]> {
        self.forces.next_block()
    }

    /// Where the string was at each wall at the end of the last step, m.
    pub(crate) fn positions(&self) -> &[[f64; 2]] {
        &self.positions
    }

    /// Passes a block in which nothing acts, at the end of which the string is at `positions`.
    pub(crate) fn pass_block(&mut self, positions: &[[f64; 2]]) {
        self.positions.copy_from_slice(positions);
        self.sliding_speeds.fill(None);
        self.forces.push_quiet_block();
    }
}

/// x of all and then y.
fn by_axis(pairs: &[[f64; 2]]) -> Vec<f64> {
    let axis = |axis: usize| pairs.iter().map(move |pair| pair[axis]);
    axis(0).chain(axis(1)).collect()
}
