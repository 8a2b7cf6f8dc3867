//! Mode shapes: next to a natural frequency the string answers a load anywhere by that mode
//! alone.

use num_complex::Complex64;
use numerics::{Mat, equations, products};

use super::frequencies::{Motion, NaturalFrequencies};
use crate::assembly::matrix::ResponseMatrix;
use crate::bending::SurfaceSupport;
use crate::error::BuildError;
use crate::sites::Sites;
use crate::waves::lateral::BendingNetwork;
use crate::waves::network::TorsionNetwork;

/// Where the motion at the surface is taken: this fraction of the length below it.
const NEXT_TO_SURFACE: f64 = 1e-6;

/// Depths at equal distances are no nearer than this part of the length to a place that is held.
const NEXT_TO_PLACE: f64 = 1e-4;

/// The relative distance from a natural frequency at which the shape is computed: nearer, rounding
/// is as large as what other modes add.
const OFF_RESONANCE: f64 = 1e-6;

/// A mode along the string, from the surface to the bit; of a string that is held, from the
/// uppermost place that holds it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Shape {
    /// Depths, m.
    pub depths: Vec<f64>,
    /// Amplitude at each (rotation in torsion, displacement in bending) in parts of the
    /// greatest, which is 1.
    pub amplitudes: Vec<f64>,
}

impl NaturalFrequencies {
    /// The shape of the mode of a natural frequency (rad/s) at this many depths, at least 2, at
    /// equal distances, and where the string is held. Of modes closer to one another than a part of
    /// 1e-5 it is a mixture.
    ///
    /// # Errors
    /// Where this is not finite, because the string's constants are extreme.
    pub fn shape(&self, frequency: f64, depths: usize) -> Result<Shape, BuildError> {
        let length = self.string.length();
        let depths = self.depths(depths.max(2));
        let top = depths[0];
        let next_to_top = top + NEXT_TO_SURFACE * (length - top);
        let place = |depth: &f64| length - depth.max(next_to_top);
        let distances: Vec<f64> = depths.iter().map(place).collect();
        let responses = self.responses(&Sites::new(&self.string, &distances)?, frequency)?;
        let size = |site: usize| responses[(site, site)].norm();
        let most = (0..depths.len())
            .max_by(|&one, &other| size(one).total_cmp(&size(other)))
            .unwrap_or(0);
        let of_most = responses[(most, most)];
        let answers = (0..depths.len()).map(|site| (responses[(site, most)] / of_most).re);
        let mut amplitudes: Vec<f64> = answers.collect();
        if self.holds_top() {
            amplitudes[0] = 0.0;
        }
        let greatest = amplitudes
            .iter()
            .fold(0.0, |most: f64, it| most.max(it.abs()));
        amplitudes.iter_mut().for_each(|it| *it /= greatest);
        if amplitudes.iter().all(|it| it.is_finite()) {
            return Ok(Shape { depths, amplitudes });
        }
        Err(BuildError::NotFinite {
            method: "exact waves",
        })
    }

    /// Depths at equal distances from the top to the bit, `count` of them, and those of places that
    /// hold the string.
    fn depths(&self, count: usize) -> Vec<f64> {
        let length = self.string.length();
        let held = match &self.motion {
            Motion::Bending { held, .. } => held.as_ref(),
            Motion::Rod { .. } => None,
        };
        let held: Vec<f64> = held.map_or_else(Vec::new, |held| held.depths(&self.string).collect());
        let top = held.first().copied().unwrap_or_else(|| self.top());
        let even = (0..count).map(|index| top + (length - top) * index as f64 / (count - 1) as f64);
        let is_at_support = |depth: &f64| {
            let mut near = held.iter().map(|place| (place - depth).abs());
            near.any(|distance| distance <= NEXT_TO_PLACE * (length - top))
        };
        let even = even.filter(|depth| !is_at_support(depth));
        let mut depths: Vec<f64> = even.chain(held.iter().copied()).collect();
        depths.sort_by(f64::total_cmp);
        depths
    }

    /// What each site answers (row) to a load at each (column).
    fn responses(&self, sites: &Sites, frequency: f64) -> Result<Mat<Complex64>, BuildError> {
        let s = Complex64::new(0.0, frequency * (1.0 + OFF_RESONANCE));
        match &self.motion {
            Motion::Rod { .. } => {
                let network = TorsionNetwork::new(&self.string, sites)?;
                Ok(matrix(&network.admittance(s).from_torque))
            }
            Motion::Bending {
                bending,
                support,
                held: None,
                ..
            } => {
                let network = BendingNetwork::new(&self.string, *bending, *support, sites)?;
                Ok(matrix(&network.receptance(s)))
            }
            Motion::Bending {
                bending,
                held: Some(held),
                ..
            } => {
                let (uppermost, others) = held.distances_from_bit().split_at(1);
                let distances = sites.distances_from_bit();
                let all = Sites::new(&self.string, &[uppermost, distances].concat())?;
                let network = BendingNetwork::below_uppermost(&self.string, *bending, &all)?;
                let same = self.string.same_place();
                let is_held = |distance: f64| others.iter().any(|it| (it - distance).abs() <= same);
                let places = (0..distances.len()).filter(|&site| is_held(distances[site]));
                let places: Vec<usize> = places.collect();
                Ok(held_at(&matrix(&network.receptance(s)), &places))
            }
        }
    }

    /// Depth of the upper end of what moves, m.
    fn top(&self) -> f64 {
        match self.motion {
            Motion::Rod { .. } => 0.0,
            Motion::Bending { .. } => self.string.length() - self.string.bending_length(),
        }
    }

    fn holds_top(&self) -> bool {
        match self.motion {
            Motion::Rod { hanging } => hanging.is_none(),
            Motion::Bending { support, .. } => support != SurfaceSupport::Free,
        }
    }
}

fn matrix(responses: &ResponseMatrix) -> Mat<Complex64> {
    let size = responses.size();
    Mat::from_fn(size, size, |row, column| responses[(row, column)])
}

/// The responses of a string that is held at some of its sites, by what they are where it is free:
/// forces there that take every displacement back.
fn held_at(free: &Mat<Complex64>, places: &[usize]) -> Mat<Complex64> {
    let (held, sites) = (places.len(), free.ncols());
    let among = Mat::from_fn(held, held, |row, column| {
        free[(places[row], places[column])]
    });
    let moved = Mat::from_fn(held, sites, |row, column| free[(places[row], column)]);
    let forces = equations::solve_complex(&among, &moved);
    free - products::product_complex(moved.transpose(), forces.as_ref())
}
