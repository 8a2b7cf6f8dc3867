//! The linear part as all cases share it: responses ready to step against.

use linear::{ChannelResponses, ResponseError, Responses, SteppedString};

use crate::channel::{Bending, Channel, Torsion};
use crate::convolution::Kernel;
use crate::error::SimulationError;
use crate::ranges::not_negative;
use crate::sampling::Sampling;
use crate::start::Start;
use crate::surface::{SurfaceProfile, SurfaceResponse};

/// The linear part as all cases share it. What does not depend on the case is computed
/// here once.
#[derive(Debug, Clone)]
pub struct System {
    pub(crate) sites: usize,
    /// The site that is the bit, where one is.
    bit_site: Option<usize>,
    pub(crate) sampling: Sampling,
    /// The longest case, s.
    longest_time: f64,
    /// Response of each site to a surface that comes to 1 rad/s.
    surface: Vec<SurfaceResponse>,
    /// The sites that a torque may act on.
    pub(crate) loaded: Vec<usize>,
    /// From torques to speeds, between loaded sites.
    pub(crate) from_torques: Torsion,
    /// From a torque at the bit to the speeds of the sites that bear none, which are only
    /// looked at.
    to_others: Vec<(usize, Kernel)>,
    /// From forces to displacements, between all sites, where bending is modelled.
    pub(crate) from_forces: Option<Bending>,
}

impl System {
    /// Prepares responses for cases as long as they were built for, whose surface turns at
    /// its speed from t = 0 on.
    ///
    /// # Errors
    /// Where they are not those of a string, there are none in torsion, or those in
    /// bending are of sites where no torque may act.
    pub fn new(responses: &Responses) -> Result<Self, SimulationError> {
        Self::started(responses, &SurfaceProfile::default())
    }

    /// The same for cases whose surface comes to its speed in another way.
    ///
    /// # Errors
    /// As [`System::new`], and where there is no such start.
    pub fn started(
        responses: &Responses,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        let torsion = checked_torsion(responses, profile)?;
        let sites = responses.sites.len();
        let loaded = torsion.loads.clone();
        let bending = responses.bending();
        if let Some(bending) = bending
            && !(bending.loads.iter().copied().eq(0..sites) && loaded == bending.loads)
        {
            return Err(SimulationError::UnlikeChannels);
        }
        let to_others = to_others(torsion, responses.sites.bit_site());
        let from_torques = Channel::of_taps(&torsion.driving_points());
        let from_forces = bending.map(|bending| Channel::of_taps(&bending.from_loads));
        Ok(Self {
            to_others,
            ..Self::of(responses, profile, (loaded, from_torques, from_forces))?
        })
    }

    /// The same of a string whose elements are stepped, loads acting at any of its sites, with
    /// its responses to the surface.
    ///
    /// # Errors
    /// As [`System::started`], and where the responses are those of other sites.
    pub fn stepped(
        string: &SteppedString,
        responses: &Responses,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        let sites = string.torsion().sites();
        if responses.sites.len() != sites {
            return Err(ResponseError::OtherSites.into());
        }
        let from_torques = Channel::of_mesh(string.torsion());
        let from_forces = Channel::of_mesh(string.bending());
        let channels = ((0..sites).collect(), from_torques, Some(from_forces));
        Self::of(responses, profile, channels)
    }

    /// From responses to the surface, and the channels between sites that loads act on.
    fn of(
        responses: &Responses,
        profile: &SurfaceProfile,
        (loaded, from_torques, from_forces): (Vec<usize>, Torsion, Option<Bending>),
    ) -> Result<Self, SimulationError> {
        let torsion = checked_torsion(responses, profile)?;
        let sampling = Sampling::new(responses.sampling_frequency, responses.method.moment());
        Ok(Self {
            sites: responses.sites.len(),
            bit_site: responses.sites.bit_site(),
            sampling,
            longest_time: responses.longest_time,
            surface: (torsion.from_surface.iter())
                .map(|taps| SurfaceResponse::new(taps, profile, sampling))
                .collect(),
            from_torques,
            to_others: Vec::new(),
            from_forces,
            loaded,
        })
    }

