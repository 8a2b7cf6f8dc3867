//! Eqs. 59–61, step by step: what the past adds, the load lines that leaves, and the
//! local laws that meet them.
//!
//! The torque on a stuck bit grows at k_eff Ω until it slips (`responses` of a string as in the
//! example of the crate):
//!
//! ```
//! # use linear::{ChannelRequest, Drillstring, Material, Method, Request, Section, Sites, Tube};
//! # let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.1 };
//! # let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! # let string = Drillstring::new(steel, vec![Section { repeat: 50, parts: vec![pipe] }], 10.0)?;
//! # let request = Request {
//! #     sites: Sites::bit(),
//! #     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//! #     sampling_frequency: 640.0,
//! #     longest_time: 20.0,
//! # };
//! # let responses = linear::responses(&string, &Method::Quadrature, &request)?;
//! use linear::estimates::torsional_stiffness;
//! use sim::{BitTorque, Scene, Start, Stepper, System};
//!
//! let bit = BitTorque { torque_static: 1200.0, torque_dynamic: 1000.0, decay_speed: 0.0 };
//! let scene: Scene = Scene {
//!     surface_speed: 0.5,
//!     start: Start::Rest,
//!     bit: Some(bit),
//!     friction: Vec::new(),
//!     axial: None,
//!     lateral: None,
//!     timing: sim::torsion_timing(&string, 0.5, &bit, &Start::Rest),
//! };
//! let system = System::new(&responses)?;
//! let mut stepper = Stepper::new(&system, &scene)?;
//! let mut first_slip = None;
//! while let Some(step) = stepper.step()? {
//!     if step.speeds[0] > 0.0 && first_slip.is_none() {
//!         first_slip = Some(step.time);
//!     }
//! }
//! let winding = 1200.0 / (0.5 * torsional_stiffness(&string));
//! let first_slip = first_slip.ok_or("it slips")?;
//! assert!((first_slip - winding).abs() < 0.4, "{first_slip} {winding}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod met;
mod seen;

use linear::SteadyMotion;
use pulp::Arch;

use crate::axial_motion::AxialMotion;
use crate::coupling::Coupling;
use crate::error::SimulationError;
use crate::lateral_motion::LateralMotion;
use crate::laws::bit::BitTorque;
use crate::laws::contact::{Contact, WallLaw};
use crate::laws::cutting::CutStep;
use crate::laws::motor::MotorMotion;
use crate::laws::pipe::{OnLines, PipeFriction, PipeMotion};
use crate::laws::torque::{TorqueLaw, TorqueStep};
use crate::laws::wall::Wall;
use crate::limited_drive::DriveMotion;
use crate::line::pieces::SurfaceStep;
use crate::line::{TorsionPast, Within};
use crate::scene::Scene;
use crate::start::Start;
use crate::system::System;

/// One step of all sites that may bear a load.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Step<S> {
    /// Time, s.
    pub time: f64,
    /// Rotation speeds of the sites that a torque may act on, rad/s; below a motor the bit has its own.
    pub speeds: Vec<f64>,
    /// What each site does at its wall; nothing without walls.
    pub contacts: Vec<Contact>,
    /// What the bit does, where a law acts there.
    pub bit: Option<TorqueStep<S>>,
    /// What a bit that cuts does.
    pub cut: Option<CutStep>,
    /// How the pipe rubs at each site that a torque may act on; nothing where it rubs nowhere.
    pub rubbing: Vec<PipeMotion>,
    /// What turns the surface, where the string is in pieces or its drive's torque limited.
    pub surface: Option<SurfaceStep>,
}

