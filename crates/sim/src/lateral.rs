//! Eqs. 59–61 with bending: every site in two planes and in torsion, coupled
//! to the wall, step by step.

use linear::{BendingResponses, TorsionResponses};

use crate::error::SimulationError;
use crate::history::partition::FIRST_BLOCK;
use crate::history::{History, Kernels};
use crate::laws::bit::{BitMotion, BitTorque};
use crate::laws::wall::{Approach, Contact, ContactError, Touch};
use crate::regime::BitWatch;
use crate::scene::{Lateral, Scene};
use crate::settling::{Ended, Settling, Stopping};
use crate::stepper::{Outcome, lasts_no_longer, steps_of, surface_steps};
use crate::trajectory::Trajectory;
use crate::whirl::WallWatch;

/// Sites that feel one another within a step are solved in turn until no force
/// would change by more than this fraction of the largest.
const COUPLING_TOLERANCE: f64 = 1e-12;

/// Turns after which sites that do not settle are given up.
const MOST_TURNS: usize = 200;

/// The linear part of a scene with lateral contact, as all cases share it.
/// Every site has a torque input, for friction turns the string.
#[derive(Debug, Clone)]
pub struct LateralSystem {
    sites: usize,
    /// The site that is the bit, where one is.
    bit: Option<usize>,
    step_length: f64,
    /// The longest case, s.
    longest_time: f64,
    surface_step: Vec<Vec<f64>>,
    from_torque: Kernels,
    from_force: Kernels,
}

impl LateralSystem {
    /// Prepares responses for simulations as long as they are.
    ///
    /// # Errors
    /// Where they are not those of a string, some site has no torque input, or the
    /// two parts have different sites or sampling frequencies.
    pub fn new(
        torsion: &TorsionResponses,
        bending: &BendingResponses,
    ) -> Result<Self, SimulationError> {
        torsion.check()?;
        bending.check()?;
        let sites = torsion.sites.len();
        let all_inputs = torsion.torque_inputs.iter().copied().eq(0..sites);
        let alike = torsion.sampling_frequency == bending.sampling_frequency
            && torsion.sites == bending.sites;
        if !all_inputs || !alike {
            return Err(SimulationError::UnlikeParts);
        }
        Ok(Self {
            sites,
            bit: torsion.sites.bit_site(),
            step_length: 1.0 / torsion.sampling_frequency,
            longest_time: torsion.longest_time().min(bending.longest_time()),
            surface_step: surface_steps(torsion),
            from_torque: Kernels::new(&torsion.from_torque),
            from_force: Kernels::new(&bending.from_force),
        })
    }
}

/// What the sites have done so far, and buffers for a step.
struct Run<'a> {
    system: &'a LateralSystem,
    scene: &'a Scene,
    lateral: &'a Lateral,
    /// Torques at the sites.
    torques: History<'a>,
    /// Forces at the sites, along x and along y.
    forces: History<'a>,
    /// The last step's state.
    positions: Vec<[f64; 2]>,
    rotations: Vec<f64>,
    bit_motion: BitMotion,
    /// This step without contact: forces of disturbances, x of all sites and then
    /// y; speeds; displacements, x of all sites and then y.
    external: Vec<f64>,
    free_speeds: Vec<f64>,
    free_positions: Vec<f64>,
    /// This step: loads of every site, force and torque; inputs of both histories.
    loads: Vec<([f64; 2], f64)>,
    /// How much they have changed in the last turn.
    changes: Vec<(f64, f64)>,
    step_torques: Vec<f64>,
    step_forces: Vec<f64>,
    now: Step,
}

/// One step of one site: its contact, its speed (rad/s) and, if it is the bit, how
/// that moves and the torque on it (N m).
type MetSite = (Contact, f64, Option<(BitMotion, f64)>);

/// One step of all sites.
struct Step {
    contacts: Vec<Contact>,
    speeds: Vec<f64>,
    bit: Option<(BitMotion, f64)>,
}

