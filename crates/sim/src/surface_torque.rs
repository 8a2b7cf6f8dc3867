//! What turns the surface: the torque that it takes there to turn the string as it turned.

use linear::budget::{Budget, Need, OutOfBudget, REAL, What};
use linear::{ResponseError, Responses};

use crate::convolution::{Convolution, Kernels};
use crate::error::SimulationError;
use crate::ranges::not_negative;
use crate::sampling::Sampling;
use crate::start::Start;
use crate::surface::{SurfaceProfile, SurfaceResponse, convolved};
use crate::trajectory::Trajectory;
use crate::watch::surface::SurfaceMeasures;

/// The torque with which the surface is turned, below a top drive that of its motor, ready to be
/// found for any motion of a string.
///
/// A torque on the string is met at the surface as the speed of its site is by the surface's
/// (reciprocity, Eqs. 44–48): what turns the freely rotating string, less what comes up from
/// the bit and from each wall.
#[derive(Debug, Clone)]
pub struct SurfaceTorque {
    sampling: Sampling,
    profile: SurfaceProfile,
    rotor_inertia: f64,
    /// Of the string alone, per unit of surface speed.
    turned: SurfaceResponse,
    /// Of each site, the response of the torque at the surface to a torque there.
    from_sites: Vec<Kernels>,
    /// The site that is the bit, where one is.
    bit_site: Option<usize>,
    /// How many steps ago the speed was measured that the controller answers to.
    late_by: f64,
}

impl SurfaceTorque {
    /// What it takes of a budget for a number of sites, of responses of a number of taps.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(sites: usize, taps: usize, budget: &Budget) -> Result<(), OutOfBudget> {
        let bytes = sites as f64 * Kernels::bytes(1, taps, true) + SurfaceResponse::bytes(taps);
        budget.pass(Need::lasting(bytes), What::Simulator)
    }

    /// Bytes that finding it takes for a motion of a number of steps, without the motion.
    pub fn bytes_of_motion(taps: usize, steps: f64) -> f64 {
        Convolution::bytes(1, 1, taps, steps) + 2.0 * REAL * steps
    }

    /// For a string with `responses` whose surface turns by a profile; `taps` are those of
    /// [`linear::surface_torque`] by the method of the responses. A motor that holds the surface at
    /// its speed at any torque has a rotor of this inertia, kg m².
    ///
    /// # Errors
    /// Where these are not the responses of a string, or the profile or the inertia is invalid.
    pub fn new(
        responses: &Responses,
        taps: &[f64],
        profile: &SurfaceProfile,
        rotor_inertia: f64,
    ) -> Result<Self, SimulationError> {
        profile.check()?;
        not_negative("inertia of the rotor in kg m²", rotor_inertia)?;
        responses.check()?;
        if taps.is_empty() {
            return Err(ResponseError::Shape.into());
        }
        let channel = linear::Channel::Torsion;
        let torsion = (responses.torsion()).ok_or(ResponseError::NoChannel { channel })?;
        let sampling = Sampling::new(
            responses.sampling_frequency,
            responses.method.collocation_offset(),
        );
        Ok(Self {
            sampling,
            profile: profile.clone(),
            rotor_inertia,
            turned: SurfaceResponse::new(taps, profile, sampling),
            from_sites: (torsion.from_surface.iter())
                .map(|taps| Kernels::of(&[vec![taps]]))
                .collect(),
            bit_site: responses.sites.bit_site(),
            late_by: 0.0,
        })
    }

    /// The same below a drive whose controller answers to its speed of a time (s) ago: what comes up
    /// from the string turns the motor at once, and its torque so much later.
    #[must_use]
    pub fn answering_late(self, delay: f64) -> Self {
        Self {
            late_by: delay * self.sampling.frequency,
            ..self
        }
    }

    /// The torque in every step of a motion, N m, that begins with a start and whose surface
    /// reaches a speed (rad/s).
    pub fn of(&self, surface_speed: f64, start: &Start, motion: &Trajectory) -> Vec<f64> {
        let at_start = start.steady();
        let time = |step: usize| self.sampling.time_of(step);
        let turning = |step: usize| match at_start {
            None => surface_speed * (self.turned.at(step) + self.rotor_torque(step)),
            Some(steady) => steady.at_surface.at(time(step)),
        };
        let mut torques: Vec<f64> = (0..motion.times.len()).map(turning).collect();
        let on_string = motion.torque_on_string();
        let at_bit = self.bit_site.map(|site| {
            let before = |step: usize| at_start.map_or(0.0, |it| it.at_bit.at(time(step)));
            let loads = on_string.iter().enumerate();
            (
                site,
                loads.map(|(step, load)| load - before(step)).collect(),
            )
        });
        // Where the string rubs along its well all torques on it are known, site by site.
        let rubs = !motion.site_torques.is_empty();
        let at_sites = match rubs {
            true => &motion.site_torques,
            false => &motion.wall_torques,
        };
        let at_sites = at_sites.iter().cloned().enumerate();
        for (site, loads) in at_bit.filter(|_| !rubs).into_iter().chain(at_sites) {
            let loads: Vec<f64> = loads;
            let come_up = convolved(&self.from_sites[site], &loads);
            for (step, torque) in torques.iter_mut().enumerate() {
                *torque -= self.late(&come_up, step);
            }
        }
        torques
    }

    /// A series as it was when the controller measured, straight on between two steps.
    fn late(&self, series: &[f64], step: usize) -> f64 {
        let (whole, part) = (self.late_by as usize, self.late_by.fract());
        let at = |step: usize| series.get(step).copied().unwrap_or(0.0);
        let before = |steps: usize| step.checked_sub(steps).map_or(0.0, at);
        match part {
            0.0 => before(whole),
            part => (1.0 - part) * before(whole) + part * before(whole + 1),
        }
    }

    /// What the rotor takes, per unit of surface speed.
    fn rotor_torque(&self, step: usize) -> f64 {
        if self.rotor_inertia == 0.0 {
            return 0.0;
        }
        self.rotor_inertia * self.profile.acceleration(self.sampling.time_of(step))
    }

    /// Its measures, with the last seconds of a motion as its closing window.
    pub fn measures(&self, torques: &[f64], closing_window: f64) -> SurfaceMeasures {
        SurfaceMeasures::of(torques, self.sampling, closing_window)
    }
}
