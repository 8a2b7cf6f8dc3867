//! Mode shapes: next to a natural frequency the string answers a load anywhere by that mode
//! alone.

use num_complex::Complex64;

use super::frequencies::{Motion, NaturalFrequencies};
use crate::assembly::matrix::ResponseMatrix;
use crate::drillstring::SurfaceSupport;
use crate::error::BuildError;
use crate::sites::Sites;
use crate::waves::lateral::BendingNetwork;
use crate::waves::network::TorsionNetwork;

/// Where the surface is looked at: this part of the length below it.
const NEXT_TO_SURFACE: f64 = 1e-6;

/// As far from a natural frequency, as a part of it, the string is looked at: nearer, rounding
/// takes as much as other modes add.
const OFF_RESONANCE: f64 = 1e-6;

/// A mode along the string, from the surface to the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Depths, m.
    pub depths: Vec<f64>,
    /// Amplitude at each (rotation in torsion, displacement in bending) in parts of the
    /// greatest, which is 1.
    pub amplitudes: Vec<f64>,
}

impl NaturalFrequencies {
    /// The shape of the mode of a natural frequency (rad/s) at this many depths, at least 2, at
    /// equal distances. Of modes closer to one another than a part of 1e-5 it is a mixture.
    ///
    /// # Errors
    /// Where this is not finite, because the string's constants are extreme.
    pub fn shape(&self, frequency: f64, depths: usize) -> Result<Shape, BuildError> {
        let length = self.string.length();
        let last = depths.max(2) - 1;
        let depths = (0..=last).map(|index| length * index as f64 / last as f64);
        let depths: Vec<f64> = depths.collect();
        let place = |depth: &f64| length - depth.max(NEXT_TO_SURFACE * length);
        let distances: Vec<f64> = depths.iter().map(place).collect();
        let responses = self.responses(&Sites::new(&self.string, &distances)?, frequency)?;
        let size = |site: usize| responses[(site, site)].norm();
        let most = (0..responses.size())
            .max_by(|&one, &other| size(one).total_cmp(&size(other)))
            .unwrap_or(last);
        let of_most = responses[(most, most)];
        let answers = (0..=last).map(|site| (responses[(site, most)] / of_most).re);
        let mut amplitudes: Vec<f64> = answers.collect();
        if self.holds_surface() {
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

    fn responses(&self, sites: &Sites, frequency: f64) -> Result<ResponseMatrix, BuildError> {
        let s = Complex64::new(0.0, frequency * (1.0 + OFF_RESONANCE));
        Ok(match &self.motion {
            Motion::Torsion => {
                let network = TorsionNetwork::new(&self.string, sites)?;
                network.admittance(s).from_torque
            }
            Motion::Bending {
                bending, support, ..
            } => BendingNetwork::new(&self.string, *bending, *support, sites)?.receptance(s),
        })
    }

    fn holds_surface(&self) -> bool {
        let free = SurfaceSupport::Free;
        !matches!(self.motion, Motion::Bending { support, .. } if support == free)
    }
}
