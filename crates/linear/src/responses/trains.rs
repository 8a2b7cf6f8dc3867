//! Torsional responses as trains of impulses, once for all sampling frequencies.

use super::decay::until_decayed;
use super::request::{ChannelRequest, Request};
use super::wanted::Wanted;
use crate::assembly::lanes::Lanes;
use crate::drillstring::{Drillstring, StringId};
use crate::error::{BuildError, ResponseError};
use crate::filters::{held, quadrature};
use crate::passivity::Ending;
use crate::sites::Sites;
use crate::waves::lattice::Lattice;

/// The torsional responses of a string on its lattice: trains of impulses, one after each
/// travel time of a piece. What is held over the steps of any sampling frequency is
/// answered by sharing them out between these steps, which takes far less time than to find
/// them.
#[derive(Debug, Clone, PartialEq)]
pub struct ImpulseTrains {
    string: StringId,
    sites: Sites,
    torques: Vec<usize>,
    longest_time: f64,
    /// Time between two impulses, s.
    step: f64,
    /// Of all sites from the surface, then of all sites from each torque.
    trains: Vec<Vec<f64>>,
    ending: Ending,
}

impl ImpulseTrains {
    /// Those that a request for [`crate::Method::Held`] needs, whatever its sampling
    /// frequency; `None` where it asks for no torsion.
    ///
    /// # Errors
    /// As [`crate::responses()`].
    pub fn new(string: &Drillstring, request: &Request) -> Result<Option<Self>, BuildError> {
        request.check(string)?;
        let torques = request.channels.iter().find_map(|channel| match channel {
            ChannelRequest::Torsion { torques } => Some(torques),
            ChannelRequest::Bending { .. } => None,
        });
        torques
            .map(|torques| Self::of_wanted(string, request, Wanted::Sites { torques }))
            .transpose()
    }

    pub(super) fn of_wanted(
        string: &Drillstring,
        request: &Request,
        wanted: Wanted,
    ) -> Result<Self, BuildError> {
        let lattice = Lattice::new(string, &request.sites)?;
        let on_lattice = on_lattice(request, &lattice);
        let response = |zeta: Lanes, responses: &mut [Lanes]| {
            let torque = || lattice.surface_torque(zeta);
            wanted.write(|| lattice.admittance(zeta), torque, responses);
        };
        let count = wanted.count(request.sites.len());
        let (trains, ending) =
            until_decayed(string, &on_lattice, held::SAMPLING, |length, sampling| {
                quadrature::series(length, count, sampling, &response)
            })?;
        let ending = match ending {
            // Nothing makes fronts on a lattice smoother.
            Ending::Cut => Ending::Ringing,
            ending => ending,
        };
        Ok(Self {
            string: string.id(),
            sites: request.sites.clone(),
            torques: wanted.torques().to_vec(),
            longest_time: request.longest_time,
            step: lattice.step,
            trains,
            ending,
        })
    }

    /// Refuses to stand for those of another string or request.
    pub(super) fn check(
        &self,
        string: &Drillstring,
        request: &Request,
        torques: &[usize],
    ) -> Result<(), BuildError> {
        let is_of_request = self.string == string.id()
            && self.sites == request.sites
            && self.torques == torques
            && self.longest_time >= request.longest_time;
        if is_of_request {
            Ok(())
        } else {
            Err(ResponseError::OtherString.into())
        }
    }

    /// The taps at a sampling frequency, Hz, and how they end.
    pub(super) fn taps(&self, sampling_frequency: f64) -> (Vec<Vec<f64>>, Ending) {
        let spacing = self.step * sampling_frequency;
        let taps = self.trains.iter().map(|train| {
            let count = (train.len() as f64 * spacing).ceil() as usize;
            held::shared(train, spacing, count)
        });
        (taps.collect(), self.ending)
    }

    /// Memory that they take, bytes.
    pub fn bytes(&self) -> f64 {
        let numbers: usize = self.trains.iter().map(Vec::len).sum();
        (numbers * size_of::<f64>()) as f64
    }
}

/// A request for the impulses that its taps are made of: the last tap takes them from the step
/// before it and from that after it.
pub(crate) fn on_lattice(request: &Request, lattice: &Lattice) -> Request {
    Request {
        sampling_frequency: 1.0 / lattice.step,
        longest_time: request.longest_time + 2.0 / request.sampling_frequency,
        ..request.clone()
    }
}
