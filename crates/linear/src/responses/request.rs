//! What responses are wanted for: where, in which channels, from which loads.

use crate::bending::{Bending, SurfaceSupport};
use crate::channel::Channel;
use crate::checks::{check_sampling, check_time};
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::sites::Sites;

/// What is wanted of one channel.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ChannelRequest {
    /// Speeds of all sites, from the surface and from torques.
    Torsion {
        /// The sites, by number, that a torque acts on. Only these become inputs.
        torques: Vec<usize>,
    },
    /// Displacements of all sites, from a force at each.
    Bending {
        /// Bending constants of the string.
        bending: Bending,
        /// How the surface holds the string.
        support: SurfaceSupport,
    },
    /// Speeds along the string of all sites, from the surface and from forces.
    Axial {
        /// The string as a rod that stretches ([`crate::Axial::rod`]).
        rod: Box<Drillstring>,
        /// The sites, by number, that a force acts on. Only these become inputs.
        forces: Vec<usize>,
    },
}

/// What responses are wanted for.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// Where the string is observed, and loads may act.
    pub sites: Sites,
    /// The channels, each once.
    pub channels: Vec<ChannelRequest>,
    /// Sampling frequency f_s, Hz.
    pub sampling_frequency: f64,
    /// The longest time simulated, s. Responses that last much longer are cut off there.
    pub longest_time: f64,
}

impl ChannelRequest {
    /// Which channel it is of.
    pub fn channel(&self) -> Channel {
        match self {
            ChannelRequest::Torsion { .. } => Channel::Torsion,
            ChannelRequest::Bending { .. } => Channel::Bending,
            ChannelRequest::Axial { .. } => Channel::Axial,
        }
    }
}

impl Request {
    /// Checks what does not depend on the method.
    pub(crate) fn check(&self, string: &Drillstring) -> Result<(), BuildError> {
        self.sites.check(string)?;
        check_sampling(self.sampling_frequency)?;
        check_time(self.longest_time)?;
        for (index, request) in self.channels.iter().enumerate() {
            let channel = request.channel();
            let mut before = self.channels[..index].iter();
            if before.any(|other| other.channel() == channel) {
                return Err(BuildError::ChannelTwice { channel });
            }
            let sites = self.sites.len();
            let loads = match request {
                ChannelRequest::Torsion { torques } => torques.as_slice(),
                ChannelRequest::Bending { .. } => &[],
                ChannelRequest::Axial { rod, forces } => {
                    if rod.channel() != channel || rod.sections() != string.sections() {
                        return Err(BuildError::RodOfAnother);
                    }
                    forces.as_slice()
                }
            };
            if let Some(&site) = loads.iter().find(|&&site| site >= sites) {
                return Err(BuildError::NoSuchSite { site, sites });
            }
        }
        Ok(())
    }
}
