//! Eqs. 59–61, step by step: what the past adds, the load lines that leaves, and the
//! local laws that meet them.

use crate::channel::{Bending, Past};
use crate::coupling::{Coupling, Free, Solved, Unloaded};
use crate::error::SimulationError;
use crate::laws::bit::BitTorque;
use crate::laws::contact::{Contact, WallLaw};
use crate::laws::torque::{LoadLine, TorqueLaw, TorqueStep};
use crate::laws::wall::Wall;
use linear::SteadyMotion;

use crate::scene::{Lateral, Scene};
use crate::site::{LateralLine, Load, SiteLaws};
use crate::start::Start;
use crate::system::System;

/// One step of all sites that may bear a load.
#[derive(Debug, Clone)]
pub struct Step<S> {
    /// Time, s.
    pub time: f64,
    /// Rotation speeds of the sites that a torque may act on, rad/s.
    pub speeds: Vec<f64>,
    /// What each site does at its wall; nothing without walls.
    pub contacts: Vec<Contact>,
    /// What the bit does, where a law acts there.
    pub bit: Option<TorqueStep<S>>,
}

/// A scene under way, one step after the other, against its linear system.
#[derive(Debug)]
pub struct Stepper<'a, B: TorqueLaw = BitTorque, W: WallLaw = Wall> {
    system: &'a System,
    scene: &'a Scene<B, W>,
    /// The law of the bit, and which of the loads is its.
    bit: Option<(&'a B, usize)>,
    reference: Reference<'a>,
    /// The torque that holds the bit fast in this step, N m, where it is held.
    held: f64,
    /// The next step, and how many there are.
    next: usize,
    steps: usize,
    torques: Past<'a, 1, 1>,
    lateral: Option<LateralMotion<'a, W>>,
    coupling: Coupling<'a>,
    bit_state: B::State,
    /// Speeds of this step without its loads.
    free_speeds: Vec<f64>,
    step_torques: Vec<f64>,
    now: Step<B::State>,
}

/// The motion that all loads are added to: until it leaves that motion, nothing has to
/// be stepped.
#[derive(Debug, Clone, Copy)]
enum Reference<'a> {
    /// The surface turns a string that is free.
    Free,
    /// The surface turns a string whose bit is held fast, by these torques per unit of
    /// its speed. Loads are what the torques on the bit, the only ones, differ by.
    Stuck(&'a [f64]),
    /// No speed changes. The load of the bit is what its torque differs by.
    Steady(&'a SteadyMotion),
}

/// The sites in two planes.
#[derive(Debug)]
struct LateralMotion<'a, W> {
    scene: &'a Lateral<W>,
    channel: &'a Bending,
    /// Forces at the sites, along x and along y.
    forces: Past<'a, 2, 2>,
    /// The last step's state.
    positions: Vec<[f64; 2]>,
    sliding_speeds: Vec<Option<f64>>,
    rotations: Vec<f64>,
    /// This step without contact: forces of disturbances, and displacements; x of all
    /// sites and then y.
    external: Vec<f64>,
    free_positions: Vec<f64>,
    step_forces: Vec<f64>,
}

impl<'a, B: TorqueLaw, W: WallLaw> Stepper<'a, B, W> {
    /// A scene at its start.
    ///
    /// # Errors
    /// Where the scene is refused, or does not fit the system.
    pub fn new(system: &'a System, scene: &'a Scene<B, W>) -> Result<Self, SimulationError> {
        let reference = (scene.start.steady()).map_or(Reference::Free, Reference::Steady);
        Self::begin(system, scene, reference, 0)
    }

    /// A scene in which nothing acts but the bit, at the step at which that first slips;
    /// until then it is held fast by these torques, N m per rad/s of surface speed.
    pub(crate) fn at_first_slip(
        system: &'a System,
        scene: &'a Scene<B, W>,
        stuck_torque: &'a [f64],
        slip: usize,
    ) -> Result<Self, SimulationError> {
        Self::begin(system, scene, Reference::Stuck(stuck_torque), slip)
    }

