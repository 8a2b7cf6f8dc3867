//! Torsional responses by any method (Sections 2.4 and 3).

use super::channels::ChannelResponses;
use super::decay::{first_length, until_decayed};
use super::length::{all_finite, samples_of, transform_length};
use super::request::Request;
use super::trains::ImpulseTrains;
use super::wanted::Wanted;
use crate::assembly::lanes::Lanes;
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::elements::newmark::Weights;
use crate::elements::recurrence::ElementChain;
use crate::error::BuildError;
use crate::estimates::torsional_settling_time;
use crate::filters::quadrature::{Formula, Sampling};
use crate::filters::{direct, hilbert, quadrature};
use crate::method::{FiniteElement, Method, Transform};
use crate::passivity::Ending;
use crate::waves::network::TorsionNetwork;

/// A digital filter lasts at least so many time constants of what seeps along the
/// string: its static stiffness is then right to a part in a thousand.
const SEEPING_TIMES: f64 = 8.0;

/// What torsional responses are built from.
struct Torsion<'a> {
    string: &'a Drillstring,
    method: &'a Method,
    request: &'a Request,
    /// What is to be known.
    wanted: Wanted<'a>,
    /// What held responses are made of, where that is there.
    trains: Option<&'a ImpulseTrains>,
}

/// Builds the torsional responses of a string by one method.
pub(super) fn responses(
    string: &Drillstring,
    method: &Method,
    request: &Request,
    torques: &[usize],
    trains: Option<&ImpulseTrains>,
) -> Result<ChannelResponses, BuildError> {
    let torsion = Torsion {
        string,
        method,
        request,
        wanted: Wanted::Sites { torques },
        trains,
    };
    let (taps, ending) = torsion.taps()?;
    all_finite(&taps, method)?;
    Ok(torsion.by_site(taps, torques, ending))
}

/// Taps of the torque with which the surface of a string has to be turned, from the speed that
/// it is set to, N m per rad/s; below a top drive that of its motor. No torque acts below: one
/// that does, at a site, is met at the surface as less by the site's response from the surface
/// (reciprocity). As long as the time of the request at least, or as they last.
///
/// # Errors
/// As [`crate::responses()`].
pub fn surface_torque(
    string: &Drillstring,
    method: &Method,
    request: &Request,
) -> Result<Vec<f64>, BuildError> {
    request.check(string)?;
    let torsion = Torsion {
        string,
        method,
        request,
        wanted: Wanted::SurfaceTorque,
        trains: None,
    };
    let (mut taps, _) = torsion.taps()?;
    all_finite(&taps, method)?;
    Ok(taps.pop().unwrap_or_default())
}