/// A scene under way, one step after the other, against its linear system.
#[derive(Debug)]
pub struct Stepper<'a, B: TorqueLaw = BitTorque, W: WallLaw = Wall> {
    system: &'a System,
    scene: &'a Scene<B, W>,
    /// The law of the bit, and its port.
    bit: Option<(&'a B, usize)>,
    acting: Acting,
    /// What instructions the processor has.
    arch: Arch,
    /// The friction of each port on its load lines; nothing where the string rubs nowhere.
    friction: Vec<Option<OnLines>>,
    reference: Reference<'a>,
    /// The torque that holds the bit fast in this step, N m, where it is held.
    held: f64,
    /// The next step, and how many there are.
    next: usize,
    steps: usize,
    within: Within<'a>,
    torsion: TorsionPast<'a>,
    lateral: Option<LateralMotion<'a, W>>,
    /// Axial motion above a bit that cuts, and its port.
    axial: Option<(AxialMotion<'a>, usize)>,
    /// What turns the bit against the string's end.
    motor: Option<MotorMotion>,
    /// What turns the surface, where its torque is limited.
    drive: Option<DriveMotion<'a>>,
    coupling: Coupling<'a>,
    bit_state: B::State,
    /// How the pipe rubbed in the last step.
    rubbed: Vec<PipeMotion>,
    /// How fast what is at the wall of each port turned in the last step, rad/s, where the bit turns below a
    /// motor; else the string is at all walls.
    turned: Option<Vec<f64>>,
    /// What the ports do in this step without its loads.
    free: Vec<f64>,
    step_torques: Vec<f64>,
    now: Step<B::State>,
}

/// The laws that act on a string. Steps of plain scenes do not pay for the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Acting {
    /// The law of its bit.
    Bit,
    /// Walls.
    Walls,
    /// Anything, below a drive or above a motor.
    Any,
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
        let (sites, loaded) = (system.sites.len(), system.torsion.loaded());
        let bending = system.from_forces.as_ref();
        scene.check(sites, bending.map_or(sites, |_| system.walls.len()))?;
        system.lasts_for(scene.timing.duration)?;
        let bit = match &scene.bit {
            None => None,
            Some(law) => {
                let port = system.bit_port().ok_or(SimulationError::NoTorqueInput)?;
                Some((law, port))
            }
        };
        let speeds = match reference {
            Reference::Free | Reference::Stuck(_) => vec![0.0; loaded.len()],
            Reference::Steady(motion) => of_sites(loaded, &motion.speeds),
        };
        let motor = system.motor(scene, &speeds);
        let mut turned = speeds.clone();
        if let (Some(motor), Some(port)) = (&motor, system.bit_port()) {
            turned[port] = motor.bit_speed();
        }
        let within = system.torsion.within();
        let steps = system.steps_of(scene.timing.duration);
        let axial = match &scene.axial {
            None => None,
            Some(axial) => {
                let port = system.bit_port().ok_or(SimulationError::NoTorqueInput)?;
                let speed = scene.start.steady().map(|_| turned[port]);
                Some((AxialMotion::new(system, axial, speed, steps)?, port))
            }
        };
        let lateral = (scene.lateral.as_ref())
            .map(|lateral| LateralMotion::new(system, lateral, steps))
            .transpose()?;
        let drive = system.limited_drive(scene, steps);
        let friction = friction(scene, within)?;
        let walls = (scene.lateral.as_ref()).map_or(&[][..], |lateral| &lateral.walls);
        let radii: Vec<f64> = walls.iter().map(WallLaw::radius).collect();
        let bit_state = bit.map(|(law, port)| law.turning_at(turned[port]));
        let mut coupling = Coupling::new(within, bending, (&system.walls, &radii));
        coupling.begin_at(&speeds);
        let rubbed = vec![PipeMotion::default(); friction.len()];
        let is_plain = axial.is_none() && friction.is_empty() && motor.is_none() && drive.is_none();
        let acting = match (within, &bit, &lateral) {
            (Within::All(_), Some(_), None) if is_plain => Acting::Bit,
            (Within::All(_), None, Some(_)) if is_plain => Acting::Walls,
            _ => Acting::Any,
        };
        Ok(Self {
            system,
            scene,
            bit,
            acting,
            arch: Arch::new(),
            friction,
            reference,
            held: 0.0,
            next: first,
            steps,
            within,
            torsion: system.torsion.past(steps - first.min(steps)),
            lateral,
            axial,
            motor,
            drive,
            coupling,
            bit_state: bit_state.unwrap_or_default(),
            rubbed: rubbed.clone(),
            turned: motor.map(|_| turned),
            free: vec![0.0; loaded.len()],
            step_torques: vec![0.0; loaded.len()],
            now: Step {
                time: 0.0,
                speeds,
                contacts: vec![Contact::NONE; walls.len()],
                bit: None,
                cut: None,
                rubbing: rubbed,
                surface: None,
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
        match self.acting {
            Acting::Bit => self.step_of::<true>()?,
            Acting::Walls | Acting::Any => self.step_of::<false>()?,
        }
        self.next += 1;
        Ok(Some(&self.now))
    }

    /// A step; `BIT` where the bit acts alone.
    #[inline]
    fn step_of<const BIT: bool>(&mut self) -> Result<(), SimulationError> {
        self.now.time = self.system.sampling.time_of(self.next);
        self.find_free_motion::<BIT>();
        match (self.within, &self.lateral) {
            (Within::All(torsion), _) if BIT => self.meet_bit_alone(torsion)?,
            _ if self.acting == Acting::Walls => self.meet_walls()?,
            // No other port has to agree with the bit.
            (Within::All(torsion), None) if self.friction.is_empty() => self.meet_bit(torsion)?,
            _ if self.drive.is_some() => self.meet_all_and_drive()?,
            _ => self.meet_all::<false>()?,
        }
        if let (Some((axial, _)), Some(cut), false) = (&self.axial, &self.now.cut, BIT) {
            if axial.passes_a_blade(cut.speed) {
                let time = self.now.time;
                return Err(SimulationError::PastABlade { time });
            }
        }
        self.end_step::<BIT>();
        Ok(())
    }

    /// What ports and walls do in this step if no law answered.
    #[inline]
    fn find_free_motion<const BIT: bool>(&mut self) {
        let (scene, step) = (self.scene, self.next);
        let surface_speed = match self.reference {
            Reference::Free => Some(scene.surface_speed),
            Reference::Stuck(_) | Reference::Steady(_) => None,
        };
        self.torsion.write_free(step, surface_speed, &mut self.free);
        match self.reference {
            Reference::Free => {}
            Reference::Stuck(stuck) => {
                self.held = scene.surface_speed * stuck[step];
                self.free[0] -= self.within.compliance(0) * self.held;
            }
            Reference::Steady(motion) => self.add_steady_motion(motion),
        }
        if BIT {
            return;
        }
        if let Some(lateral) = &mut self.lateral {
            let turned = self.turned.as_ref().unwrap_or(&self.now.speeds);
            lateral.find_free_motion(self.now.time, turned);
            for (port, torque) in lateral.resting_torques() {
                self.within.turn_by(port, -torque, &mut self.free);
            }
        }
        if self.acting == Acting::Any {
            self.find_axial_motion();
            self.find_free_drive();
        }
    }

    /// The same of a drive whose torque is limited: what acts on ports without their laws turns it, too.
    #[inline]
    fn find_free_drive(&mut self) {
        let Some(drive) = &mut self.drive else {
            return;
        };
        let lateral = self.lateral.iter();
        let resting = lateral.flat_map(LateralMotion::resting_torques);
        let acting = resting.map(|(port, torque)| (port, -torque));
        let at_bit = acts_at_bit(self.bit, self.axial.as_ref())
            .map(|port| (port, kick_of(self.axial.as_ref()) - self.held));
        let step = (self.next, self.now.time);
        drive.find_free_motion(step, acting.chain(at_bit), &mut self.free);
    }

    /// The same along the axis; a disturbance turns the bit, too.
    #[inline]
    fn find_axial_motion(&mut self) {
        let Some((axial, port)) = &mut self.axial else {
            return;
        };
        axial.find_free_motion(self.next, self.now.time);
        let kick = axial.kick();
        if kick == 0.0 {
            return;
        }
        self.within.turn_by(*port, kick, &mut self.free);
    }

    /// The motion that the scene began with, without the torque that holds or brakes the bit in it.
    #[inline]
    fn add_steady_motion(&mut self, motion: &SteadyMotion) {
        let loaded = self.system.torsion.loaded();
        let at_bit = self.bit_port();
        if at_bit.is_some() {
            self.held = motion.at_bit.at(self.now.time);
        }
        match self.within {
            Within::All(torsion) => {
                for (speed, site) in self.free.iter_mut().zip(loaded) {
                    *speed += motion.speeds[*site];
                }
                if let Some(port) = at_bit {
                    for (index, speed) in self.free.iter_mut().enumerate() {
                        *speed -= torsion.instant(index, port) * self.held;
                    }
                }
            }
            Within::Chain(chain) => {
                for (port, driving) in self.free.iter_mut().enumerate() {
                    *driving += chain.taken(port, &motion.speeds);
                }
                if let Some(port) = at_bit {
                    self.free[port] -= self.held;
                }
            }
        }
    }

    /// From this step to the past.
    #[inline]
    fn end_step<const BIT: bool>(&mut self) {
        let loads = self.coupling.loads();
        for (torque, load) in self.step_torques.iter_mut().zip(loads) {
            *torque = load.torque;
        }
        let axial = self.axial.as_ref().filter(|_| !BIT);
        if let Some(port) = acts_at_bit(self.bit, axial) {
            self.step_torques[port] += kick_of(axial) - self.held;
        }
        if !BIT {
            let resting = self.lateral.iter().flat_map(LateralMotion::resting_torques);
            for (port, torque) in resting {
                self.step_torques[port] -= torque;
            }
        }
        let steady = match self.reference {
            Reference::Steady(motion) => Some(motion),
            Reference::Free | Reference::Stuck(_) => None,
        };
        let speeds = steady.map(|motion| motion.speeds.as_slice());
        (self.torsion).end_step(self.next, &self.step_torques, (&self.now.speeds, speeds));
        if !BIT {
            if self.acting == Acting::Any {
                self.end_step_of_others(steady);
            }
            if let Some(lateral) = &mut self.lateral {
                let turned = self.turned.as_ref().unwrap_or(&self.now.speeds);
                lateral.end_step(&self.now.contacts, turned);
            }
        }
        if let Some(bit) = &self.now.bit {
            self.bit_state.clone_from(&bit.state);
        }
    }

    /// The end of a step for all that is not there where the bit or walls act alone.
    #[inline]
    fn end_step_of_others(&mut self, steady: Option<&SteadyMotion>) {
        let bit_speed = self.bit_motion();
        if let (Some((axial, _)), Some(cut)) = (&mut self.axial, &self.now.cut) {
            axial.end_step(cut);
        }
        let of_line = self.torsion.surface().map(|surface| match steady {
            None => surface,
            Some(motion) => SurfaceStep {
                speed: surface.speed + self.scene.surface_speed,
                torque: surface.torque + motion.at_surface.at(self.now.time),
            },
        });
        let torques = self.step_torques.as_slice();
        let of_drive = self.drive.as_mut().map(|drive| drive.end_step(torques));
        self.now.surface = of_drive.or(of_line);
        let at_bit = self.bit_port();
        if let (Some(motor), Some(turned)) = (&mut self.motor, &mut self.turned) {
            turned.copy_from_slice(&self.now.speeds);
            if let (Some((_, speed)), Some(port)) = (bit_speed, at_bit) {
                motor.end_step(speed);
                turned[port] = speed;
            }
        }
        if !self.rubbed.is_empty() {
            self.rubbed.copy_from_slice(&self.now.rubbing);
        }
    }

    /// The port of the bit, where a law acts there.
    fn bit_port(&self) -> Option<usize> {
        acts_at_bit(self.bit, self.axial.as_ref())
    }

    /// Passes a block in which nothing acts on any site, at the end of which the sites
    /// are at `positions`; of its steps only `steps` belong to the scene.
    pub(crate) fn pass_block(&mut self, steps: usize, positions: &[[f64; 2]]) {
        self.coupling.clear();
        self.torsion.push_quiet_block();
        if let Some(lateral) = &mut self.lateral {
            lateral.pass_block(positions);
        }
        self.next += steps;
    }
}

/// The port of the bit, where a law acts there.
fn acts_at_bit<B>(bit: Option<(&B, usize)>, axial: Option<&(AxialMotion, usize)>) -> Option<usize> {
    let cuts = axial.map(|(_, port)| *port);
    bit.map(|(_, port)| port).or(cuts)
}

/// The torque of a disturbance on a bit that cuts, N m.
fn kick_of(axial: Option<&(AxialMotion, usize)>) -> f64 {
    axial.map_or(0.0, |(axial, _)| axial.kick())
}

/// What some sites have of a list of all.
fn of_sites(sites: &[usize], all: &[f64]) -> Vec<f64> {
    sites.iter().map(|&site| all[site]).collect()
}

/// The friction of each port on its load lines.
fn friction<B, W>(
    scene: &Scene<B, W>,
    within: Within,
) -> Result<Vec<Option<OnLines>>, SimulationError> {
    let (friction, sites) = (scene.friction.len(), within.ports());
    if friction == 0 {
        return Ok(Vec::new());
    }
    if friction != sites {
        return Err(SimulationError::NotFrictionForEachSite { friction, sites });
    }
    if scene.start != Start::Rest {
        return Err(SimulationError::SteadyWithFriction);
    }
    let on_lines = |(port, law): (usize, &Option<PipeFriction>)| {
        law.map(|law| law.on_lines(within.compliance(port)))
    };
    Ok(scene.friction.iter().enumerate().map(on_lines).collect())
}
