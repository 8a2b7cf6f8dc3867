//! Two-node torsion elements (Eq. 62): consistent mass and stiffness, lumped
//! dashpots, the surface node's rotation prescribed.

use faer::sparse::Triplet;

use super::mesh::Mesh;
use super::newmark::Matrices;
use crate::drillstring::{Drillstring, Tube};
use crate::error::BuildError;

/// Matrices of the nodes below the surface, and how the surface node pulls on
/// the first of them.
#[derive(Debug, Clone)]
pub struct TorsionMatrices {
    /// Nodes 1, 2, … of the mesh.
    pub free: Matrices,
    /// Entry of the mass matrix between node 1 and the surface, kg m².
    pub surface_mass: f64,
    /// Entry of the stiffness matrix between node 1 and the surface, N m/rad.
    pub surface_stiffness: f64,
}

/// A uniform element between its two nodes.
#[derive(Debug, Clone, Copy)]
pub struct Element {
    /// ρJL, kg m²: a third of it at either node, a sixth between them.
    pub inertia: f64,
    /// GJ/L, N m/rad.
    pub spring: f64,
    /// The dashpot at either node, N m s/rad.
    pub dashpot: f64,
}

impl Element {
    /// That of a piece of tube.
    pub fn of(string: &Drillstring, tube: &Tube) -> Self {
        let (material, polar_moment) = (string.material(), tube.polar_moment());
        Self {
            inertia: material.density * polar_moment * tube.length,
            spring: material.shear_modulus * polar_moment / tube.length,
            dashpot: string.torsional_damping() * tube.length / 2.0,
        }
    }
}

/// Assembles the torsion elements of a mesh.
///
/// # Errors
/// Where the sparse matrices cannot be formed.
pub fn assemble(string: &Drillstring, mesh: &Mesh) -> Result<TorsionMatrices, BuildError> {
    let free = mesh.elements.len();
    let mut mass = Vec::with_capacity(4 * free);
    let mut stiffness = Vec::with_capacity(4 * free);
    let mut damping = vec![0.0; free];
    let (mut surface_mass, mut surface_stiffness) = (0.0, 0.0);
    for (bottom, tube) in mesh.elements.iter().enumerate() {
        let Element {
            inertia,
            spring,
            dashpot,
        } = Element::of(string, tube);
        mass.push(Triplet::new(bottom, bottom, inertia / 3.0));
        stiffness.push(Triplet::new(bottom, bottom, spring));
        damping[bottom] += dashpot;
        match bottom.checked_sub(1) {
            None => (surface_mass, surface_stiffness) = (inertia / 6.0, -spring),
            Some(top) => {
                mass.push(Triplet::new(top, top, inertia / 3.0));
                stiffness.push(Triplet::new(top, top, spring));
                damping[top] += dashpot;
                for (row, column) in [(top, bottom), (bottom, top)] {
                    mass.push(Triplet::new(row, column, inertia / 6.0));
                    stiffness.push(Triplet::new(row, column, -spring));
                }
            }
        }
    }
    Ok(TorsionMatrices {
        free: Matrices::new(&mass, damping, &stiffness)?,
        surface_mass,
        surface_stiffness,
    })
}
