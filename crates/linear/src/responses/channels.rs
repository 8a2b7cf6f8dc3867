//! Discrete impulse responses A(0), A(1), …: the only thing that leaves this crate
//! for a simulation (Eqs. 59–61).

use crate::budget::REAL;
use crate::channel::{Channel, Port};
use crate::drillstring::StringId;
use crate::error::ResponseError;
use crate::method::Method;
use crate::passivity::Ending;
use crate::sites::Sites;

/// The responses of one string by one method, a block for each channel; where a scene
/// needs no bending, there is none.
///
/// With inputs E and taps A, `output(k) = Σ A(k − n) E(n)` for n ≤ k: a tap includes
/// the factor 1/f_s of Eq. 61.
#[derive(Debug, Clone, PartialEq)]
pub struct Responses {
    /// The string.
    pub string: StringId,
    /// The method.
    pub method: Method,
    /// Where the string is observed; these alone say which of them is the bit's.
    pub sites: Sites,
    /// Sampling frequency f_s, Hz.
    pub sampling_frequency: f64,
    /// The longest time, s, that may be simulated with them.
    pub longest_time: f64,
    /// A block for each channel.
    pub channels: Vec<ChannelResponses>,
}

/// The responses of one channel, equally long. Past its last tap a response that ends
/// whole is zero.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelResponses {
    /// The channel.
    pub channel: Channel,
    /// The sites, by number, that a load acts on, one for each input.
    pub loads: Vec<usize>,
    /// To each site from the surface: from its speed in torsion and axial motion, dimensionless;
    /// nothing in bending, where the surface stays.
    pub from_surface: Vec<Vec<f64>>,
    /// `from_loads[site][load]`, to each site from each load: rad/s per N m in torsion,
    /// m/N in bending, m/s per N in axial motion.
    pub from_loads: Vec<Vec<Vec<f64>>>,
    /// Whether the response ends with its taps, or only the simulation does. In bending
    /// the response continues: a string held by damping alone does not return within any time of
    /// interest.
    pub ending: Ending,
}

impl Responses {
    /// Those of a channel, where they were asked for.
    pub fn channel(&self, channel: Channel) -> Option<&ChannelResponses> {
        self.channels.iter().find(|one| one.channel == channel)
    }

    /// Those in torsion.
    pub fn torsion(&self) -> Option<&ChannelResponses> {
        self.channel(Channel::Torsion)
    }

    /// Those in bending.
    pub fn bending(&self) -> Option<&ChannelResponses> {
        self.channel(Channel::Bending)
    }

    /// Those of axial motion.
    pub fn axial(&self) -> Option<&ChannelResponses> {
        self.channel(Channel::Axial)
    }

    /// Taps from a load at a port to the motion of another, both of one channel.
    pub fn taps(&self, from: Port, to: Port) -> Option<&[f64]> {
        if from.channel != to.channel {
            return None;
        }
        self.channel(from.channel)?.taps_between(from.site, to.site)
    }

    /// Taps from a torque at the bit to its own speed, where the bit is a site and a
    /// torque acts there.
    pub fn at_bit(&self) -> Option<&[f64]> {
        let bit = Port {
            site: self.sites.bit_site()?,
            channel: Channel::Torsion,
        };
        self.taps(bit, bit)
    }

    /// Checks that they can be responses of a string.
    ///
    /// # Errors
    /// Where they are not.
    pub fn check(&self) -> Result<(), ResponseError> {
        let value = self.sampling_frequency;
        if !(value.is_finite() && value > 0.0) {
            return Err(ResponseError::SamplingFrequency { value });
        }
        for (index, channel) in self.channels.iter().enumerate() {
            let mut before = self.channels[..index].iter();
            if before.any(|other| other.channel == channel.channel) {
                return Err(ResponseError::Shape);
            }
            channel.check(self.sites.len())?;
            let needed = self.longest_time * self.sampling_frequency;
            let reaches = channel.taps() as f64 >= needed * (1.0 - SAME_TIME);
            if channel.ending != Ending::Whole && !reaches {
                return Err(ResponseError::TooShort {
                    taps: channel.taps(),
                    longest_time: self.longest_time,
                });
            }
        }
        Ok(())
    }
}

/// A number of taps is known as a time to this part of it.
const SAME_TIME: f64 = 1e-9;

impl ChannelResponses {
    /// Number of taps of each response.
    pub fn taps(&self) -> usize {
        let from_loads = self.from_loads.iter().flatten();
        let mut all = self.from_surface.iter().chain(from_loads);
        all.next().map_or(0, Vec::len)
    }

    /// Memory of all taps, bytes.
    pub(super) fn bytes(&self) -> f64 {
        let from_loads: usize = self.from_loads.iter().map(Vec::len).sum();
        REAL * ((self.from_surface.len() + from_loads) * self.taps()) as f64
    }

    /// Taps from a load at a site to another; none where no load acts there.
    pub fn taps_between(&self, from: usize, to: usize) -> Option<&[f64]> {
        let load = self.loads.iter().position(|&site| site == from)?;
        self.from_loads.get(to)?.get(load).map(Vec::as_slice)
    }

    /// Responses between the sites that loads act on, `[output][input]`.
    pub fn driving_points(&self) -> Vec<Vec<&[f64]>> {
        let between = |site: usize| -> Vec<&[f64]> {
            self.from_loads[site].iter().map(Vec::as_slice).collect()
        };
        self.loads.iter().map(|&site| between(site)).collect()
    }

    fn check(&self, sites: usize) -> Result<(), ResponseError> {
        if let Some(&site) = self.loads.iter().find(|&&site| site >= sites) {
            return Err(ResponseError::NoSuchSite { site, sites });
        }
        let from_surface = match self.channel {
            Channel::Torsion | Channel::Axial => sites,
            Channel::Bending => 0,
        };
        if self.from_surface.len() != from_surface
            || self.from_loads.len() != sites
            || (self.from_loads.iter()).any(|row| row.len() != self.loads.len())
        {
            return Err(ResponseError::Shape);
        }
        let taps = self.taps();
        for response in (self.from_surface.iter()).chain(self.from_loads.iter().flatten()) {
            if taps == 0 || response.len() != taps {
                return Err(ResponseError::Shape);
            }
            if !response.iter().all(|tap| tap.is_finite()) {
                return Err(ResponseError::NotFinite);
            }
        }
        for (load, &site) in self.loads.iter().enumerate() {
            let value = self.from_loads[site][load][0];
            if value <= 0.0 {
                return Err(ResponseError::Instant { site, value });
            }
        }
        Ok(())
    }
}
