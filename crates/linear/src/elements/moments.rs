//! Displacements and bending moments of elements in a row under forces at their sites.
//!
//! A moment is what keeps the element above a place in equilibrium, K u + M ü with the part of the
//! stiffness that fades, and not the curvature of its shape functions, which is off by a square of its
//! length.

use super::beam::{mass_matrix, stiffness_matrix};
use super::fading::Faded;
use super::mesh::Mesh;
use super::reconstruction::WholeString;
use super::stepped::{NodeState, SteppedChannel};
use crate::budget::{Need, REAL};
use crate::error::BuildError;
use crate::sites::{Sites, SitesAndPlaces};

/// The couple at the lower end of an element by the motion of both ends, N m.
struct LowerCouple {
    /// By displacements, by accelerations, and by displacements that the material relaxes into.
    stiffness: [f64; 4],
    mass: [f64; 4],
    fading: [f64; 4],
}

impl LowerCouple {
    /// In both planes.
    fn of(&self, above: &NodeState<2, 2>, below: &NodeState<2, 2>) -> [f64; 2] {
        let sum = |weights: &[f64; 4], of: fn(&NodeState<2, 2>) -> &[[f64; 2]; 2], plane: usize| {
            let motion = of(above).iter().chain(of(below));
            let products = weights
                .iter()
                .zip(motion)
                .map(|(it, motion)| it * motion[plane]);
            products.sum::<f64>()
        };
        [0, 1].map(|plane| {
            sum(&self.stiffness, |it| &it.displacement, plane)
                + sum(&self.mass, |it| &it.acceleration, plane)
                - sum(&self.fading, |it| &it.faded, plane)
        })
    }
}

impl WholeString<'_> {
    /// Memory that [`WholeString::moments`] or [`WholeString::displacements`] takes at a number of places
    /// for a number of steps.
    pub fn need_at_places(&self, places: usize, steps: f64) -> Need {
        let kept = 2.0 * REAL * places as f64 * steps;
        Need {
            peak: self.need_with(places, 0).peak + kept,
            kept,
        }
    }

    /// Its elements with nodes at places, too (m from the bit).
    fn cut_at(
        &self,
        places: &[f64],
    ) -> Result<(SitesAndPlaces, SteppedChannel<2, 2>, Mesh), BuildError> {
        let places = Sites::new(self.string, places)?;
        let cut = (self.sites).with_places(self.string, places.distances_from_bit())?;
        let (beam, mesh) = self.mesh(&cut.nodes)?;
        Ok((cut, beam, mesh))
    }

    /// Steps the whole string through recorded forces as [`WholeString::reconstruct`] does, and finds
    /// the bending moments along x and along y, N m, at places (m from the bit, from the surface down)
    /// in all steps from one on.
    ///
    /// # Errors
    /// As [`WholeString::reconstruct`], and where two places are one or one is not on the string.
    pub fn moments(
        &self,
        forces: &[Vec<Vec<f64>>; 2],
        places: &[f64],
        from: usize,
    ) -> Result<Vec<[Vec<f64>; 2]>, BuildError> {
        let (cut, beam, mesh) = self.cut_at(places)?;
        let nodes: Vec<usize> = (cut.places.iter())
            .map(|&place| mesh.site_nodes[place])
            .collect();
        let relaxations = self.string.loss().relaxations().iter();
        let at_once: f64 = relaxations
            .map(|it| it.weight * Faded::new(it.rate, self.sampling_frequency.recip()).at_once)
            .sum();
        let couple = |&node: &usize| {
            let (element, around) = (&mesh.elements[node - 1], &mesh.around[node - 1]);
            let [mass, stiffness, elastic] = [
                mass_matrix(
                    element,
                    self.string.mass_sideways(element, around.hole_radius),
                ),
                stiffness_matrix(element, &self.bending.under(around.tension)),
                stiffness_matrix(element, &self.bending.straight()),
            ]
            .map(|matrix| matrix[3]);
            LowerCouple {
                stiffness: std::array::from_fn(|it| stiffness[it] + at_once * elastic[it]),
                mass,
                fading: elastic,
            }
        };
        let couples: Vec<LowerCouple> = nodes.iter().map(couple).collect();
        let mut moments = vec![[Vec::new(), Vec::new()]; nodes.len()];
        self.step_through((&beam, &cut.sites), forces, |step, motion| {
            if step < from {
                return;
            }
            for ((moments, node), couple) in moments.iter_mut().zip(&nodes).zip(&couples) {
                let [above, below] = [node - 1, *node].map(|node| beam.state_at(motion, node));
                for (moments, moment) in moments.iter_mut().zip(couple.of(&above, &below)) {
                    moments.push(moment);
                }
            }
        })?;
        Ok(moments)
    }

    /// The same of displacements along x and along y, m, of the places themselves.
    ///
    /// # Errors
    /// As [`WholeString::moments`].
    pub fn displacements(
        &self,
        forces: &[Vec<Vec<f64>>; 2],
        places: &[f64],
        from: usize,
    ) -> Result<Vec<[Vec<f64>; 2]>, BuildError> {
        let (cut, beam, mesh) = self.cut_at(places)?;
        let mut displacements = vec![[Vec::new(), Vec::new()]; cut.places.len()];
        self.step_through((&beam, &cut.sites), forces, |step, motion| {
            if step < from {
                return;
            }
            for (displacements, &place) in displacements.iter_mut().zip(&cut.places) {
                let moved = beam.seen_at(motion, mesh.site_nodes[place]);
                for (displacements, moved) in displacements.iter_mut().zip(moved) {
                    displacements.push(moved);
                }
            }
        })?;
        Ok(displacements)
    }
}
