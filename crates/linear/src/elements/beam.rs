//! Cubic beam elements (Eq. 62): consistent mass, stiffness and, with
//! pre-compression, geometric stiffness; lumped dashpots on the displacements.
//!
//! Degrees of freedom of a node: displacement, slope.

use super::fading::{Fading, NodalDrag};
use super::mesh::Mesh;
use super::newmark::{Entry, Matrices};
use crate::bending::{Bending, SurfaceSupport};
use crate::channel::Channel;
use crate::drillstring::{Drillstring, Tube};
use crate::error::BuildError;
use crate::sites::Sites;

/// Assembles the beam elements of a mesh with the springs and masses of its sites, without the
/// degrees of freedom that the surface holds.
///
/// # Errors
/// Where no string bends as `bending` says, or the sparse matrices cannot be formed.
pub fn assemble(
    string: &Drillstring,
    bending: &Bending,
    support: SurfaceSupport,
    (mesh, sites): (&Mesh, &Sites),
) -> Result<Matrices, BuildError> {
    bending.check()?;
    let held = support.held();
    let size = 2 * mesh.nodes() - held;
    let mut mass = Vec::with_capacity(16 * mesh.elements.len());
    let mut stiffness = Vec::with_capacity(16 * mesh.elements.len());
    let mut elastic = Vec::new();
    let fades = !string.loss().relaxations().is_empty();
    let mut damping = vec![0.0; size];
    for (upper, (element, around)) in mesh.elements.iter().zip(&mesh.around).enumerate() {
        let first = 2 * upper;
        let element_mass = mass_matrix(element, string.mass_sideways(element, around.hole_radius));
        let element_stiffness = stiffness_matrix(element, &bending.under(around.tension));
        let of_material = fades.then(|| stiffness_matrix(element, &bending.straight()));
        for row in 0..4 {
            for column in 0..4 {
                let (Some(i), Some(j)) = (
                    (first + row).checked_sub(held),
                    (first + column).checked_sub(held),
                ) else {
                    continue;
                };
                mass.push(Entry::new(i, j, element_mass[row][column]));
                stiffness.push(Entry::new(i, j, element_stiffness[row][column]));
                if let Some(of_material) = of_material {
                    elastic.push(Entry::new(i, j, of_material[row][column]));
                }
            }
        }
        for displacement in [first, first + 2] {
            if let Some(place) = displacement.checked_sub(held) {
                damping[place] += dashpot(element, bending);
            }
        }
    }
    let place = |node: usize| (2 * node).checked_sub(held);
    for (&node, load) in mesh.site_nodes.iter().zip(sites.loads()) {
        if let Some(place) = place(node) {
            stiffness.push(Entry::new(place, place, load.spring));
            mass.push(Entry::new(place, place, load.mass));
        }
    }
    let drag = NodalDrag::new(string, Channel::Bending, mesh, size, place);
    let fading = Fading::new(string, drag, &mut damping, elastic);
    Ok(Matrices::new(&mass, damping, &stiffness)?.with_fading(fading))
}

/// The displacement at a depth below the surface (m) as a sum over degrees of freedom: the cubic shape functions of
/// its element. None where the string does not move.
pub(crate) fn displacement_at(
    mesh: &Mesh,
    depth: f64,
    support: SurfaceSupport,
) -> Vec<(usize, f64)> {
    let depths = mesh.depths();
    let below = depths.partition_point(|node| *node < depth);
    let element = below.clamp(1, mesh.elements.len()) - 1;
    let length = mesh.elements[element].length;
    let x = (depth - depths[element]) / length;
    if x < 0.0 {
        return Vec::new();
    }
    let weights = [
        (1.0 - x) * (1.0 - x) * (1.0 + 2.0 * x),
        x * (1.0 - x) * (1.0 - x) * length,
        x * x * (3.0 - 2.0 * x),
        -x * x * (1.0 - x) * length,
    ];
    let freedoms = (2 * element..).map(|freedom| freedom.checked_sub(support.held()));
    let weighted = freedoms.zip(weights);
    weighted
        .filter_map(|(freedom, weight)| Some((freedom?, weight)))
        .collect()
}

/// The dashpot on the displacement of either node, N s/m.
pub(super) fn dashpot(element: &Tube, bending: &Bending) -> f64 {
    bending.damping * element.length / 2.0
}

/// m L/420 times the consistent mass matrix of cubic shape functions, of a mass m per length
/// (kg/m).
pub(crate) fn mass_matrix(element: &Tube, mass: f64) -> [[f64; 4]; 4] {
    let l = element.length;
    let scale = mass * l / 420.0;
    [
        [156.0, 22.0 * l, 54.0, -13.0 * l],
        [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
        [54.0, 13.0 * l, 156.0, -22.0 * l],
        [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l],
    ]
    .map(|row| row.map(|entry| scale * entry))
}

/// Bending stiffness less what compression takes from it.
pub(crate) fn stiffness_matrix(element: &Tube, bending: &Bending) -> [[f64; 4]; 4] {
    let l = element.length;
    let elastic_scale = bending.youngs_modulus * element.second_moment() / l.powi(3);
    let geometric_scale = bending.compression / (30.0 * l);
    let elastic = [
        [12.0, 6.0 * l, -12.0, 6.0 * l],
        [6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l],
        [-12.0, -6.0 * l, 12.0, -6.0 * l],
        [6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l],
    ];
    let geometric = [
        [36.0, 3.0 * l, -36.0, 3.0 * l],
        [3.0 * l, 4.0 * l * l, -3.0 * l, -l * l],
        [-36.0, -3.0 * l, 36.0, -3.0 * l],
        [3.0 * l, -l * l, -3.0 * l, 4.0 * l * l],
    ];
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            elastic_scale * elastic[row][column] - geometric_scale * geometric[row][column]
        })
    })
}
