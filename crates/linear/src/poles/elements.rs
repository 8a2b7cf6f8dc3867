//! Finite elements of a string as full matrices, seen from its sites.

use num_complex::Complex64;
use numerics::sparse::Entry;
use numerics::{Mat, equations};

use super::projection::Coordinates;
use crate::elements::newmark::Matrices;
use crate::loss::Relaxation;

/// Growth of a force that bends the string almost as one at rest does, 1/s.
pub(super) const SLOW: f64 = 30.0;

/// Newton's steps to a pole from its mode without loss: it is wanted as a shape alone.
const STEPS_TO_POLE: usize = 8;

/// Elements as full matrices.
pub(super) struct Elements {
    pub(super) mass: Mat<f64>,
    pub(super) stiffness: Mat<f64>,
    /// What fades of the stiffness, of weight one.
    pub(super) elastic: Option<Mat<f64>>,
    pub(super) material: Vec<Relaxation>,
    pub(super) dashpots: Vec<f64>,
    /// Rate, 1/s, and a dashpot a degree of freedom.
    pub(super) drag: Vec<(f64, Vec<f64>)>,
    /// The degree of freedom of the displacement of each site.
    pub(super) places: Vec<usize>,
    /// Displacements that are seen besides, by degrees of freedom.
    pub(super) seen: Vec<Weighted>,
}

/// A sum over degrees of freedom, each with its weight.
pub(super) type Weighted = Vec<(usize, f64)>;

/// What a pole leaves of the weights of each mode.
pub(super) struct Mode {
    pub(super) stiffness: f64,
    pub(super) dashpot: f64,
    pub(super) elastic: f64,
    pub(super) drag: Vec<f64>,
}

impl Elements {
    /// Of a mesh, whose sites are at these degrees of freedom, with what is seen besides.
    pub(super) fn of(matrices: &Matrices, (places, seen): (Vec<usize>, Vec<Weighted>)) -> Self {
        let size = matrices.size();
        let full = |entries: &mut dyn Iterator<Item = (usize, usize, f64)>| {
            let mut matrix = Mat::zeros(size, size);
            for (row, column, value) in entries {
                matrix[(row, column)] += value;
            }
            matrix
        };
        let fading = matrices.fading();
        let elastic = fading.filter(|fading| !fading.material.is_empty());
        Self {
            mass: full(&mut matrices.mass_entries()),
            stiffness: full(&mut matrices.stiffness_entries()),
            elastic: elastic.map(|fading| {
                let entry = |entry: &Entry| (entry.row, entry.col, entry.val);
                full(&mut fading.elastic.iter().map(entry))
            }),
            material: fading.map_or(Vec::new(), |fading| fading.material.clone()),
            dashpots: matrices.damping().to_vec(),
            drag: fading.map_or(Vec::new(), |fading| {
                let drag = fading.drag.iter();
                drag.map(|it| (it.rate, it.dashpots.clone())).collect()
            }),
            places,
            seen,
        }
    }

    /// How the string is bent by a force at each site that grows slowly: one at rest bends it out of all
    /// bounds where nothing holds it.
    pub(super) fn bent(&self) -> Mat<f64> {
        let growth = SLOW;
        let elastic: f64 = (self.material.iter())
            .map(|it| it.weight * growth / (growth + it.rate))
            .sum();
        let size = self.dashpots.len();
        let mut dynamic = Mat::from_fn(size, size, |row, column| {
            let place = (row, column);
            let fading = self.elastic.as_ref().map_or(0.0, |it| it[place]);
            self.stiffness[place] + growth * growth * self.mass[place] + elastic * fading
        });
        for place in 0..size {
            let drag: f64 = (self.drag.iter())
                .map(|(rate, dashpots)| dashpots[place] * growth / (growth + rate))
                .sum();
            dynamic[(place, place)] += growth * (self.dashpots[place] + drag);
        }
        let forces = Mat::from_fn(size, self.places.len(), |row, site| {
            if row == self.places[site] { 1.0 } else { 0.0 }
        });
        equations::solve(&dynamic, &forces)
    }

    /// About the pole of a mode, 1/s: with its loss at its own frequency.
    pub(super) fn pole(&self, mode: &Mode) -> Complex64 {
        let mut s = Complex64::new(0.0, mode.stiffness.sqrt());
        for _ in 0..STEPS_TO_POLE {
            let mut value = s * s + s * mode.dashpot + mode.stiffness;
            let mut slope = 2.0 * s + mode.dashpot;
            for ((rate, _), drag) in self.drag.iter().zip(&mode.drag) {
                let forgets = s + rate;
                value += s * s / forgets * *drag;
                slope += (2.0 * s * forgets - s * s) / (forgets * forgets) * *drag;
            }
            for it in &self.material {
                let forgets = s + it.rate;
                let weight = mode.elastic * it.weight;
                value += s / forgets * weight;
                slope += it.rate / (forgets * forgets) * weight;
            }
            let step = value / slope;
            if !step.is_finite() {
                break;
            }
            s -= step;
        }
        s
    }

    /// Displacement, speed and what fades of a shape, each for itself, from the first of these on.
    pub(super) fn apart(&self, shape: usize, first: usize) -> Vec<Coordinates> {
        let (drag, material) = (self.drag.len(), self.material.len());
        let only = |place: usize| {
            let at = |index: usize| if index == place { 1.0 } else { 0.0 };
            Coordinates {
                shape,
                displacement: at(0),
                speed: at(1),
                drag: (2..2 + drag).map(at).collect(),
                material: (2 + drag..2 + drag + material).map(at).collect(),
            }
        };
        (first..2 + drag + material).map(only).collect()
    }

    /// Displacement, speed and what fades of a shape that moves as e^(st): real and imaginary part.
    pub(super) fn coordinates(&self, shape: usize, s: Complex64) -> Vec<Coordinates> {
        let drag = self.drag.iter().map(|(rate, _)| s * *rate / (s + rate));
        let material = self.material.iter().map(|it| s / (s + it.rate));
        let (drag, material): (Vec<_>, Vec<_>) = (drag.collect(), material.collect());
        let part = |of: fn(&Complex64) -> f64, displacement: f64| Coordinates {
            shape,
            displacement,
            speed: of(&s),
            drag: drag.iter().map(of).collect(),
            material: material.iter().map(of).collect(),
        };
        let real = part(|z| z.re, 1.0);
        match s.im == 0.0 {
            true => vec![real],
            false => vec![real, part(|z| z.im, 0.0)],
        }
    }
}