    fn begin(
        system: &'a System,
        scene: &'a Scene<B, W>,
        reference: Reference<'a>,
        first: usize,
    ) -> Result<Self, SimulationError> {
        scene.check(system.sites)?;
        system.lasts_for(scene.timing.duration)?;
        let bit = match &scene.bit {
            None => None,
            Some(law) => {
                let bit = system.bit_load().ok_or(SimulationError::NoTorqueInput)?;
                Some((law, bit.load))
            }
        };
        let steps = system.steps_of(scene.timing.duration);
        let lateral = (scene.lateral.as_ref())
            .map(|lateral| LateralMotion::new(system, lateral, steps))
            .transpose()?;
        let count = system.loaded.len();
        let walls = (scene.lateral.as_ref()).map_or(&[][..], |lateral| &lateral.walls);
        let radii: Vec<f64> = walls.iter().map(WallLaw::radius).collect();
        let speeds = match reference {
            Reference::Free | Reference::Stuck(_) => vec![0.0; count],
            Reference::Steady(motion) => of_sites(&system.loaded, &motion.speeds),
        };
        let turned = bit.map(|(law, load)| law.turning_at(speeds[load]));
        Ok(Self {
            system,
            scene,
            bit,
            reference,
            held: 0.0,
            next: first,
            steps,
            torques: system.from_torques.past(steps - first.min(steps)),
            lateral,
            coupling: Coupling::new(&system.from_torques, system.from_forces.as_ref(), &radii),
            bit_state: turned.unwrap_or_default(),
            free_speeds: vec![0.0; count],
            step_torques: vec![0.0; count],
            now: Step {
                time: 0.0,
                speeds,
                contacts: vec![Contact::NONE; walls.len()],
                bit: None,
            },
        })
    }

    /// Number of steps of the scene, that at its start included.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// The number of the step that comes next, from 0.
    pub fn next_step(&self) -> usize {
        self.next
    }

    /// The next step; `None` at the end of the scene's time.
    ///
    /// # Errors
    /// Where the motion is not finite, a wall has no answer, or sites that touch one
    /// another within a step do not settle.
    #[inline]
    pub fn step(&mut self) -> Result<Option<&Step<B::State>>, SimulationError> {
        if self.next >= self.steps {
            return Ok(None);
        }
        self.now.time = self.system.sampling.time_of(self.next);
        self.find_free_motion();
        match self.lateral {
            None => self.meet_bit()?,
            Some(_) => self.meet_walls()?,
        }
        self.end_step();
        self.next += 1;
        Ok(Some(&self.now))
    }

    /// Speeds and displacements of this step if no law answered.
    #[inline]
    fn find_free_motion(&mut self) {
        self.torques.write_past(&mut self.free_speeds);
        let (scene, step) = (self.scene, self.next);
        match self.reference {
            Reference::Free => {
                for (speed, site) in self.free_speeds.iter_mut().zip(&self.system.loaded) {
                    *speed += scene.surface_speed * self.system.surface_response(*site, step);
                }
            }
            Reference::Stuck(stuck) => {
                self.held = scene.surface_speed * stuck[step];
                self.free_speeds[0] -= self.system.from_torques.instant(0, 0) * self.held;
            }
            Reference::Steady(motion) => {
                for (speed, site) in self.free_speeds.iter_mut().zip(&self.system.loaded) {
                    *speed += motion.speeds[*site];
                }
                if let Some((_, load)) = self.bit {
                    self.held = motion.at_bit.at(self.now.time);
                    for (index, speed) in self.free_speeds.iter_mut().enumerate() {
                        *speed -= self.system.from_torques.instant(index, load) * self.held;
                    }
                }
            }
        }
        if let Some(lateral) = &mut self.lateral {
            lateral.find_free_motion(self.system, self.now.time, &self.now.speeds);
        }
    }

    /// The bit's law, where there is no wall: no other site has to agree.
    #[inline]
    fn meet_bit(&mut self) -> Result<(), SimulationError> {
        let (from_torques, time) = (&self.system.from_torques, self.now.time);
        let speeds = &mut self.now.speeds;
        match self.bit {
            None => speeds.copy_from_slice(&self.free_speeds),
            Some((law, load)) => {
                let line = LoadLine {
                    time,
                    free_speed: self.free_speeds[load],
                    compliance: from_torques.instant(load, load),
                };
                let bit = law.meet(&self.bit_state, line);
                let free = self.free_speeds.iter().enumerate();
                for (speed, (index, free)) in speeds.iter_mut().zip(free) {
                    *speed = free + from_torques.instant(index, load) * bit.torque;
                }
                speeds[load] = bit.speed;
                self.coupling.set_torque(load, bit.torque);
                self.now.bit = Some(bit);
            }
        }
        match speeds.iter().position(|speed| !speed.is_finite()) {
            None => Ok(()),
            Some(index) => Err(self.system.not_finite(index, time)),
        }
    }

