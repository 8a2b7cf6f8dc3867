//! The finite-element models seen from their sites (Eqs. 66–69, after Clough
//! and Wilson, Comput. Methods Appl. Mech. Eng. 17–18, 1979, 107–129).
//!
//! Within a step every output at a site is linear in the loads of that step:
//! `output = free output + B load`. The free outputs carry the whole state of
//! the string from step to step; the discrete impulse response of this scheme,
//! from a unit input in its first step, is all that a simulation needs of it.

use super::beam;
use super::mesh::Mesh;
use super::newmark::{Integrator, Matrices, Motion, Weights};
use super::torsion::{self, TorsionMatrices};
use crate::bending::{Bending, SurfaceSupport};
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::sites::Sites;

/// A finite-element model and the accelerations that loads at its sites cause.
#[derive(Debug)]
struct Condensed {
    integrator: Integrator,
    /// Degree of freedom of each site.
    sites: Vec<usize>,
    /// Accelerations of the whole string per unit load at each site.
    unit_accelerations: Vec<Vec<f64>>,
}

impl Condensed {
    fn new(matrices: Matrices, sites: Vec<usize>, weights: Weights) -> Result<Self, BuildError> {
        let integrator = Integrator::new(matrices, weights)?;
        let unit_accelerations = sites
            .iter()
            .map(|&site| {
                let mut forces = vec![0.0; integrator.size()];
                forces[site] = 1.0;
                integrator.solve(&mut forces);
                forces
            })
            .collect();
        Ok(Self {
            integrator,
            sites,
            unit_accelerations,
        })
    }

    fn rest(&self) -> Motion {
        Motion::rest(self.integrator.size())
    }

    /// Takes one step under `forces` on all degrees of freedom, none of them
    /// loads at the sites.
    fn step_free(&self, motion: &mut Motion, mut forces: Vec<f64>) {
        let weights = self.integrator.weights();
        motion.predict(weights);
        self.integrator.add_internal_forces(motion, &mut forces);
        self.integrator.solve(&mut forces);
        motion.accelerate(weights, 1.0, &forces);
    }

    /// Adds the effect of a load at site `input` to the step just taken.
    fn apply(&self, motion: &mut Motion, input: usize, load: f64) {
        let weights = self.integrator.weights();
        motion.accelerate(weights, load, &self.unit_accelerations[input]);
    }
}

/// A string in torsion, its surface turned as prescribed.
#[derive(Debug)]
pub struct CondensedString {
    model: Condensed,
    surface_mass: f64,
    surface_stiffness: f64,
}

/// The state of a string in torsion between two steps.
#[derive(Debug, Clone)]
pub struct StringState {
    string: Motion,
    surface: Motion,
}

impl CondensedString {
    /// Meshes, assembles and factorises the string.
    ///
    /// # Errors
    /// Where the sites are not the string's, the elements would be too many, or the
    /// effective matrix cannot be factorised.
    pub fn new(
        string: &Drillstring,
        sites: &Sites,
        elements_per_cell: usize,
        weights: Weights,
    ) -> Result<Self, BuildError> {
        let mesh = Mesh::new(string, string.channel(), sites, elements_per_cell)?;
        let TorsionMatrices {
            free,
            surface_mass,
            surface_stiffness,
        } = torsion::assemble(string, &mesh)?;
        let sites = mesh.site_nodes.iter().map(|node| node - 1).collect();
        Ok(Self {
            model: Condensed::new(free, sites, weights)?,
            surface_mass,
            surface_stiffness,
        })
    }

    /// The string at rest.
    pub fn rest(&self) -> StringState {
        StringState {
            string: self.model.rest(),
            surface: Motion::rest(1),
        }
    }

    /// Speed at `output` per unit torque at `input` in the same step: B of
    /// Eq. 68 in terms of speed, rad/s per N m.
    #[cfg(test)]
    pub fn instant_response(&self, output: usize, input: usize) -> f64 {
        let acceleration = self.model.unit_accelerations[input][self.model.sites[output]];
        self.model.integrator.weights().velocity_gain() * acceleration
    }

    /// Takes one step with the surface turning at `surface_speed` (rad/s) and
    /// no torque at the sites. The surface node follows Newmark's scheme too,
    /// which is what the Lagrange multiplier of Eq. 69 amounts to.
    pub fn step_free(&self, state: &mut StringState, surface_speed: f64) {
        let weights = self.model.integrator.weights();
        state.surface.predict(weights);
        let missing = surface_speed - state.surface.velocity[0];
        (state.surface).accelerate(weights, missing / weights.velocity_gain(), &[1.0]);

        let mut forces = vec![0.0; self.model.integrator.size()];
        forces[0] = -self.surface_mass * state.surface.acceleration[0]
            - self.surface_stiffness * state.surface.displacement[0];
        self.model.step_free(&mut state.string, forces);
    }

    /// Adds the effect of a torque at site `input` to the step just taken.
    pub fn apply_torque(&self, state: &mut StringState, input: usize, torque: f64) {
        self.model.apply(&mut state.string, input, torque);
    }

    /// Rotation speed at site `output`, rad/s.
    pub fn speed(&self, state: &StringState, output: usize) -> f64 {
        state.string.velocity[self.model.sites[output]]
    }
}

/// A string in bending, in one plane.
#[derive(Debug)]
pub struct CondensedBeam {
    model: Condensed,
}

impl CondensedBeam {
    /// Meshes, assembles and factorises the string.
    ///
    /// # Errors
    /// Where the sites are not the string's, the elements would be too many, or the
    /// effective matrix cannot be factorised.
    pub fn new(
        string: &Drillstring,
        bending: &Bending,
        support: SurfaceSupport,
        sites: &Sites,
        elements_per_cell: usize,
        weights: Weights,
    ) -> Result<Self, BuildError> {
        let mesh = Mesh::new(string, Channel::Bending, sites, elements_per_cell)?;
        let matrices = beam::assemble(string, bending, support, (&mesh, sites))?;
        let held = support.held();
        let sites = mesh.site_nodes.iter().map(|node| 2 * node - held).collect();
        Ok(Self {
            model: Condensed::new(matrices, sites, weights)?,
        })
    }

    /// The string at rest.
    pub fn rest(&self) -> Motion {
        self.model.rest()
    }

    /// Takes one step without forces at the sites.
    pub fn step_free(&self, motion: &mut Motion) {
        let forces = vec![0.0; self.model.integrator.size()];
        self.model.step_free(motion, forces);
    }

    /// Adds the effect of a force at site `input` to the step just taken.
    pub fn apply_force(&self, motion: &mut Motion, input: usize, force: f64) {
        self.model.apply(motion, input, force);
    }

    /// Displacement at site `output`, m.
    pub fn displacement(&self, motion: &Motion, output: usize) -> f64 {
        motion.displacement[self.model.sites[output]]
    }
}