/// Simulates one case with lateral contact, writing its time history into
/// `record` where asked; nothing is left out of that.
///
/// # Errors
/// Where the scene is not one that can be, the system does not fit it, the motion is
/// not finite or coupled sites do not settle.
pub fn simulate_lateral(
    system: &LateralSystem,
    scene: &Scene,
    stopping: Stopping,
    mut record: Option<&mut Trajectory>,
) -> Result<Outcome, SimulationError> {
    let Some(lateral) = &scene.lateral else {
        return Err(SimulationError::UnlikeParts);
    };
    let sites = system.sites;
    if lateral.walls.len() != sites {
        return Err(SimulationError::UnlikeParts);
    }
    if scene.bit.is_some() && system.bit.is_none() {
        return Err(SimulationError::NoTorqueInput);
    }
    scene.check(sites)?;
    lasts_no_longer(scene.timing.duration, system.longest_time)?;
    let stopping = if record.is_some() {
        Stopping::Full
    } else {
        stopping
    };
    let steps = steps_of(scene.timing.duration, system.step_length);
    let mut run = Run::new(system, scene, lateral, steps);
    let mut bit_watch = BitWatch::new(system.step_length, steps, scene.timing.closing_window);
    let mut wall_watch = WallWatch::new(
        sites,
        system.step_length,
        steps,
        scene.timing.closing_window,
    );
    if let Some(record) = record.as_deref_mut() {
        *record = Trajectory::with_sites(sites);
    }
    let mut settling = Settling::new(sites, system.step_length, steps);
    let mut foretold = None;
    let (mut step, mut stepped) = (0, 0);
    while step < steps {
        if stopping != Stopping::Full {
            let passed = run.pass_free_block(step, steps, &mut wall_watch);
            if passed > 0 {
                step += passed;
                settling.skip(passed);
                continue;
            }
        }
        let now = run.step(step)?;
        step += 1;
        stepped = step;
        if let Some((bit, (motion, _))) = system.bit.zip(now.bit) {
            bit_watch.see(motion, now.speeds[bit]);
        }
        wall_watch.see(&now.contacts);
        if let Some(record) = record.as_deref_mut() {
            let torque = now.bit.map(|(_, torque)| torque);
            record.push(&now.speeds, &now.contacts, torque);
        }
        let may_settle = stopping != Stopping::Full && foretold.is_none() && run.may_settle(step);
        if may_settle && settling.see(&run.now.contacts, &lateral.walls) {
            let measures = settling.measures(&wall_watch);
            if stopping == Stopping::Early {
                return Outcome {
                    simulated: (step - 1) as f64 * system.step_length,
                    ended: Ended::Settled,
                    foretold: None,
                    torsion: None,
                    lateral: Some(measures),
                }
                .finite();
            }
            foretold = Some(measures.regime.name());
        }
    }
    if let Some(record) = record {
        record.forces = std::array::from_fn(|axis| {
            let forces = |site| run.forces.inputs(axis, site).to_vec();
            (0..sites).map(forces).collect()
        });
    }
    Outcome {
        simulated: stepped.saturating_sub(1) as f64 * system.step_length,
        ended: if stepped < steps {
            Ended::Certain
        } else {
            Ended::End
        },
        foretold,
        torsion: scene.bit.map(|_| bit_watch.measures()),
        lateral: Some(wall_watch.measures()),
    }
    .finite()
}

impl<'a> Run<'a> {
    fn new(
        system: &'a LateralSystem,
        scene: &'a Scene,
        lateral: &'a Lateral,
        steps: usize,
    ) -> Self {
        let sites = system.sites;
        Self {
            system,
            scene,
            lateral,
            torques: History::new(&system.from_torque, 1, steps),
            forces: History::new(&system.from_force, 2, steps),
            positions: vec![[0.0; 2]; sites],
            rotations: vec![0.0; sites],
            bit_motion: BitMotion::Stuck,
            external: vec![0.0; 2 * sites],
            free_speeds: vec![0.0; sites],
            free_positions: vec![0.0; 2 * sites],
            loads: vec![([0.0; 2], 0.0); sites],
            changes: vec![(0.0, 0.0); sites],
            step_torques: vec![0.0; sites],
            step_forces: vec![0.0; 2 * sites],
            now: Step {
                contacts: vec![Contact::NONE; sites],
                speeds: vec![0.0; sites],
                bit: None,
            },
        }
    }

