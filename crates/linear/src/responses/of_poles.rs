//! Responses of poles.

use super::channels::ChannelResponses;
use super::length::taps_of;
use super::places::PlaceResponses;
use crate::budget::{Budget, REAL, What};
use crate::channel::Channel;
use crate::error::BuildError;
use crate::parallel;
use crate::passivity::Ending;
use crate::poles::BendingPoles;

impl BendingPoles {
    /// Asks a budget for responses of a number of sites to forces at a number of them, as long as a
    /// simulation (s), in steps of a sampling frequency (Hz).
    ///
    /// # Errors
    /// Where they would be too long, or that is more than is left.
    pub fn ask_for_responses(
        (sites, loads): (usize, usize),
        (longest_time, sampling_frequency): (f64, f64),
        budget: &Budget,
    ) -> Result<(), BuildError> {
        let taps = taps_of(longest_time, sampling_frequency)?;
        budget
            .reserve(REAL * (sites * loads * taps) as f64, What::Responses)?
            .keep();
        Ok(())
    }

    /// The responses of all sites to forces at some of them, by number, as long as a simulation, s.
    ///
    /// # Errors
    /// Where a site does not exist, or they would be too long.
    pub fn responses(
        &self,
        loads: &[usize],
        longest_time: f64,
    ) -> Result<ChannelResponses, BuildError> {
        let sites = self.sites();
        if let Some(&site) = loads.iter().find(|&&site| site >= sites) {
            return Err(BuildError::NoSuchSite { site, sites });
        }
        let taps = taps_of(longest_time, self.sampling_frequency())?;
        let of_load = |load: usize| self.taps_from(loads[load], 0..sites, taps);
        let mut from_loads = vec![Vec::with_capacity(loads.len()); sites];
        for of_load in parallel::map(loads.len(), 1, of_load) {
            for (site, taps) in from_loads.iter_mut().zip(of_load) {
                site.push(taps);
            }
        }
        Ok(ChannelResponses {
            channel: Channel::Bending,
            loads: loads.to_vec(),
            from_surface: Vec::new(),
            from_loads,
            ending: Ending::Cut,
        })
    }

    /// The displacements at the places of these poles from a force at each site, as long as a simulation, s.
    ///
    /// # Errors
    /// Where they would be too long.
    pub fn place_responses(&self, longest_time: f64) -> Result<PlaceResponses, BuildError> {
        let (sites, places) = (self.sites(), self.places().to_vec());
        let taps = taps_of(longest_time, self.sampling_frequency())?;
        let to_place = |place: usize| self.taps_to(sites + place, taps);
        Ok(PlaceResponses {
            from_forces: parallel::map(places.len(), 1, to_place),
            places,
        })
    }
}
