//! One case of a string in pieces, from rest to its end.

use linear::Cascade;

use super::scene::{CascadeScene, NodeTorque};
use super::stepper::{CascadeStep, CascadeStepper};
use super::system::CascadeSystem;
use crate::error::SimulationError;
use crate::outcome::{Ended, Outcome};
use crate::surface::SurfaceProfile;
use crate::trajectory::Trajectory;
use crate::watch::along::StringTorqueWatch;
use crate::watch::rules::Rules;
use crate::watch::surface::SurfaceWatch;
use crate::watch::torsion::BitWatch;

/// A string in pieces with what is known of all its cases.
#[derive(Debug, Clone)]
pub struct CascadeSimulator {
    system: CascadeSystem,
    follows_torque: bool,
}

impl CascadeSimulator {
    /// Prepares a string for cases as long as it was cut for, whose surface turns by a profile.
    /// Where a motor holds the surface at its speed whatever it takes, it has a rotor of this
    /// inertia, kg m²: what turns that is part of its torque. A top drive of the string has its
    /// own.
    ///
    /// # Errors
    /// Where the profile or the inertia is none.
    pub fn new(
        cascade: &Cascade,
        profile: &SurfaceProfile,
        rotor_inertia: f64,
    ) -> Result<Self, SimulationError> {
        let system = CascadeSystem::new(cascade, profile, rotor_inertia)?;
        Ok(Self {
            system,
            follows_torque: false,
        })
    }

    /// The same, which follows the torque all along the string, or does not: that takes a little
    /// more of each step.
    #[must_use]
    pub fn following_torque(self, follows_torque: bool) -> Self {
        Self {
            follows_torque,
            ..self
        }
    }

    /// Simulates one case to its end, writing its time history into `record` where asked: the
    /// speeds of all nodes, and the torque at the lowest where something acts there.
    ///
    /// The regime is the bit's where a torque acts there, else that of the lowest node with
    /// one: above a free bit, what is stuck there holds it but for its swinging.
    ///
    /// # Errors
    /// Where the scene is refused or does not fit the string, the motion is not finite, or nodes
    /// that feel one another within a step do not settle.
    pub fn simulate(
        &self,
        scene: &CascadeScene,
        mut record: Option<&mut Trajectory>,
    ) -> Result<Outcome, SimulationError> {
        let sampling = self.system.sampling;
        let mut stepper = CascadeStepper::new(&self.system, scene)?;
        let (steps, window) = (stepper.steps(), scene.timing.closing_window);
        let mut bit = BitWatch::new(Rules::USUAL, sampling, steps, window);
        let mut surface = SurfaceWatch::new(sampling, steps, window);
        let mut along = self.follows_torque.then(StringTorqueWatch::default);
        let lowest = scene
            .torques
            .iter()
            .rposition(|torque| *torque != NodeTorque::None);
        if let Some(record) = &mut record {
            **record = Trajectory {
                speeds: vec![Vec::new(); scene.torques.len()],
                ..Trajectory::default()
            };
        }
        let last = scene.torques.len() - 1;
        let acts_at_last = lowest == Some(last);
        while let Some(now) = stepper.step()? {
            if let Some(lowest) = lowest {
                bit.see(now.nodes.motions[lowest].motion, now.nodes.speeds[last]);
            }
            surface.see(now.surface_torque);
            if let Some(record) = &mut record {
                push(record, now);
                let torque = acts_at_last.then_some(now.nodes.torques[last]);
                record.bit_torque.extend(torque);
            }
            if let Some(along) = &mut along {
                along.see(stepper.string_torques());
            }
        }
        if let Some(record) = record {
            record.times = (0..steps).map(|step| sampling.time_of(step)).collect();
        }
        Outcome {
            simulated: sampling.start_of(steps - 1),
            ended: Ended::End,
            predicted: None,
            torsion: lowest.map(|_| bit.measures(scene.surface_speed)),
            surface: Some(surface.measures()),
            string_torque: along
                .map(|along| along.measures(self.system.nodes.distances_from_bit())),
            lateral: None,
        }
        .finite()
    }
}

fn push(record: &mut Trajectory, now: &CascadeStep) {
    for (speeds, speed) in record.speeds.iter_mut().zip(&now.nodes.speeds) {
        speeds.push(*speed);
    }
    record.surface_torque.push(now.surface_torque);
    record.surface_speed.push(now.surface_speed);
}
