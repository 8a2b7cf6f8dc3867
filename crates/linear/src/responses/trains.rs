//! Torsional responses as trains of impulses, once for all sampling frequencies.

use super::request::{ChannelRequest, Request};
use super::rounds::{Rounds, bytes_of};
use super::wanted::Wanted;
use crate::assembly::lanes::Lanes;
use crate::assembly::working_bytes;
use crate::budget::{Budget, Need, Reserved};
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
    /// Those that a request for [`crate::Method::Held`] needs, at any sampling frequency; `None`
    /// where it asks for no torsion.
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
            .map(|torques| {
                let plan = TrainsPlan::new(string, request, Wanted::Sites { torques })?;
                let budget = Budget::unlimited();
                let (trains, _) = plan.build_within(&budget)?;
                Ok(trains)
            })
            .transpose()
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
        let taps = self
            .trains
            .iter()
            .map(|train| held::shared(train, spacing, held::taps_of(train.len(), spacing)));
        (taps.collect(), self.ending)
    }

    /// Impulses of each train, and the time between two, s.
    pub(super) fn length(&self) -> (usize, f64) {
        (self.trains.first().map_or(0, Vec::len), self.step)
    }

    /// Memory that they take, bytes.
    pub fn bytes(&self) -> f64 {
        bytes_of(&self.trains)
    }
}

/// Trains of impulses before they are built.
#[derive(Debug)]
pub(super) struct TrainsPlan<'a> {
    string: &'a Drillstring,
    request: &'a Request,
    wanted: Wanted<'a>,
    lattice: Lattice,
    rounds: Rounds,
}

impl<'a> TrainsPlan<'a> {
    /// # Errors
    /// Where the sites are not the string's, or trains would be too long.
    pub(super) fn new(
        string: &'a Drillstring,
        request: &'a Request,
        wanted: Wanted<'a>,
    ) -> Result<Self, BuildError> {
        let lattice = Lattice::new(string, &request.sites)?;
        let sites = request.sites.len();
        let size = (wanted.count(sites), working_bytes(sites, 1));
        let on_lattice = on_lattice(request, &lattice);
        Ok(Self {
            rounds: Rounds::new(string, &on_lattice, (held::SAMPLING, false), size)?,
            string,
            request,
            wanted,
            lattice,
        })
    }

    /// Impulses of each train, at most, and the time between two, s.
    pub(super) fn length(&self) -> (usize, f64) {
        (self.rounds.taps(), self.lattice.step)
    }

    /// What building takes.
    pub(super) fn need(&self) -> Need {
        self.rounds.need()
    }

    /// Builds them, within a budget that has them until their memory is dropped.
    ///
    /// # Errors
    /// As [`crate::ResponsePlan::build`].
    pub(super) fn build_within<'b>(
        &self,
        budget: &'b Budget,
    ) -> Result<(ImpulseTrains, Reserved<'b>), BuildError> {
        let Self {
            string,
            request,
            wanted,
            lattice,
            rounds,
        } = self;
        let response = |zeta: Lanes, responses: &mut [Lanes]| {
            let torque = || lattice.surface_torque(zeta);
            wanted.write(|| lattice.admittance(zeta), torque, responses);
        };
        let count = wanted.count(request.sites.len());
        let built = rounds.build(budget, |impulses, sampling| {
            quadrature::series(impulses, count, sampling, &response)
        })?;
        let trains = ImpulseTrains {
            string: string.id(),
            sites: request.sites.clone(),
            torques: wanted.torques().to_vec(),
            longest_time: request.longest_time,
            step: lattice.step,
            trains: built.taps,
            ending: match built.ending {
                // Nothing makes fronts on a lattice smoother.
                Ending::Cut => Ending::Ringing,
                ending => ending,
            },
        };
        Ok((trains, built.memory))
    }
}

/// A request for the impulses that its taps are made of: the last tap takes them from the step
/// before it and from that after it.
fn on_lattice(request: &Request, lattice: &Lattice) -> Request {
    Request {
        sampling_frequency: 1.0 / lattice.step,
        longest_time: request.longest_time + 2.0 / request.sampling_frequency,
        ..request.clone()
    }
}
