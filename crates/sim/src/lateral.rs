//! Eqs. 59–61 with bending: every site in two planes and in torsion, coupled
//! to the wall, step by step.

use linear::{BendingResponses, TorsionResponses};

use crate::history::Kernel;
use crate::laws::bit::{BitMotion, BitTorque};
use crate::laws::wall::{Approach, Contact, Touch};
use crate::regime::BitWatch;
use crate::scene::{Lateral, Scene};
use crate::stepper::{Outcome, SimulationError, surface_steps};
use crate::trajectory::Trajectory;
use crate::whirl::WallWatch;

/// Sites that touch one another within a step are solved in turn until no force
/// changes by more than this fraction.
const COUPLING_TOLERANCE: f64 = 1e-12;

/// Turns after which sites that do not settle are given up.
const MOST_TURNS: usize = 200;

/// The linear part of a scene with lateral contact, as all cases share it.
/// Every site has a torque input, for friction turns the string.
#[derive(Debug, Clone)]
pub struct LateralSystem {
    step_length: f64,
    surface_step: Vec<Vec<f64>>,
    /// `[site][input]`.
    from_torque: Vec<Vec<Kernel>>,
    /// `[site][input]`.
    from_force: Vec<Vec<Kernel>>,
}

impl LateralSystem {
    /// Prepares responses for simulation.
    ///
    /// # Errors
    /// Where some site has no torque input, or the two parts have different
    /// sites or sampling frequencies.
    pub fn new(
        torsion: &TorsionResponses,
        bending: &BendingResponses,
    ) -> Result<Self, SimulationError> {
        let sites = torsion.from_surface.len();
        let all_inputs = torsion.torque_inputs.iter().copied().eq(0..sites);
        let alike = torsion.sampling_frequency == bending.sampling_frequency
            && bending.from_force.len() == sites;
        if !all_inputs || !alike {
            return Err(SimulationError::UnlikeParts);
        }
        let kernels = |responses: &[Vec<Vec<f64>>]| -> Vec<Vec<Kernel>> {
            responses
                .iter()
                .map(|inputs| inputs.iter().map(|taps| Kernel::new(taps)).collect())
                .collect()
        };
        Ok(Self {
            step_length: 1.0 / torsion.sampling_frequency,
            surface_step: surface_steps(torsion),
            from_torque: kernels(&torsion.from_torque),
            from_force: kernels(&bending.from_force),
        })
    }
}

/// What the sites have done so far.
struct Run<'a> {
    system: &'a LateralSystem,
    scene: &'a Scene,
    lateral: &'a Lateral,
    /// Inputs of each site, one entry a step.
    torques: Vec<Vec<f64>>,
    forces: [Vec<Vec<f64>>; 2],
    /// The last step's state.
    positions: Vec<[f64; 2]>,
    speeds: Vec<f64>,
    rotations: Vec<f64>,
    bit_motion: BitMotion,
}

/// One step of all sites.
struct Step {
    contacts: Vec<Contact>,
    speeds: Vec<f64>,
    bit: Option<(BitMotion, f64)>,
}

/// Simulates one case with lateral contact, writing its time history into
/// `record` where asked.
///
/// # Errors
/// Where the motion is not finite or coupled sites do not settle.
pub fn simulate_lateral(
    system: &LateralSystem,
    scene: &Scene,
    mut record: Option<&mut Trajectory>,
) -> Result<Outcome, SimulationError> {
    let Some(lateral) = &scene.lateral else {
        return Err(SimulationError::UnlikeParts);
    };
    let sites = system.from_force.len();
    if lateral.walls.len() != sites {
        return Err(SimulationError::UnlikeParts);
    }
    let steps = (scene.timing.duration / system.step_length).ceil() as usize + 1;
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
    for step in 0..steps {
        let now = run.step(step)?;
        if let Some((motion, _)) = now.bit {
            bit_watch.see(motion, now.speeds[sites - 1]);
        }
        wall_watch.see(&now.contacts);
        if let Some(record) = record.as_deref_mut() {
            record.push(
                &now.speeds,
                &now.contacts,
                now.bit.map(|(_, torque)| torque),
            );
        }
    }
    if let Some(record) = record {
        record.forces = run.forces;
    }
    Ok(Outcome {
        simulated: (steps - 1) as f64 * system.step_length,
        torsion: scene.bit.map(|_| bit_watch.measures()),
        lateral: Some(wall_watch.measures()),
    })
}

impl<'a> Run<'a> {
    fn new(
        system: &'a LateralSystem,
        scene: &'a Scene,
        lateral: &'a Lateral,
        steps: usize,
    ) -> Self {
        let sites = system.from_force.len();
        let inputs = || vec![Vec::with_capacity(steps); sites];
        Self {
            system,
            scene,
            lateral,
            torques: inputs(),
            forces: [inputs(), inputs()],
            positions: vec![[0.0; 2]; sites],
            speeds: vec![0.0; sites],
            rotations: vec![0.0; sites],
            bit_motion: BitMotion::Stuck,
        }
    }

    fn step(&mut self, step: usize) -> Result<Step, SimulationError> {
        let sites = self.positions.len();
        let time = step as f64 * self.system.step_length;
        let external = self.external_forces(time);
        let free_speeds: Vec<f64> = (0..sites).map(|site| self.free_speed(site, step)).collect();
        let free_positions: Vec<[f64; 2]> = (0..sites)
            .map(|site| self.free_position(site, &external))
            .collect();
        let now = self.meet(&free_speeds, &free_positions, time)?;
        for site in 0..sites {
            let contact = &now.contacts[site];
            let bit_torque = now
                .bit
                .filter(|_| site == sites - 1)
                .map_or(0.0, |bit| bit.1);
            self.torques[site].push(contact.torque + bit_torque);
            for axis in 0..2 {
                self.forces[axis][site].push(external[site][axis] + contact.force[axis]);
            }
            self.positions[site] = contact.position;
            self.speeds[site] = now.speeds[site];
            self.rotations[site] += now.speeds[site] * self.system.step_length;
        }
        if let Some((motion, _)) = now.bit {
            self.bit_motion = motion;
        }
        Ok(now)
    }

