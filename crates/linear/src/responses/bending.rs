//! Lateral responses by any method: displacements per force, as long as the
//! simulation.

use num_complex::Complex64;

use super::channels::ChannelResponses;
use super::length::{MOST_TAPS, all_finite, needed_taps, samples_of, too_many, transform_length};
use super::request::Request;
use crate::assembly::lanes::Lanes;
use crate::assembly::number::Number;
use crate::channel::Channel;
use crate::drillstring::{Bending, Drillstring, SurfaceSupport};
use crate::elements::newmark::Weights;
use crate::elements::recurrence::ElementChain;
use crate::error::BuildError;
use crate::filters::quadrature::{Formula, Sampling};
use crate::filters::{direct, held, hilbert, quadrature};
use crate::method::{FiniteElement, Method, Transform};
use crate::passivity::Ending;
use crate::waves::lateral::BendingNetwork;

/// What lateral responses are built from.
struct Lateral<'a> {
    string: &'a Drillstring,
    method: &'a Method,
    request: &'a Request,
    bending: &'a Bending,
    support: SurfaceSupport,
}

/// Builds the lateral responses of a string by one method.
pub(super) fn responses(
    string: &Drillstring,
    method: &Method,
    request: &Request,
    bending: &Bending,
    support: SurfaceSupport,
) -> Result<ChannelResponses, BuildError> {
    let needed = needed_taps(request.longest_time, request.sampling_frequency);
    if needed > MOST_TAPS as f64 {
        return Err(too_many(needed));
    }
    let lateral = Lateral {
        string,
        method,
        request,
        bending,
        support,
    };
    let taps = lateral.taps(needed as usize)?;
    all_finite(&taps, method)?;
    let (sites, mut taps) = (request.sites.len(), taps.into_iter());
    Ok(ChannelResponses {
        channel: Channel::Bending,
        loads: (0..sites).collect(),
        from_surface: Vec::new(),
        from_loads: (0..sites)
            .map(|_| taps.by_ref().take(sites).collect())
            .collect(),
        ending: Ending::Cut,
    })
}

impl Lateral<'_> {
    /// Responses of each site from each force, so many taps long.
    fn taps(&self, needed: usize) -> Result<Vec<Vec<f64>>, BuildError> {
        let (bending, support, request) = (self.bending, self.support, self.request);
        let network = BendingNetwork::new(self.string, *bending, support, &request.sites)?;
        let sampling_frequency = request.sampling_frequency;
        let count = request.sites.len().pow(2);
        let displacement = |s: Lanes, responses: &mut [Lanes]| {
            responses.copy_from_slice(network.receptance(s).entries());
        };
        let by_formula = |formula: Formula| {
            let sampling = Sampling::Close;
            quadrature::taps(
                formula,
                sampling_frequency,
                needed,
                count,
                sampling,
                &displacement,
            )
        };
        let velocity = |s: Lanes, responses: &mut [Lanes]| {
            let receptance = network.receptance(s);
            for (pair, response) in responses.iter_mut().enumerate() {
                let receptance = receptance.entries()[pair];
                *response = Lanes::of_lanes(|lane| match s.lane(lane) {
                    Complex64::ZERO => self.rigid(pair).into(),
                    s => s * receptance.lane(lane),
                });
            }
        };
        Ok(match self.method {
            Method::Held => {
                let taps = held::smooth_taps(sampling_frequency, needed, count, &velocity);
                at_mid_step(integrate(taps, needed, sampling_frequency))
            }
            Method::Quadrature => by_formula(Formula::BackwardDifferences),
            Method::Trapezoidal => by_formula(Formula::Trapezoidal),
            Method::FiniteElement(parameters) => self.element_taps(parameters, needed)?,
            Method::Hilbert(transform) => {
                let length = self.transform_length(transform)?;
                let filter = hilbert::taps(sampling_frequency, length, count, &velocity);
                integrate(filter, needed, sampling_frequency)
            }
            Method::DirectIdft(transform) => {
                let length = self.transform_length(transform)?;
                let filter = direct::taps(sampling_frequency, length, count, &velocity);
                integrate(filter, needed, sampling_frequency)
            }
        })
    }

    /// Length of the transform behind a filter.
    fn transform_length(&self, transform: &Transform) -> Result<usize, BuildError> {
        if self.bending.damping <= 0.0 {
            return Err(BuildError::NeedsDamping {
                method: self.method.name(),
            });
        }
        let samples = transform_samples(transform, self.request);
        transform_length(samples, self.request.sampling_frequency)
    }

    /// The velocity response at zero frequency of a pair of sites, row by row, where the
    /// string moves as a rigid rod against its dashpots: translation and rotation where the
    /// surface is free, rotation alone where it is pinned, nothing where it is clamped. An
    /// axial force does not let it turn for ever.
    fn rigid(&self, pair: usize) -> f64 {
        let (length, distances) = (
            self.string.length(),
            self.request.sites.distances_from_bit(),
        );
        let depth = |site: usize| (length - distances[site]) / length;
        let (a, b) = (depth(pair / distances.len()), depth(pair % distances.len()));
        let turns = self.bending.compression == 0.0 && self.string.axial_force().is_empty();
        let shape = match self.support {
            SurfaceSupport::Free if turns => 1.0 + 12.0 * (a - 0.5) * (b - 0.5),
            SurfaceSupport::Free => 1.0,
            SurfaceSupport::Pinned if turns => 3.0 * a * b,
            SurfaceSupport::Pinned | SurfaceSupport::Clamped => 0.0,
        };
        shape / (self.bending.damping * length)
    }

    fn element_taps(
        &self,
        parameters: &FiniteElement,
        needed: usize,
    ) -> Result<Vec<Vec<f64>>, BuildError> {
        let request = self.request;
        let sites = request.sites.len();
        let chain = ElementChain::new(
            self.string,
            Channel::Bending,
            &request.sites,
            parameters.elements_per_cell,
            Weights::new(parameters, request.sampling_frequency)?,
        )?;
        let receptance = |zeta: Lanes, responses: &mut [Lanes]| {
            let receptance = chain.receptance(self.bending, self.support, zeta);
            responses.copy_from_slice(receptance.entries());
        };
        Ok(quadrature::series(
            needed,
            sites * sites,
            Sampling::Close,
            &receptance,
        ))
    }
}

/// The transform behind a filter is twice as long as the simulation.
pub(crate) fn transform_samples(transform: &Transform, request: &Request) -> f64 {
    let needed = needed_taps(request.longest_time, request.sampling_frequency);
    samples_of(transform, 2.0 * needed, request.sampling_frequency)
}

/// Displacement taps as running sums of velocity taps over f_s (end of Section
/// 2.4); past the last velocity tap the displacement stays.
fn integrate(velocity: Vec<Vec<f64>>, needed: usize, sampling_frequency: f64) -> Vec<Vec<f64>> {
    velocity
        .into_iter()
        .map(|taps| {
            let mut sum = 0.0;
            (0..needed)
                .map(|index| {
                    sum += taps.get(index).copied().unwrap_or(0.0);
                    sum / sampling_frequency
                })
                .collect()
        })
        .collect()
}

/// The mean of the displacements at both ends of every step, from those at its end.
fn at_mid_step(mut displacements: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    for taps in &mut displacements {
        let mut before = 0.0;
        for tap in taps {
            let end = std::mem::replace(tap, 0.5 * (before + *tap));
            before = end;
        }
    }
    displacements
}
