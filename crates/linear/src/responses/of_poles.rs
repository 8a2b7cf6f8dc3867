//! Responses of poles.

use super::channels::ChannelResponses;
use super::length::taps_of;
use crate::budget::{Budget, REAL, What};
use crate::channel::Channel;
use crate::error::BuildError;
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
        let row = |output| {
            let of_load = |load: &usize| self.taps(output, *load, taps);
            loads.iter().map(of_load).collect()
        };
        Ok(ChannelResponses {
            channel: Channel::Bending,
            loads: loads.to_vec(),
            from_surface: Vec::new(),
            from_loads: (0..sites).map(row).collect(),
            ending: Ending::Cut,
        })
    }
}
