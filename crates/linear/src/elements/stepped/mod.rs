//! Newmark's scheme stepped over all elements of a string, for many sites: what a step costs
//! depends on the length of the string, not on the sites, and loads cost where they act alone.

mod blocks;
mod chain;
mod channel;
mod memory;
mod node;

use super::beam;
use super::fading::Faded;
use super::mesh::Mesh;
use super::newmark::{Motion, Weights};
use super::torsion::{self, TorsionMatrices};
use crate::bending::{Bending, SurfaceSupport};
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::loss::Relaxation;
use crate::method::FiniteElement;
use crate::sites::Sites;

pub(in crate::elements) use chain::NodeState;
use channel::Seen;
pub use channel::{SteppedChannel, SteppedMotion};

/// Bytes that dividing a string, assembling its matrices and factorising them hold for each
/// element. Measured in bending, and rounded up.
const ASSEMBLED: f64 = 2400.0;

/// The same of what fades: dashpots of two degrees of freedom for each relaxation of drag, and the
/// elastic stiffness once more.
const ASSEMBLED_FADING: f64 = 900.0;

/// Bytes that dividing a string, assembling its matrices and factorising them hold for a number of
/// nodes.
pub(crate) fn assembled_bytes(string: &Drillstring, nodes: f64) -> f64 {
    let fading = if string.loss().has_memory() {
        ASSEMBLED_FADING
    } else {
        0.0
    };
    (ASSEMBLED + fading) * nodes
}

/// How the surface, or below a top drive the motion that this is set to, pulls on the uppermost
/// node that is free.
#[derive(Debug, Clone)]
pub(crate) struct SurfaceElement {
    mass: f64,
    damping: f64,
    stiffness: f64,
    /// Relaxations of the stiffness.
    material: Vec<Relaxation>,
}

/// A string in torsion, the motion of its surface, or of what a drive is set to, held; and how
/// that pulls on it.
///
/// # Errors
/// As [`bent`].
pub(crate) fn turned(
    string: &Drillstring,
    sites: &Sites,
    parameters: &FiniteElement,
    sampling_frequency: f64,
) -> Result<(SteppedChannel<1, 1>, SurfaceElement), BuildError> {
    let weights = Weights::new(parameters, sampling_frequency)?;
    let mesh = Mesh::new(
        string,
        string.channel(),
        sites,
        parameters.elements_per_cell,
    )?;
    let (matrices, surface, held) = match string.top_drive() {
        None => {
            let TorsionMatrices {
                free,
                surface_mass: mass,
                surface_stiffness: stiffness,
            } = torsion::assemble(string, &mesh)?;
            let surface = SurfaceElement {
                mass,
                damping: 0.0,
                stiffness,
                material: string.loss().relaxations().to_vec(),
            };
            // The surface is not one of its nodes.
            (free, surface, 1)
        }
        Some(drive) if drive.delay > 0.0 => return Err(BuildError::LateDrive),
        Some(drive) => {
            let matrices = torsion::assemble_below_drive(string, &mesh, &drive)?;
            let surface = SurfaceElement {
                mass: 0.0,
                damping: -drive.proportional_gain,
                stiffness: -drive.integral_gain,
                material: Vec::new(),
            };
            (matrices, surface, 0)
        }
    };
    let nodes = mesh.site_nodes.iter().map(|node| node - held).collect();
    let channel = SteppedChannel::new(&matrices, 0, weights, Seen::Velocity, nodes)?;
    Ok((channel, surface))
}

/// A string in bending, along x and along y, held by the springs of its sites, and its mesh.
///
/// # Errors
/// Where the sites are not the string's, parameters are out of range, or the elements would be
/// too many or cannot be factorised.
pub(crate) fn bent(
    string: &Drillstring,
    bending: &Bending,
    support: SurfaceSupport,
    sites: &Sites,
    parameters: &FiniteElement,
    sampling_frequency: f64,
) -> Result<(SteppedChannel<2, 2>, Mesh), BuildError> {
    let weights = Weights::new(parameters, sampling_frequency)?;
    let mesh = Mesh::new(
        string,
        Channel::Bending,
        sites,
        parameters.elements_per_cell,
    )?;
    let matrices = beam::assemble(string, bending, support, (&mesh, sites))?;
    let (held, nodes) = (support.held(), mesh.site_nodes.clone());
    let seen = Seen::Displacement;
    let channel = SteppedChannel::new(&matrices, held, weights, seen, nodes)?;
    Ok((channel, mesh))
}

impl SurfaceElement {
    /// The torques on that node where the surface, or the motion set, has a speed of one in the
    /// first step alone, and follows Newmark's scheme too.
    pub(crate) fn torques(&self, count: usize, weights: &Weights) -> Vec<f64> {
        let mut surface = Motion::rest(1);
        let faded = (self.material.iter()).map(|it| (it.weight, Faded::new(it.rate, weights.step)));
        let mut material: Vec<_> = faded.map(|(weight, faded)| (weight, faded, 0.0)).collect();
        let torque = |step: usize| {
            surface.predict(weights);
            let speed = if step == 0 { 1.0 } else { 0.0 };
            let missing = speed - surface.velocity[0];
            surface.accelerate(weights, missing / weights.velocity_gain(), &[1.0]);
            let twist = surface.displacement[0];
            let mut twisted = twist;
            for (weight, faded, carried) in &mut material {
                twisted += *weight * (faded.at_once * twist - *carried);
                *carried = faded.kept * *carried + faded.added * twist;
            }
            -self.mass * surface.acceleration[0]
                - self.damping * surface.velocity[0]
                - self.stiffness * twisted
        };
        (0..count).map(torque).collect()
    }
}