    /// Disturbances of this step; an eccentric mass pulls as the last step
    /// left it.
    fn external_forces(&self, time: f64) -> Vec<[f64; 2]> {
        let mut forces = vec![[0.0; 2]; self.positions.len()];
        let mut add = |site: usize, [x, y]: [f64; 2]| {
            forces[site][0] += x;
            forces[site][1] += y;
        };
        for impulse in &self.lateral.impulses {
            add(impulse.site, impulse.force(time));
        }
        for mass in &self.lateral.eccentric_masses {
            let [x, y] = self.positions[mass.site];
            let (rotation, speed) = (self.rotations[mass.site], self.speeds[mass.site]);
            add(mass.site, mass.force(x.hypot(y), rotation, speed));
        }
        forces
    }

    fn free_speed(&self, site: usize, step: usize) -> f64 {
        let surface = &self.system.surface_step[site];
        let from_surface = self.scene.surface_speed * surface[step.min(surface.len() - 1)];
        let kernels = self.system.from_torque[site].iter().zip(&self.torques);
        from_surface
            + kernels
                .map(|(kernel, torques)| kernel.past_sum(torques))
                .sum::<f64>()
    }

    fn free_position(&self, site: usize, external: &[[f64; 2]]) -> [f64; 2] {
        std::array::from_fn(|axis| {
            let kernels = self.system.from_force[site].iter().zip(&self.forces[axis]);
            let past: f64 = kernels
                .map(|(kernel, forces)| kernel.past_sum(forces))
                .sum();
            let now: f64 = (self.system.from_force[site].iter())
                .zip(external)
                .map(|(kernel, force)| kernel.instant() * force[axis])
                .sum();
            past + now
        })
    }

    /// All sites at once: in turn, each with the others' latest loads, until
    /// none changes.
    fn meet(
        &self,
        free_speeds: &[f64],
        free_positions: &[[f64; 2]],
        time: f64,
    ) -> Result<Step, SimulationError> {
        let sites = free_speeds.len();
        let mut loads = vec![([0.0; 2], 0.0); sites];
        let mut contacts: Vec<Option<Contact>> = vec![None; sites];
        let mut speeds = vec![0.0; sites];
        let mut bit = None;
        for _ in 0..MOST_TURNS {
            let mut largest: f64 = 0.0;
            let mut change: f64 = 0.0;
            for site in 0..sites {
                let (contact, speed, torque) =
                    self.meet_one(site, free_speeds, free_positions, &loads);
                if !(speed.is_finite() && contact.normal_force.is_finite()) {
                    return Err(SimulationError::NotFinite { time });
                }
                let load = (
                    contact.force,
                    contact.torque + torque.map_or(0.0, |bit| bit.1),
                );
                let before: ([f64; 2], f64) = loads[site];
                largest = largest.max(contact.normal_force);
                change = change
                    .max((load.0[0] - before.0[0]).abs())
                    .max((load.0[1] - before.0[1]).abs());
                loads[site] = load;
                contacts[site] = Some(contact);
                speeds[site] = speed;
                bit = torque.or(bit);
            }
            if sites == 1 || change <= COUPLING_TOLERANCE * largest {
                return Ok(Step {
                    contacts: contacts.into_iter().flatten().collect(),
                    speeds,
                    bit,
                });
            }
        }
        Err(SimulationError::NotSettled { time })
    }

    /// One site, the loads of the others given: its contact, its speed, and
    /// what the bit does if it is the bit.
    fn meet_one(
        &self,
        site: usize,
        free_speeds: &[f64],
        free_positions: &[[f64; 2]],
        loads: &[([f64; 2], f64)],
    ) -> (Contact, f64, Option<(BitMotion, f64)>) {
        let mut free_speed = free_speeds[site];
        let mut free_position = free_positions[site];
        for (other, (force, torque)) in loads.iter().enumerate() {
            if other != site {
                let compliance = self.system.from_force[site][other].instant();
                free_position[0] += compliance * force[0];
                free_position[1] += compliance * force[1];
                free_speed += self.system.from_torque[site][other].instant() * torque;
            }
        }
        let torsional_compliance = self.system.from_torque[site][site].instant();
        let is_bit = site + 1 == free_speeds.len();
        let law: Option<BitTorque> = self.scene.bit.filter(|_| is_bit);
        let contact = self.lateral.walls[site].meet(&Approach {
            free_position,
            previous_position: self.positions[site],
            free_speed,
            compliance: self.system.from_force[site][site].instant(),
            torsional_compliance,
            sampling_frequency: 1.0 / self.system.step_length,
            bit: law.map(|law| (law, self.bit_motion)),
        });
        let turned = free_speed + torsional_compliance * contact.torque;
        match law {
            None => (contact, turned, None),
            Some(law) => {
                let step = law.meet(self.bit_motion, turned, torsional_compliance);
                (contact, step.speed, Some((step.motion, step.torque)))
            }
        }
    }
}

/// Whether a contact touches the wall.
pub(crate) fn touches(contact: &Contact) -> bool {
    contact.touch != Touch::Free
}
