//! The whole string from the forces at its sites (Section 5.2.2, Fig. 13).
//!
//! A force that lasts bends a cantilever in the end by F L³/3EI at its tip, by 5/16 of that
//! half-way:
//!
//! ```
//! use linear::elements::reconstruction::WholeString;
//! use linear::method::FiniteElement;
//! use linear::{Bending, Drillstring, Material, Section, Sites, SurfaceSupport, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 2, parts: vec![pipe] }], 0.0)?;
//! let bending = Bending { youngs_modulus: 210e9, damping: 80.0, compression: 0.0 };
//! let whole = WholeString {
//!     string: &string,
//!     bending: &bending,
//!     support: SurfaceSupport::Clamped,
//!     sites: &Sites::bit(),
//!     sampling_frequency: 200.0,
//!     parameters: FiniteElement::default(),
//! };
//! let forces = [vec![vec![100.0; 2000]], vec![vec![0.0; 2000]]];
//! let found = whole.reconstruct(&forces, &[1999])?;
//! let [along_x, _] = &found.shapes[0];
//! let tip = 100.0 * 20f64.powi(3) / (3.0 * 210e9 * pipe.second_moment());
//! assert!((along_x[along_x.len() - 1] / tip - 1.0).abs() < 1e-3);
//! assert!((along_x[along_x.len() / 2] / tip - 5.0 / 16.0).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::mesh::{Mesh, most_elements};
use super::stepped::{self, SteppedChannel, SteppedMotion, assembled_bytes};
use crate::bending::{Bending, SurfaceSupport};
use crate::budget::{Need, REAL};
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::method::FiniteElement;
use crate::sites::Sites;

/// Lateral displacement of every node of the mesh over a simulation.
#[derive(Debug, Clone, PartialEq)]
pub struct Reconstruction {
    /// Depth of each node below the surface, m.
    pub depths: Vec<f64>,
    /// Largest radial displacement of each node, m.
    pub peaks: Vec<f64>,
    /// Shapes asked for: x and y of each node, m, one for each step asked for.
    pub shapes: Vec<[Vec<f64>; 2]>,
}

/// A string whose every node is wanted, not its sites alone.
#[derive(Debug, Clone, Copy)]
pub struct WholeString<'a> {
    /// The string.
    pub string: &'a Drillstring,
    /// Its bending constants.
    pub bending: &'a Bending,
    /// How the surface holds it.
    pub support: SurfaceSupport,
    /// Where forces act. Springs that hold it there are taken back by the forces.
    pub sites: &'a Sites,
    /// Sampling frequency of the forces, Hz.
    pub sampling_frequency: f64,
    /// Its mesh, and how it is stepped.
    pub parameters: FiniteElement,
}

impl WholeString<'_> {
    /// Memory that a reconstruction takes which keeps a number of shapes.
    pub fn need(&self, shapes: usize) -> Need {
        self.need_with(0, shapes)
    }

    /// The same with nodes at a number of places, too.
    pub(super) fn need_with(&self, places: usize, shapes: usize) -> Need {
        let cells = self.parameters.elements_per_cell;
        let nodes =
            most_elements(self.string, Channel::Bending, self.sites, cells) + 1.0 + places as f64;
        let beam = SteppedChannel::<2, 2>::bytes(self.string, nodes, self.sites.len() + places);
        let motion = SteppedChannel::<2, 2>::motion_bytes(self.string, nodes);
        // Depths, peaks, and x and y of each shape; and where it rests.
        let kept = REAL * nodes * (2.0 + 2.0 * shapes as f64);
        let resting = REAL * nodes * 2.0;
        Need {
            peak: beam + motion + assembled_bytes(self.string, nodes) + kept + resting,
            kept,
        }
    }

    /// Steps the whole string through recorded forces: `forces[axis][site][step]`,
    /// disturbances included, N. `snapshots` are the steps, in rising order, whose
    /// shapes are kept.
    ///
    /// # Errors
    /// Where the forces do not fit the sites, the parameters are out of range or the matrix
    /// cannot be factorised.
    pub fn reconstruct(
        &self,
        forces: &[Vec<Vec<f64>>; 2],
        snapshots: &[usize],
    ) -> Result<Reconstruction, BuildError> {
        self.reconstruct_about(&|_| [0.0; 2], forces, snapshots)
    }

    /// The same of a string that rests elsewhere than in the middle of its hole: where it is at rest
    /// at a distance from the bit (m), and by how much forces differ from those that hold it there.
    ///
    /// # Errors
    /// As [`WholeString::reconstruct`].
    pub fn reconstruct_about(
        &self,
        resting: &dyn Fn(f64) -> [f64; 2],
        forces: &[Vec<Vec<f64>>; 2],
        snapshots: &[usize],
    ) -> Result<Reconstruction, BuildError> {
        let (beam, mesh) = self.mesh(self.sites)?;
        let depths = mesh.depths();
        let length = self.string.length();
        let at_rest: Vec<[f64; 2]> = (depths.iter())
            .map(|depth| resting((length - depth).max(0.0)))
            .collect();
        let place = |motion: &SteppedMotion<2, 2>, node: usize| {
            let moved = beam.seen_at(motion, node);
            [0, 1].map(|axis| at_rest[node][axis] + moved[axis])
        };
        let mut peaks = vec![0.0; depths.len()];
        let mut shapes = Vec::with_capacity(snapshots.len());
        let sites: Vec<usize> = (0..self.sites.len()).collect();
        self.step_through((&beam, &sites), forces, |step, motion| {
            for (node, peak) in peaks.iter_mut().enumerate() {
                let [x, y] = place(motion, node);
                *peak = f64::max(*peak, x.hypot(y));
            }
            if snapshots.contains(&step) {
                let along = |axis: usize| {
                    let nodes = 0..depths.len();
                    nodes.map(|node| place(motion, node)[axis]).collect()
                };
                shapes.push([along(0), along(1)]);
            }
        })?;
        Ok(Reconstruction {
            depths,
            peaks,
            shapes,
        })
    }

    /// Its elements with nodes at some sites.
    pub(super) fn mesh(&self, sites: &Sites) -> Result<(SteppedChannel<2, 2>, Mesh), BuildError> {
        stepped::bent(
            self.string,
            self.bending,
            self.support,
            sites,
            &self.parameters,
            self.sampling_frequency,
        )
    }

    /// Steps elements through forces at some of their sites, by number, and shows each step once
    /// these act.
    ///
    /// # Errors
    /// Where the forces do not fit the sites.
    pub(super) fn step_through(
        &self,
        (beam, sites): (&SteppedChannel<2, 2>, &[usize]),
        forces: &[Vec<Vec<f64>>; 2],
        mut each: impl FnMut(usize, &SteppedMotion<2, 2>),
    ) -> Result<(), BuildError> {
        let steps = forces[0].first().map_or(0, Vec::len);
        let fits = |axis: &Vec<Vec<f64>>| {
            axis.len() == sites.len() && axis.iter().all(|forces| forces.len() == steps)
        };
        if !forces.iter().all(fits) {
            return Err(BuildError::Forces);
        }
        let mut motion = beam.rest();
        let mut now = vec![0.0; 2 * beam.sites()];
        for step in 0..steps {
            for (now, forces) in now.chunks_exact_mut(beam.sites()).zip(forces) {
                for (site, forces) in sites.iter().zip(forces) {
                    now[*site] = forces[step];
                }
            }
            beam.load(&mut motion, &now);
            each(step, &motion);
            beam.advance(&mut motion);
        }
        Ok(())
    }
}