impl Torsion<'_> {
    /// Responses of all sites from the surface, then of all sites from each torque.
    fn taps(&self) -> Result<(Vec<Vec<f64>>, Ending), BuildError> {
        match self.method {
            Method::Held => self.held_taps(),
            Method::Quadrature => self.quadrature_taps(Formula::BackwardDifferences),
            Method::Trapezoidal => self.quadrature_taps(Formula::Trapezoidal),
            Method::Hilbert(transform) => {
                let length = self.transform_length(transform)?;
                let (frequency, response) =
                    (self.request.sampling_frequency, self.wave_response()?);
                let taps = hilbert::taps(frequency, length, self.count(), &response);
                Ok((taps, Ending::Whole))
            }
            Method::DirectIdft(transform) => {
                let length = self.transform_length(transform)?;
                let (frequency, response) =
                    (self.request.sampling_frequency, self.wave_response()?);
                let taps = direct::taps(frequency, length, self.count(), &response);
                Ok((taps, Ending::Whole))
            }
            Method::FiniteElement(parameters) => self.element_taps(parameters),
        }
    }

    fn held_taps(&self) -> Result<(Vec<Vec<f64>>, Ending), BuildError> {
        let taps = |trains: &ImpulseTrains| trains.taps(self.request.sampling_frequency);
        match self.trains {
            Some(trains) => {
                trains.check(self.string, self.request, self.wanted.torques())?;
                Ok(taps(trains))
            }
            None => {
                let trains = ImpulseTrains::of_wanted(self.string, self.request, self.wanted)?;
                Ok(taps(&trains))
            }
        }
    }

    fn quadrature_taps(&self, formula: Formula) -> Result<(Vec<Vec<f64>>, Ending), BuildError> {
        let response = self.wave_response()?;
        until_decayed(
            self.string,
            self.request,
            Sampling::Close,
            |length, sampling| {
                quadrature::taps(
                    formula,
                    self.request.sampling_frequency,
                    length,
                    self.count(),
                    sampling,
                    &response,
                )
            },
        )
    }

    /// Length of the transform behind a filter.
    fn transform_length(&self, transform: &Transform) -> Result<usize, BuildError> {
        if self.string.torsional_damping() <= 0.0 {
            return Err(BuildError::NeedsDamping {
                method: self.method.name(),
            });
        }
        let sampling_frequency = self.request.sampling_frequency;
        let samples = transform_samples(self.string, transform, sampling_frequency);
        transform_length(samples, sampling_frequency)
    }

    /// Exact frequency responses.
    fn wave_response(&self) -> Result<impl Fn(Lanes, &mut [Lanes]) + Sync + '_, BuildError> {
        let network = TorsionNetwork::new(self.string, &self.request.sites)?;
        Ok(move |s: Lanes, responses: &mut [Lanes]| {
            let torque = || network.surface_torque(s);
            (self.wanted).write(|| network.admittance(s), torque, responses);
        })
    }

    fn element_taps(
        &self,
        parameters: &FiniteElement,
    ) -> Result<(Vec<Vec<f64>>, Ending), BuildError> {
        let weights = Weights::new(parameters, self.request.sampling_frequency)?;
        let sites = &self.request.sites;
        let chain = ElementChain::new(
            self.string,
            Channel::Torsion,
            sites,
            parameters.elements_per_cell,
            weights,
        )?;
        let response = |zeta: Lanes, responses: &mut [Lanes]| {
            let torque = || chain.surface_torque(zeta);
            (self.wanted).write(|| chain.admittance(zeta), torque, responses);
        };
        until_decayed(
            self.string,
            self.request,
            Sampling::Close,
            |length, sampling| quadrature::series(length, self.count(), sampling, &response),
        )
    }

    /// Number of responses.
    fn count(&self) -> usize {
        self.wanted.count(self.request.sites.len())
    }

    /// From one list to responses by site and load.
    fn by_site(
        &self,
        mut taps: Vec<Vec<f64>>,
        loads: &[usize],
        ending: Ending,
    ) -> ChannelResponses {
        let (sites, torques) = (self.request.sites.len(), loads.len());
        let mut from_torques = taps.split_off(sites).into_iter();
        ChannelResponses {
            channel: Channel::Torsion,
            loads: loads.to_vec(),
            from_surface: taps,
            from_loads: (0..sites)
                .map(|_| from_torques.by_ref().take(torques).collect())
                .collect(),
            ending,
        }
    }
}

/// The transform behind a filter is as long as the string's vibration lasts,
/// however short the simulation: what it cuts off is folded back (Section 2.4).
/// The taps have an algebraic tail, so that watching them decay would not tell
/// when to stop.
pub(crate) fn transform_samples(
    string: &Drillstring,
    transform: &Transform,
    sampling_frequency: f64,
) -> f64 {
    let seeps = SEEPING_TIMES * torsional_settling_time(string) * sampling_frequency;
    let first = first_length(string, sampling_frequency)
        .map_or(f64::INFINITY, |taps| taps.next_power_of_two() as f64);
    samples_of(transform, 2.0 * seeps.max(first), sampling_frequency)
}