    /// Speeds of all sites, rad/s, in a number of steps: what a start and a surface that turns at
    /// `surface_speed` (rad/s) in the end make of them and, but for sites that bear torques
    /// themselves, the torques on the bit (N m, positive with the rotation). Sites that are only looked at follow from these: whoever has simulated
    /// a bit without them has their motion here.
    pub fn driven_speeds(
        &self,
        surface_speed: f64,
        start: &Start,
        bit_torque: &[f64],
        steps: usize,
    ) -> Vec<Vec<f64>> {
        let at_start = start.steady();
        let speed = |site: usize, step: usize| match at_start {
            None => surface_speed * self.surface_response(site, step),
            Some(motion) => motion.speeds[site],
        };
        let of_surface = |site: usize| (0..steps).map(|step| speed(site, step)).collect();
        let mut speeds: Vec<Vec<f64>> = (0..self.sites).map(of_surface).collect();
        let load = |(step, torque): (usize, &f64)| {
            let before = at_start.map_or(0.0, |it| it.at_bit.at(self.sampling.time_of(step)));
            torque - before
        };
        let loads: Vec<f64> = bit_torque.iter().enumerate().map(load).collect();
        for (site, kernel) in &self.to_others {
            for (step, (speed, load)) in speeds[*site].iter_mut().zip(&loads).enumerate() {
                *speed += kernel.past_sum(&loads[..step]) + kernel.instant() * load;
            }
        }
        speeds
    }

    /// Where the bit is, and which of the loads acts there; `None` where none does.
    pub(crate) fn bit_load(&self) -> Option<BitLoad> {
        let site = self.bit_site?;
        let load = self.loaded.iter().position(|&loaded| loaded == site)?;
        Some(BitLoad { site, load })
    }

    /// Speed of a site in a step, per unit surface speed, no torque acting.
    #[inline]
    pub(crate) fn surface_response(&self, site: usize, step: usize) -> f64 {
        self.surface[site].at(step)
    }

    /// Steps until the response to the surface has settled.
    pub(crate) fn surface_settles(&self, site: usize) -> usize {
        self.surface[site].settles()
    }

    /// Steps after which a wave from the surface arrives at a site: the response to the
    /// surface is a part of its last value.
    pub(crate) fn surface_arrives(&self, site: usize, part: f64) -> usize {
        let least = part * self.surface[site].last().abs();
        let mut speeds = self.surface[site].until_settled();
        speeds.position(|speed| speed.abs() > least).unwrap_or(0)
    }

    /// Steps until the response to the surface stays within a part of its last value.
    pub(crate) fn surface_is_steady_from(&self, site: usize, part: f64) -> usize {
        let last = self.surface[site].last();
        let is_off = |speed: f64| (speed - last).abs() > part * last.abs();
        let mut speeds = self.surface[site].until_settled();
        speeds.rposition(is_off).map_or(0, |step| step + 1)
    }

    /// Steps of a case, that at its start included.
    pub(crate) fn steps_of(&self, duration: f64) -> usize {
        (duration * self.sampling.frequency).ceil() as usize + 1
    }

    /// What is said where the motion of a loaded site is no number.
    pub(crate) fn not_finite(&self, index: usize, time: f64) -> SimulationError {
        let site = self.loaded[index];
        SimulationError::NotFinite { site, time }
    }

    /// Refuses a case that lasts longer than this is prepared for.
    pub(crate) fn lasts_for(&self, duration: f64) -> Result<(), SimulationError> {
        let prepared = self.longest_time;
        if duration <= prepared {
            Ok(())
        } else {
            Err(SimulationError::LongerThanPrepared { duration, prepared })
        }
    }
}

/// The bit among the sites, and among the loads.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BitLoad {
    pub(crate) site: usize,
    pub(crate) load: usize,
}

/// The responses in torsion of what is sound, with a start that there is.
fn checked_torsion<'a>(
    responses: &'a Responses,
    profile: &SurfaceProfile,
) -> Result<&'a ChannelResponses, SimulationError> {
    profile.check()?;
    not_negative("longest time in s", responses.longest_time)?;
    responses.check()?;
    let channel = linear::Channel::Torsion;
    Ok((responses.torsion()).ok_or(ResponseError::NoChannel { channel })?)
}

fn to_others(torsion: &ChannelResponses, bit_site: Option<usize>) -> Vec<(usize, Kernel)> {
    let others = (0..torsion.from_loads.len()).filter(|site| !torsion.loads.contains(site));
    let kernel = |site| Some((site, Kernel::new(torsion.taps_between(bit_site?, site)?)));
    others.filter_map(kernel).collect()
}