    fn step(&mut self, step: usize) -> Result<&Step, SimulationError> {
        let sites = self.system.sites;
        let time = step as f64 * self.system.step_length;
        self.find_external_forces(time);
        self.find_free_motion(step);
        self.meet(time)?;
        for site in 0..sites {
            let contact = &self.now.contacts[site];
            let bit_torque = (self.now.bit)
                .filter(|_| self.system.bit == Some(site))
                .map_or(0.0, |bit| bit.1);
            self.step_torques[site] = contact.torque + bit_torque;
            for axis in 0..2 {
                let place = axis * sites + site;
                self.step_forces[place] = self.external[place] + contact.force[axis];
            }
            self.positions[site] = contact.position;
            self.rotations[site] += self.now.speeds[site] * self.system.step_length;
        }
        self.torques.push(&self.step_torques);
        self.forces.push(&self.step_forces);
        if let Some((motion, _)) = self.now.bit {
            self.bit_motion = motion;
        }
        Ok(&self.now)
    }

    /// Whether nothing disturbs the sites from one step to before another.
    fn is_quiet(&self, from: usize, to: usize) -> bool {
        let time = |step: usize| step as f64 * self.system.step_length;
        let mut impulses = self.lateral.impulses.iter();
        self.lateral.eccentric_masses.is_empty()
            && impulses.all(|impulse| impulse.is_quiet(time(from), time(to)))
    }

    /// Whether the motion from a step on can be settled: a bit that cuts has a
    /// regime of its own to wait for.
    fn may_settle(&self, step: usize) -> bool {
        self.scene.bit.is_none()
            && (self.lateral.impulses.iter())
                .all(|impulse| impulse.is_quiet(step as f64 * self.system.step_length, f64::MAX))
    }

    /// Passes a whole block, or what is left of the time, in which nothing
    /// disturbs the sites and none reaches its wall: its motion is known, and the
    /// same as if it were stepped. Returns how many steps that were.
    fn pass_free_block(&mut self, step: usize, steps: usize, watch: &mut WallWatch) -> usize {
        let count = FIRST_BLOCK.min(steps - step);
        if self.scene.bit.is_some() || !self.is_quiet(step, step + FIRST_BLOCK) {
            return 0;
        }
        let Some(motion) = self.forces.next_block() else {
            return 0;
        };
        let (x, y) = motion.split_at(motion.len() / 2);
        let clearances = self.lateral.walls.iter().map(|wall| wall.clearance);
        let blocks = x.chunks_exact(FIRST_BLOCK).zip(y.chunks_exact(FIRST_BLOCK));
        let is_free = blocks.zip(clearances).all(|((x, y), clearance)| {
            // Counted, for the largest of some numbers ignores what is none.
            let radii = (x.iter().zip(y)).map(|(x, y)| x * x + y * y);
            radii
                .filter(|square| *square <= clearance * clearance)
                .count()
                == FIRST_BLOCK
        });
        if !is_free {
            return 0;
        }
        watch.see_free_block(x, y, FIRST_BLOCK, count);
        for (site, position) in self.positions.iter_mut().enumerate() {
            let last = (site + 1) * FIRST_BLOCK - 1;
            *position = [x[last], y[last]];
        }
        self.loads.fill(([0.0; 2], 0.0));
        self.torques.push_quiet_block();
        self.forces.push_quiet_block();
        count
    }

    /// Disturbances of this step; an eccentric mass pulls as the last step
    /// left it.
    fn find_external_forces(&mut self, time: f64) {
        let sites = self.system.sites;
        self.external.fill(0.0);
        let mut add = |site: usize, [x, y]: [f64; 2]| {
            self.external[site] += x;
            self.external[sites + site] += y;
        };
        for impulse in &self.lateral.impulses {
            add(impulse.site, impulse.force(time));
        }
        for mass in &self.lateral.eccentric_masses {
            let [x, y] = self.positions[mass.site];
            let (rotation, speed) = (self.rotations[mass.site], self.now.speeds[mass.site]);
            add(mass.site, mass.force(x.hypot(y), rotation, speed));
        }
    }