    /// All sites and their walls at once.
    fn meet_walls(&mut self) -> Result<(), SimulationError> {
        let Self {
            system,
            bit,
            lateral: Some(lateral),
            coupling,
            bit_state,
            free_speeds,
            now,
            ..
        } = self
        else {
            return Ok(());
        };
        let (system, lateral, time) = (*system, &*lateral, now.time);
        let free = Free {
            positions: &lateral.free_positions,
            speeds: free_speeds,
        };
        let settled = coupling.settle(free, |index, unloaded: Unloaded| {
            let at_bit = bit.filter(|(_, load)| *load == index);
            let laws = SiteLaws {
                bit: at_bit.map(|(law, _)| (law, &*bit_state)),
                wall: &lateral.scene.walls[index],
            };
            let line = LoadLine {
                time,
                free_speed: unloaded.speed,
                compliance: system.from_torques.instant(index, index),
            };
            let lateral_line = lateral.line(system, index, unloaded.position);
            let found = laws
                .meet(line, lateral_line)
                .map_err(|error| SimulationError::of_contact(error, system.loaded[index], time))?;
            let load = found.load();
            let solved = Solved {
                load,
                normal_force: found.contact.normal_force,
                slack: match load == Load::default() && at_bit.is_none() {
                    true => lateral_line.slack(laws.wall.clearance()),
                    false => 0.0,
                },
            };
            if !(found.speed.is_finite() && load.torque.is_finite()) {
                return Err(system.not_finite(index, time));
            }
            now.speeds[index] = found.speed;
            now.contacts[index] = found.contact;
            if found.bit.is_some() {
                now.bit = found.bit;
            }
            Ok(solved)
        })?;
        match settled {
            true => Ok(()),
            false => Err(SimulationError::NotSettled { time }),
        }
    }

    /// From this step to the past.
    #[inline]
    fn end_step(&mut self) {
        let loads = self.coupling.loads();
        for (torque, load) in self.step_torques.iter_mut().zip(loads) {
            *torque = load.torque;
        }
        if let Some((_, load)) = self.bit {
            self.step_torques[load] -= self.held;
        }
        self.torques.add(&self.step_torques);
        if let Some(lateral) = &mut self.lateral {
            lateral.end_step(self.system, &self.now);
        }
        if let Some(bit) = &self.now.bit {
            self.bit_state.clone_from(&bit.state);
        }
    }

    /// The motion that the scene begins with.
    pub(crate) fn start(&self) -> &Start {
        &self.scene.start
    }

    /// Surface rotation speed of the scene, rad/s.
    pub(crate) fn surface_speed(&self) -> f64 {
        self.scene.surface_speed
    }

    /// What the bit did in the last step.
    pub(crate) fn bit_step(&self) -> Option<&TorqueStep<B::State>> {
        self.now.bit.as_ref()
    }

    /// What the walls did in the last step.
    pub(crate) fn contacts(&self) -> &[Contact] {
        &self.now.contacts
    }

    /// All torques on a site so far, as the reference motion is left by them, N m.
    pub(crate) fn torques(&self, index: usize) -> &[f64] {
        self.torques.loads(0, index)
    }

    /// All forces on a site so far along an axis, disturbances included, N.
    pub(crate) fn forces(&self, axis: usize, site: usize) -> &[f64] {
        (self.lateral.as_ref()).map_or(&[], |lateral| lateral.forces.loads(axis, site))
    }

    /// At the beginning of a block, displacements of all sites through it, x of all sites
    /// and then y, as long as nothing acts.
    pub(crate) fn free_block(&self) -> Option<&[f64]> {
        self.lateral.as_ref()?.forces.next_block()
    }

