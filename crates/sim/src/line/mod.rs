//! The string between the ports at which loads act, as lines: of each motion one.
//! Every kind of line answers the same two questions in every step: how would its
//! ports move without the loads of this step, and how far does a load move them within it? Then
//! it takes the loads that the laws have found.
//!
//! | made of | the past is | within a step |
//! |---|---|---|
//! | impulse responses ([`channel`]) | summed over all loads so far (Eq. 17) | every port feels every other |
//! | finite elements that are stepped ([`channel`]) | the motion of all nodes | the same |
//! | poles that all sites share ([`poles`]) | a number for each | the same |
//! | pieces between the ports ([`pieces`]) | waves on their way | a port feels its neighbours |

pub(crate) mod chain;
pub(crate) mod channel;
pub(crate) mod pieces;
pub(crate) mod poles;
pub(crate) mod torsion;
pub(crate) mod walls;
mod waves;

pub(crate) use chain::Chain;
pub(crate) use channel::{AxialLines, Bending, Channel, Past, Torsion};
pub(crate) use torsion::{TorsionLine, TorsionPast, Within};
pub(crate) use walls::WallPorts;