    /// Speeds and displacements of this step if nothing touched.
    fn find_free_motion(&mut self, step: usize) {
        let sites = self.system.sites;
        self.torques.past(&mut self.free_speeds);
        for (speed, surface) in self.free_speeds.iter_mut().zip(&self.system.surface_step) {
            *speed += self.scene.surface_speed * surface[step.min(surface.len() - 1)];
        }
        self.forces.past(&mut self.free_positions);
        for (place, position) in self.free_positions.iter_mut().enumerate() {
            let (axis, site) = (place / sites, place % sites);
            for input in 0..sites {
                let force = self.external[axis * sites + input];
                *position += self.system.from_force.instant(site, input) * force;
            }
        }
    }

    /// All sites at once: in turn, each with the others' latest loads, at first
    /// those of the last step, until what has changed of them no longer matters.
    fn meet(&mut self, time: f64) -> Result<(), SimulationError> {
        let sites = self.system.sites;
        for _ in 0..MOST_TURNS {
            let mut largest: f64 = 0.0;
            for site in 0..sites {
                let (contact, speed, torque) = (self.meet_one(site))
                    .map_err(|error| SimulationError::of_contact(error, site, time))?;
                if !speed.is_finite() {
                    return Err(SimulationError::NotFinite { site, time });
                }
                let load = (
                    contact.force,
                    contact.torque + torque.map_or(0.0, |bit| bit.1),
                );
                let before = std::mem::replace(&mut self.loads[site], load);
                self.changes[site] = (
                    (load.0[0] - before.0[0]).abs() + (load.0[1] - before.0[1]).abs(),
                    (load.1 - before.1).abs(),
                );
                largest = largest.max(contact.normal_force);
                self.now.contacts[site] = contact;
                self.now.speeds[site] = speed;
                self.now.bit = torque;
            }
            if self.largest_effect() <= COUPLING_TOLERANCE * largest {
                return Ok(());
            }
        }
        Err(SimulationError::NotSettled { time })
    }

    /// The most that the last changes of the loads change the force at any other
    /// site, N.
    fn largest_effect(&self) -> f64 {
        let (forces, torques) = (&self.system.from_force, &self.system.from_torque);
        let mut largest: f64 = 0.0;
        for site in 0..self.system.sites {
            // A site gives way by its own response, or turns by it.
            let radius = self.lateral.walls[site].radius;
            for (other, (force, torque)) in self.changes.iter().enumerate() {
                if other != site {
                    let pushed = forces.instant(site, other).abs() * force;
                    let turned = torques.instant(site, other).abs() * torque;
                    largest = largest
                        .max(pushed / forces.instant(site, site))
                        .max(turned / (torques.instant(site, site) * radius));
                }
            }
        }
        largest
    }

    /// One site, the loads of the others given: its contact, its speed, and
    /// what the bit does if it is the bit.
    fn meet_one(&self, site: usize) -> Result<MetSite, ContactError> {
        let (system, sites) = (self.system, self.system.sites);
        let mut free_speed = self.free_speeds[site];
        let mut free_position = [0, 1].map(|axis| self.free_positions[axis * sites + site]);
        for (other, (force, torque)) in self.loads.iter().enumerate() {
            if other != site {
                let compliance = system.from_force.instant(site, other);
                free_position[0] += compliance * force[0];
                free_position[1] += compliance * force[1];
                free_speed += system.from_torque.instant(site, other) * torque;
            }
        }
        let torsional_compliance = system.from_torque.instant(site, site);
        let law: Option<BitTorque> = self.scene.bit.filter(|_| system.bit == Some(site));
        let contact = self.lateral.walls[site].meet(&Approach {
            free_position,
            previous_position: self.positions[site],
            free_speed,
            compliance: system.from_force.instant(site, site),
            torsional_compliance,
            sampling_frequency: 1.0 / system.step_length,
            bit: law.map(|law| (law, self.bit_motion)),
        })?;
        let turned = free_speed + torsional_compliance * contact.torque;
        Ok(match law {
            None => (contact, turned, None),
            Some(law) => {
                let step = law.meet(self.bit_motion, turned, torsional_compliance);
                (contact, step.speed, Some((step.motion, step.torque)))
            }
        })
    }
}

/// Whether a contact touches the wall.
pub(crate) fn touches(contact: &Contact) -> bool {
    contact.touch != Touch::Free
}
