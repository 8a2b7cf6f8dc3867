//! Two-node torsion elements (Eq. 62): consistent mass and stiffness, lumped
//! dashpots, the surface node's rotation prescribed.

use faer::sparse::Triplet;

use super::mesh::Mesh;
use super::newmark::Matrices;
use crate::drillstring::Drillstring;
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

/// Assembles the torsion elements of a mesh.
///
/// # Errors
/// Where the sparse matrices cannot be formed.
pub fn assemble(string: &Drillstring, mesh: &Mesh) -> Result<TorsionMatrices, BuildError> {
    let material = string.material();
    let free = mesh.elements.len();
    let mut mass = Vec::with_capacity(4 * free);
    let mut stiffness = Vec::with_capacity(4 * free);
    let mut damping = vec![0.0; free];
    let (mut surface_mass, mut surface_stiffness) = (0.0, 0.0);
    for (bottom, element) in mesh.elements.iter().enumerate() {
        let polar_moment = element.polar_moment();
        let inertia = material.density * polar_moment * element.length;
        let spring = material.shear_modulus * polar_moment / element.length;
        let dashpot = string.torsional_damping() * element.length / 2.0;
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
