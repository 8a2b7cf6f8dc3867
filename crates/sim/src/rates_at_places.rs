//! How places along a string move along its axis above a bit that cuts, found after a case.
//!
//! The rate of penetration at a place follows from what its surface does and from the weight on bit, as that
//! of the bit does: v(k) = v_surface(k) − Σ A(k − n) W(n). Of a case that begins with steady drilling only
//! the weight counts, by how much it differs from that: accelerations are differences.

use linear::budget::{Budget, Need, OutOfBudget, REAL, What};
use linear::{ResponseError, Responses};

use crate::convolution::Kernels;
use crate::error::SimulationError;
use crate::sampling::Sampling;
use crate::scene::Axial;
use crate::surface::{SurfaceProfile, SurfaceResponse, convolved};
use crate::trajectory::Trajectory;
use crate::watch::axial::{AxialAcceleration, AxialShocks};

/// Rates of penetration at some places, ready to be found for any motion of a string.
#[derive(Debug, Clone)]
pub struct RatesAtPlaces {
    places: Vec<Place>,
    sampling: Sampling,
}

#[derive(Debug, Clone)]
struct Place {
    /// From a force on the bit.
    from_bit: Kernels,
    /// From a surface whose final speed is 1 m/s.
    from_surface: SurfaceResponse,
}

impl RatesAtPlaces {
    /// What it takes of a budget for a number of places, by responses of a number of taps.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(places: usize, taps: usize, budget: &Budget) -> Result<(), OutOfBudget> {
        let of_place = Kernels::bytes(1, taps, true) + SurfaceResponse::bytes(taps);
        budget.pass(Need::lasting(places as f64 * of_place), What::Simulator)
    }

    /// Bytes that finding them takes of a motion of a number of steps, without the motion.
    pub fn bytes_of_motion(steps: f64) -> f64 {
        // The forces, their sums, and what a convolution keeps of them.
        REAL * 24.0 * steps
    }

    /// Of the first places of responses to a force at their bit, which lies below them or is the last of
    /// them, under a surface that moves like this.
    ///
    /// # Errors
    /// Where there are no such responses.
    pub fn new(
        responses: &Responses,
        places: usize,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        let sampling = Sampling::new(
            responses.sampling_frequency,
            responses.method.collocation_offset(),
        );
        let axial = responses.axial().ok_or(SimulationError::NoAxialInput)?;
        let bit = (responses.sites.bit_site()).ok_or(SimulationError::NoAxialInput)?;
        let place = |place: usize| {
            let (taps, surface) = (
                axial.taps_between(bit, place).ok_or(ResponseError::Shape)?,
                axial.from_surface.get(place).ok_or(ResponseError::Shape)?,
            );
            Ok(Place {
                from_bit: Kernels::of(&[vec![taps]]),
                from_surface: SurfaceResponse::new(surface, profile, sampling),
            })
        };
        Ok(Self {
            places: (0..places)
                .map(place)
                .collect::<Result<_, ResponseError>>()?,
            sampling,
        })
    }

    /// Rates of a motion at a place, m/s, from the surface down, without that of steady drilling where it
    /// began so; none beyond the last place.
    pub fn rates(&self, place: usize, scene: &Axial, motion: &Trajectory) -> Vec<f64> {
        let Some(place) = self.places.get(place) else {
            return Vec::new();
        };
        let weight = motion.weight_at_start;
        let kicked = |step: usize| {
            let time = self.sampling.time_of(step);
            let [_, force] = scene.kick.map_or([0.0; 2], |kick| kick.at(time));
            force
        };
        let forces = motion.cut.iter().enumerate();
        let forces: Vec<f64> = forces
            .map(|(step, cut)| weight - cut.weight + kicked(step))
            .collect();
        let mut rates = convolved(&place.from_bit, &forces);
        if weight == 0.0 {
            for (step, rate) in rates.iter_mut().enumerate() {
                *rate += scene.feed * place.from_surface.at(step);
            }
        }
        rates
    }

    /// Acceleration in all steps of a motion from one on, of the place where it is greatest within the band
    /// of its sensor (Hz); `None` where there are no places or no such steps.
    pub fn acceleration(
        &self,
        scene: &Axial,
        motion: &Trajectory,
        (bands, from): (&[f64], usize),
    ) -> Option<AxialAcceleration> {
        let of_place = |(place, band): (usize, &f64)| {
            let mut shocks = AxialShocks::new(*band, self.sampling.frequency);
            let rates = self.rates(place, scene, motion);
            for (step, rate) in rates.into_iter().enumerate() {
                shocks.see(rate, step >= from);
            }
            shocks.measures()
        };
        let all = bands.iter().enumerate().filter_map(of_place);
        let peak = |of: &AxialAcceleration| of.in_band.map_or(0.0, |within| within.peak);
        all.max_by(|one, other| peak(one).total_cmp(&peak(other)))
    }
}
