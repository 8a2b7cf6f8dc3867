//! The finite-element model seen from its sites (Eqs. 66–69, after Clough and
//! Wilson, Comput. Methods Appl. Mech. Eng. 17–18, 1979, 107–129).
//!
//! Within a step every site speed is linear in the torques of that step:
//! `speed = free speed + B torque`. The free speeds carry the whole state of
//! the string from step to step; the discrete impulse response of this scheme,
//! from a unit input in its first step, is all that a simulation needs of it.

use super::mesh::Mesh;
use super::newmark::{Integrator, Motion, Weights};
use super::torsion::{TorsionMatrices, assemble};
use crate::drillstring::{Drillstring, Sites};
use crate::error::BuildError;

/// A torsional finite-element string condensed onto its sites.
#[derive(Debug)]
pub struct CondensedString {
    integrator: Integrator,
    surface_mass: f64,
    surface_stiffness: f64,
    /// Degree of freedom of each site.
    sites: Vec<usize>,
    /// Accelerations of the whole string per unit torque at each site.
    unit_accelerations: Vec<Vec<f64>>,
}

/// The state of the whole string between two steps.
#[derive(Debug, Clone)]
pub struct StringState {
    string: Motion,
    surface: Motion,
}

impl CondensedString {
    /// Meshes, assembles and factorises the string.
    ///
    /// # Errors
    /// Where the effective matrix cannot be factorised.
    pub fn new(
        string: &Drillstring,
        sites: &Sites,
        elements_per_cell: usize,
        weights: Weights,
    ) -> Result<Self, BuildError> {
        let mesh = Mesh::new(string, sites, elements_per_cell);
        let TorsionMatrices {
            free,
            surface_mass,
            surface_stiffness,
        } = assemble(string, &mesh)?;
        let integrator = Integrator::new(free, weights)?;
        let sites: Vec<usize> = mesh.site_nodes.iter().map(|node| node - 1).collect();
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
            surface_mass,
            surface_stiffness,
            sites,
            unit_accelerations,
        })
    }

    /// The string at rest.
    pub fn rest(&self) -> StringState {
        StringState {
            string: Motion::rest(self.integrator.size()),
            surface: Motion::rest(1),
        }
    }

    /// Speed at `output` per unit torque at `input` in the same step: B of
    /// Eq. 68 in terms of speed, rad/s per N m.
    pub fn instant_response(&self, output: usize, input: usize) -> f64 {
        let acceleration = self.unit_accelerations[input][self.sites[output]];
        self.integrator.weights().velocity_gain() * acceleration
    }

    /// Takes one step with the surface turning at `surface_speed` (rad/s) and
    /// no torque at the sites. The surface node follows Newmark's scheme too,
    /// which is what the Lagrange multiplier of Eq. 69 amounts to.
    pub fn step_free(&self, state: &mut StringState, surface_speed: f64) {
        let weights = self.integrator.weights();
        state.surface.predict(weights);
        let missing = surface_speed - state.surface.velocity[0];
        (state.surface).accelerate(weights, missing / weights.velocity_gain(), &[1.0]);

        state.string.predict(weights);
        let mut forces = vec![0.0; self.integrator.size()];
        forces[0] = -self.surface_mass * state.surface.acceleration[0]
            - self.surface_stiffness * state.surface.displacement[0];
        self.integrator
            .add_internal_forces(&state.string, &mut forces);
        self.integrator.solve(&mut forces);
        state.string.accelerate(weights, 1.0, &forces);
    }

    /// Adds the effect of a torque at site `input` to the step just taken.
    pub fn apply_torque(&self, state: &mut StringState, input: usize, torque: f64) {
        let weights = self.integrator.weights();
        (state.string).accelerate(weights, torque, &self.unit_accelerations[input]);
    }

    /// Rotation speed at site `output`, rad/s.
    pub fn speed(&self, state: &StringState, output: usize) -> f64 {
        state.string.velocity[self.sites[output]]
    }
}
