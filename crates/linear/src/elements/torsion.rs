//! Two-node torsion elements (Eq. 62): consistent mass and stiffness, lumped
//! dashpots, the surface node's rotation prescribed, or driven.

use super::fading::{Fading, NodalDrag};
use super::mesh::Mesh;
use super::newmark::{Entry, Matrices};
use crate::drillstring::{Drillstring, Tube};
use crate::error::BuildError;
use crate::top_drive::TopDrive;

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
        let (material, section) = (string.material(), string.section_constant(tube));
        Self {
            inertia: material.density * section * tube.length,
            spring: string.modulus() * section / tube.length,
            dashpot: string.torsional_damping() * tube.length / 2.0,
        }
    }
}

/// Assembles the torsion elements of a mesh.
///
/// # Errors
/// Where the sparse matrices cannot be formed.
pub fn assemble(string: &Drillstring, mesh: &Mesh) -> Result<TorsionMatrices, BuildError> {
    let mut entries = Entries::none(mesh.elements.len());
    let (mut surface_mass, mut surface_stiffness) = (0.0, 0.0);
    for (bottom, tube) in mesh.elements.iter().enumerate() {
        let element = Element::of(string, tube);
        entries.add_below(&element, bottom);
        match bottom.checked_sub(1) {
            None => (surface_mass, surface_stiffness) = (element.inertia / 6.0, -element.spring),
            Some(top) => entries.add_above(&element, top),
        }
    }
    Ok(TorsionMatrices {
        free: entries.matrices(string, mesh, |node| node.checked_sub(1))?,
        surface_mass,
        surface_stiffness,
    })
}

/// The same below a top drive, all nodes of the mesh from the surface down: the drive's inertia,
/// and its gains as a dashpot and a spring to the motion that it is set to, are at the first.
///
/// # Errors
/// As [`assemble`].
pub fn assemble_below_drive(
    string: &Drillstring,
    mesh: &Mesh,
    drive: &TopDrive,
) -> Result<Matrices, BuildError> {
    let mut entries = Entries::none(mesh.elements.len() + 1);
    for (top, tube) in mesh.elements.iter().enumerate() {
        let element = Element::of(string, tube);
        entries.add_below(&element, top + 1);
        entries.add_above(&element, top);
    }
    entries.mass.push(Entry::new(0, 0, drive.inertia));
    entries.damping[0] += drive.proportional_gain;
    entries.springs.push(Entry::new(0, 0, drive.integral_gain));
    entries.matrices(string, mesh, Some)
}

/// Entries of the matrices, as they are summed up.
struct Entries {
    mass: Vec<Entry>,
    /// Of the string's material.
    elastic: Vec<Entry>,
    /// Of other springs.
    springs: Vec<Entry>,
    damping: Vec<f64>,
}

impl Entries {
    /// Those of nothing, at this number of nodes.
    fn none(nodes: usize) -> Self {
        Self {
            mass: Vec::with_capacity(4 * nodes),
            elastic: Vec::with_capacity(4 * nodes),
            springs: Vec::new(),
            damping: vec![0.0; nodes],
        }
    }

    /// What an element is to the node below it.
    fn add_below(&mut self, element: &Element, bottom: usize) {
        let own = element.inertia / 3.0;
        self.mass.push(Entry::new(bottom, bottom, own));
        (self.elastic).push(Entry::new(bottom, bottom, element.spring));
        self.damping[bottom] += element.dashpot;
    }

    /// What it is to the node above it, and between this and the next one.
    fn add_above(&mut self, element: &Element, top: usize) {
        let own = element.inertia / 3.0;
        self.mass.push(Entry::new(top, top, own));
        self.elastic.push(Entry::new(top, top, element.spring));
        self.damping[top] += element.dashpot;
        for (row, column) in [(top, top + 1), (top + 1, top)] {
            let across = element.inertia / 6.0;
            self.mass.push(Entry::new(row, column, across));
            (self.elastic).push(Entry::new(row, column, -element.spring));
        }
    }

    /// The matrices, with the loss of the string that fades: `place` gives the degree of freedom of
    /// a node, if it is free.
    fn matrices(
        mut self,
        string: &Drillstring,
        mesh: &Mesh,
        place: impl Fn(usize) -> Option<usize>,
    ) -> Result<Matrices, BuildError> {
        let drag = NodalDrag::new(string, string.channel(), mesh, self.damping.len(), place);
        let stiffness = [&self.elastic[..], &self.springs].concat();
        let fading = Fading::new(string, drag, &mut self.damping, self.elastic);
        Ok(Matrices::new(&self.mass, self.damping, &stiffness)?.with_fading(fading))
    }
}
