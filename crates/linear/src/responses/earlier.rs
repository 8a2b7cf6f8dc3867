//! Channels in which a string moves as one that was built before.

use super::channels::{ChannelResponses, Responses};
use super::request::{ChannelRequest, Request};
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::method::Method;

/// Responses that are there, with what they are of.
#[derive(Debug, Clone, Copy)]
pub struct Earlier<'a> {
    /// The string.
    pub string: &'a Drillstring,
    /// What was asked for.
    pub request: &'a Request,
    /// What was built for it.
    pub responses: &'a Responses,
}

impl<'a> Earlier<'a> {
    /// Those of a channel, where the same would be built for another string and request.
    pub(super) fn channel(
        &self,
        string: &Drillstring,
        method: &Method,
        request: &Request,
        wanted: &ChannelRequest,
    ) -> Option<&'a ChannelResponses> {
        let channel = wanted.channel();
        let is_same = self.responses.method == *method
            && self.request.sites == request.sites
            && self.request.sampling_frequency == request.sampling_frequency
            && self.request.longest_time == request.longest_time
            && self.request.channels.contains(wanted)
            && move_alike(self.string, string, channel);
        self.responses.channel(channel).filter(|_| is_same)
    }
}

/// Whether two strings move alike in a channel. Torsion feels nothing of what is around a string,
/// viscous mud apart, or pulls at it, bending nothing of what damps or drives its rotation.
fn move_alike(one: &Drillstring, other: &Drillstring, channel: Channel) -> bool {
    let is_same = one.material() == other.material() && one.sections() == other.sections();
    is_same
        && match channel {
            Channel::Torsion => {
                one.loss() == other.loss()
                    && one.mud_around() == other.mud_around()
                    && one.top_drive() == other.top_drive()
            }
            // The request names its rod.
            Channel::Axial => true,
            Channel::Bending => {
                one.hole() == other.hole()
                    && one.axial_force() == other.axial_force()
                    && one.loss().loss_factor() == other.loss().loss_factor()
            }
        }
}
