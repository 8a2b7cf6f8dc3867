//! The time history of one case, kept only where it is asked for.
//!
//! The motion of a case with `responses` of a string as in the example of the crate:
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
//! use sim::{BitTorque, Scene, Simulator, Start, Stopping, Trajectory};
//!
//! let bit = BitTorque { torque_static: 1200.0, torque_dynamic: 1000.0, decay_speed: 0.0 };
//! let scene = Scene {
//!     surface_speed: 0.5,
//!     start: Start::Rest,
//!     bit: Some(bit),
//!     friction: Vec::new(),
//!     axial: None,
//!     lateral: None,
//!     timing: sim::torsion_timing(&string, 0.5, &bit, &Start::Rest),
//! };
//! let mut motion = Trajectory::default();
//! let simulator = Simulator::new(&responses)?;
//! simulator.simulate(&scene, Stopping::Early, Some(&mut motion))?;
//! let samples = motion.speeds[0].iter().zip(&motion.bit_torque);
//! // It stands still below the static torque, and turns against the dynamic one.
//! for (speed, torque) in samples {
//!     let is_stuck = *speed == 0.0 && torque.abs() <= 1200.0;
//!     assert!(is_stuck || *speed > 0.0 && *torque == -1000.0);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::borrow::Cow;

use linear::budget::REAL;

use crate::laws::contact::{Touch, WallLaw};
use crate::laws::cutting::CutStep;
use crate::laws::torque::TorqueLaw;
use crate::scene::Scene;
use crate::stepper::Stepper;
use crate::system::System;

/// One entry a step; sites from the surface down.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Trajectory {
    /// Time of each step, s.
    pub times: Vec<f64>,
    /// Rotation speed of each site, rad/s.
    pub speeds: Vec<Vec<f64>>,
    /// Torque on the bit, positive in the direction of rotation, N m; empty
    /// where the bit is free.
    pub bit_torque: Vec<f64>,
    /// Torque that a motor above the bit passes on, N m; empty without one.
    pub mud_motor_torque: Vec<f64>,
    /// What a bit that cuts does; empty without axial motion.
    pub cut: Vec<CutStep>,
    /// Weight on a bit that cuts of the steady drilling that the case began with, N; zero where it began
    /// at rest.
    pub weight_at_start: f64,
    /// Torque with which the surface is turned, below a top drive that of its motor, N m; empty
    /// unless it is asked for ([`crate::SurfaceTorque`]).
    pub surface_torque: Vec<f64>,
    /// Torque of all laws on each site that one may act on, N m; empty unless the string rubs along
    /// its well by responses of the whole string, from which the surface torque then follows.
    pub site_torques: Vec<Vec<f64>>,
    /// Speed of the surface, rad/s; empty where it is not followed.
    pub surface_speed: Vec<f64>,
    /// Position of each site's centre, m; empty without lateral motion.
    pub positions: Vec<Vec<[f64; 2]>>,
    /// Force of the wall on each site, N; empty without lateral motion.
    pub wall_forces: Vec<Vec<[f64; 2]>>,
    /// How each site meets its wall; empty without lateral motion.
    pub touches: Vec<Vec<Touch>>,
    /// Normal force F_N of the wall on each site, N, zero where it does not touch; empty
    /// without lateral motion.
    pub normal_forces: Vec<Vec<f64>>,
    /// Torque of its friction on each site, N m; empty without lateral motion.
    pub wall_torques: Vec<Vec<f64>>,
    /// All forces on each site, disturbances included, as
    /// `forces[axis][site][step]`, N; empty without lateral motion.
    pub forces: [Vec<Vec<f64>>; 2],
}

/// Numbers for each site and step with lateral motion: speed, position, force, normal force and
/// torque of the wall, all forces; and a byte of how it touches.
const RECORDED: f64 = 9.0 + 1.0 / REAL;

impl Trajectory {
    /// Sampling frequency, Hz, of two steps or more.
    pub fn sampling_frequency(&self) -> Option<f64> {
        let (first, last) = (self.times.first()?, self.times.last()?);
        (last > first).then(|| (self.times.len() - 1) as f64 / (last - first))
    }

    /// Bytes of a number of sites, with lateral motion or without, and a number of steps.
    pub fn bytes(sites: usize, is_lateral: bool, steps: f64) -> f64 {
        let recorded = if is_lateral { RECORDED } else { 1.0 };
        REAL * steps * (1.0 + recorded * sites as f64)
    }