    /// Where the sites are at the end of a block in which they are at `x` and `y`, a block
    /// each.
    pub(crate) fn end_of_block(&self, x: &[f64], y: &[f64], block: usize) -> Vec<[f64; 2]> {
        let beginnings = self.lateral.iter().flat_map(|lateral| &lateral.positions);
        let sites = x.chunks_exact(block).zip(y.chunks_exact(block));
        let end = |(beginning, (x, y)): (&[f64; 2], (&[f64], &[f64]))| {
            let positions = x.iter().zip(y).map(|(x, y)| [*x, *y]);
            positions.fold(*beginning, |beginning, position| {
                self.system.sampling.end_of_step(position, beginning)
            })
        };
        beginnings.zip(sites).map(end).collect()
    }

    /// Passes a block in which nothing acts on any site, at the end of which the sites
    /// are at `positions`; of its steps only so many are the scene's.
    pub(crate) fn pass_block(&mut self, steps: usize, positions: &[[f64; 2]]) {
        self.coupling.clear();
        self.torques.push_quiet_block();
        if let Some(lateral) = &mut self.lateral {
            lateral.positions.copy_from_slice(positions);
            lateral.sliding_speeds.fill(None);
            lateral.forces.push_quiet_block();
        }
        self.next += steps;
    }
}

/// What some sites have of a list of all.
fn of_sites(sites: &[usize], all: &[f64]) -> Vec<f64> {
    sites.iter().map(|&site| all[site]).collect()
}

impl<'a, W: WallLaw> LateralMotion<'a, W> {
    fn new(
        system: &'a System,
        scene: &'a Lateral<W>,
        steps: usize,
    ) -> Result<Self, SimulationError> {
        let sites = system.sites;
        let channel = (system.from_forces.as_ref()).ok_or(SimulationError::NoForceInput)?;
        if scene.walls.len() != sites {
            let walls = scene.walls.len();
            return Err(SimulationError::NotAWallForEachSite { walls, sites });
        }
        Ok(Self {
            scene,
            channel,
            forces: channel.past(steps),
            positions: vec![[0.0; 2]; sites],
            sliding_speeds: vec![None; sites],
            rotations: vec![0.0; sites],
            external: vec![0.0; 2 * sites],
            free_positions: vec![0.0; 2 * sites],
            step_forces: vec![0.0; 2 * sites],
        })
    }

    fn find_free_motion(&mut self, system: &System, time: f64, last_speeds: &[f64]) {
        let sites = system.sites;
        self.find_external_forces(system, time, last_speeds);
        self.forces.write_past(&mut self.free_positions);
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
    fn find_external_forces(&mut self, system: &System, time: f64, last_speeds: &[f64]) {
        let sites = self.positions.len();
        self.external.fill(0.0);
        let mut add = |site: usize, [x, y]: [f64; 2]| {
            self.external[site] += x;
            self.external[sites + site] += y;
        };
        for impulse in &self.scene.impulses {
            add(impulse.site, impulse.force(time));
        }
        for mass in &self.scene.eccentric_masses {
            let [x, y] = self.positions[mass.site];
            let speed = last_speeds[mass.site];
            let since = system.sampling.moment / system.sampling.frequency;
            let rotation = self.rotations[mass.site] + since * speed;
            add(mass.site, mass.force(x.hypot(y), rotation, speed));
        }
    }

    /// The load line of a site that would be at a position without its own load.
    #[inline]
    fn line(&self, system: &System, site: usize, free_position: [f64; 2]) -> LateralLine {
        LateralLine {
            free_position,
            previous_position: self.positions[site],
            previous_sliding_speed: self.sliding_speeds[site],
            compliance: self.channel.instant(site, site),
            sampling: system.sampling,
        }
    }

    fn end_step<S>(&mut self, system: &System, now: &Step<S>) {
        let sites = system.sites;
        for (site, contact) in now.contacts.iter().enumerate() {
            for axis in 0..2 {
                let place = axis * sites + site;
                self.step_forces[place] = self.external[place] + contact.force[axis];
            }
            self.positions[site] = system
                .sampling
                .end_of_step(contact.position, self.positions[site]);
            self.sliding_speeds[site] = contact.touches().then_some(contact.sliding_speed);
            self.rotations[site] += now.speeds[site] / system.sampling.frequency;
        }
        self.forces.add(&self.step_forces);
    }
}
