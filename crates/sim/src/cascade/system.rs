//! A string in pieces as all cases share it.

use linear::{Cascade, Sites};

use super::waves::{EndKernel, LinkKernels};
use crate::convolution::Kernel;
use crate::error::SimulationError;
use crate::ranges::not_negative;
use crate::sampling::Sampling;
use crate::surface::{SurfaceProfile, convolved_with};

/// A string in pieces, and what its surface makes of it, in every step per unit of the speed
/// that a scene names.
#[derive(Debug, Clone)]
pub struct CascadeSystem {
    pub sampling: Sampling,
    pub longest_time: f64,
    pub nodes: Sites,
    pub top: EndKernel,
    pub links: Vec<LinkKernels>,
    pub end: Option<EndKernel>,
    /// The wave that the surface sends down.
    pub sent: Vec<f64>,
    /// Torque that turns the surface, but for what waves from below add.
    pub torque: Vec<f64>,
    pub torque_by_wave: Kernel,
    /// Speed of the surface, but for what waves from below add.
    pub speed: Vec<f64>,
    pub speed_by_wave: Option<Kernel>,
    /// Torques per speed within a step: of each node at itself, and at the next.
    pub own: Vec<f64>,
    pub next: Vec<f64>,
}

impl CascadeSystem {
    /// Prepares a string in pieces for a surface that turns by a profile; a motor that holds
    /// the speed whatever it takes has this inertia, kg m².
    pub fn new(
        cascade: &Cascade,
        profile: &SurfaceProfile,
        rotor_inertia: f64,
    ) -> Result<Self, SimulationError> {
        profile.check()?;
        not_negative("inertia of the rotor in kg m²", rotor_inertia)?;
        let sampling = Sampling::new(cascade.sampling_frequency, 0.0);
        let steps = (cascade.longest_time * sampling.frequency).ceil() as usize + 1;
        let set: Vec<f64> = (0..steps)
            .map(|step| profile.at(sampling.time_of(step)))
            .collect();
        let top = EndKernel::new(cascade.top.impedance, &cascade.top.reflection);
        let links: Vec<LinkKernels> = cascade.links.iter().map(LinkKernels::new).collect();
        let end = (cascade.end.as_ref()).map(|end| EndKernel::new(end.impedance, &end.reflection));
        let (own, next) = stiffness(&top, &links, end.as_ref());
        let mut torque = convolved_with(&cascade.top.torque_by_set, &set);
        if rotor_inertia > 0.0 {
            for (step, torque) in torque.iter_mut().enumerate() {
                *torque += rotor_inertia * profile.acceleration(sampling.time_of(step));
            }
        }
        let (speed, speed_by_wave) = match &cascade.top.speed {
            None => (set.clone(), None),
            Some([by_set, by_wave]) => (convolved_with(by_set, &set), Some(Kernel::new(by_wave))),
        };
        Ok(Self {
            sampling,
            longest_time: cascade.longest_time,
            nodes: cascade.nodes.clone(),
            sent: convolved_with(&cascade.top.sent, &set),
            torque,
            torque_by_wave: Kernel::new(&cascade.top.torque_by_wave),
            speed,
            speed_by_wave,
            top,
            links,
            end,
            own,
            next,
        })
    }
}

fn stiffness(
    top: &EndKernel,
    links: &[LinkKernels],
    end: Option<&EndKernel>,
) -> (Vec<f64>, Vec<f64>) {
    let mut own = vec![0.0; links.len() + 1];
    let mut next = vec![0.0; links.len()];
    own[0] = top.stiffness();
    for (node, link) in links.iter().enumerate() {
        let [above, between, below] = link.stiffness();
        own[node] += above;
        own[node + 1] += below;
        next[node] = between;
    }
    if let Some(last) = own.last_mut() {
        *last += end.map_or(0.0, EndKernel::stiffness);
    }
    (own, next)
}