    /// Torque on the lower end of the string, positive in the direction of rotation, N m: that on the
    /// bit, or what a motor above the bit leaves to the string.
    pub fn torque_on_string(&self) -> Cow<'_, [f64]> {
        match self.mud_motor_torque.is_empty() {
            true => Cow::Borrowed(&self.bit_torque),
            false => Cow::Owned(self.mud_motor_torque.iter().map(|torque| -torque).collect()),
        }
    }

    /// Begins a case whose bit is held fast at first, by these torques per unit of
    /// surface speed; speeds are kept of the sites that may bear a load.
    pub(crate) fn begin<B, W>(&mut self, system: &System, scene: &Scene<B, W>, held: &[f64]) {
        let walls = scene
            .lateral
            .as_ref()
            .map_or(0, |lateral| lateral.walls.len());
        // Of pieces the torque that turns the surface is known without these.
        let followed = system.torsion.whole().map_or(0, |_| scene.friction.len());
        *self = Self {
            times: Vec::new(),
            speeds: vec![vec![0.0; held.len()]; system.torsion.loaded().len()],
            bit_torque: held.iter().map(|held| scene.surface_speed * held).collect(),
            mud_motor_torque: Vec::new(),
            cut: Vec::new(),
            weight_at_start: 0.0,
            surface_torque: Vec::new(),
            site_torques: vec![Vec::new(); followed],
            surface_speed: Vec::new(),
            positions: vec![Vec::new(); walls],
            wall_forces: vec![Vec::new(); walls],
            touches: vec![Vec::new(); walls],
            normal_forces: vec![Vec::new(); walls],
            wall_torques: vec![Vec::new(); walls],
            forces: Default::default(),
        };
    }

    pub(crate) fn push<B: TorqueLaw, W: WallLaw>(&mut self, stepper: &Stepper<B, W>) {
        let now = stepper.now();
        for (torques, load) in self.site_torques.iter_mut().zip(stepper.loads()) {
            torques.push(load.torque);
        }
        for (speeds, speed) in self.speeds.iter_mut().zip(&now.speeds) {
            speeds.push(*speed);
        }
        if let Some((port, speed, torque)) = stepper.below_motor() {
            self.mud_motor_torque.push(torque);
            if let Some(last) = self.speeds[port].last_mut() {
                *last = speed;
            }
        }
        for (site, contact) in now.contacts.iter().enumerate() {
            self.positions[site].push(contact.position);
            self.wall_forces[site].push(contact.force);
            self.touches[site].push(contact.touch);
            self.normal_forces[site].push(contact.normal_force);
            self.wall_torques[site].push(contact.torque);
        }
        self.bit_torque.extend(stepper.bit_torque());
        self.cut.extend(now.cut);
        self.surface_torque
            .extend(now.surface.map(|surface| surface.torque));
        self.surface_speed
            .extend(now.surface.map(|surface| surface.speed));
    }

    /// Adds the times, the speeds of the other sites, and the forces.
    pub(crate) fn finish<B: TorqueLaw, W: WallLaw>(
        &mut self,
        system: &System,
        scene: &Scene<B, W>,
        stepper: &Stepper<B, W>,
    ) {
        self.weight_at_start = stepper.weight_at_start();
        let steps = stepper.steps();
        self.times = (0..steps)
            .map(|step| system.sampling.time_of(step))
            .collect();
        let loaded = std::mem::take(&mut self.speeds);
        let acts =
            scene.turns_against_rock() || scene.lateral.is_some() || !scene.friction.is_empty();
        let is_whole = acts && loaded.len() == system.sites.len();
        let on_string = self.torque_on_string();
        let driven = (!is_whole)
            .then(|| system.driven_speeds(scene.surface_speed, &scene.start, &on_string, steps));
        self.speeds = match driven.flatten() {
            None => loaded,
            Some(mut speeds) => {
                let sites = system.torsion.loaded().iter();
                for (site, loaded) in sites.zip(loaded).filter(|_| acts) {
                    speeds[*site] = loaded;
                }
                speeds
            }
        };
        if scene.lateral.is_some() {
            self.forces = std::array::from_fn(|axis| {
                let forces = |site| stepper.forces(axis, site).to_vec();
                (0..system.walls.len()).map(forces).collect()
            });
        }
    }
}
