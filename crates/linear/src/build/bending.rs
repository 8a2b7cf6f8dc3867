//! Lateral responses by any method: displacements per force, as long as the
//! simulation.

use faer::c64;
use rayon::prelude::*;

use super::{
    MOST_TAPS, all_finite, check_request, needed_taps, samples_of, too_many, transform_length,
};
use crate::drillstring::{Bending, Drillstring, SurfaceSupport};
use crate::elements::newmark::Weights;
use crate::elements::reduction::CondensedBeam;
use crate::error::BuildError;
use crate::filters::quadrature::Formula;
use crate::filters::{direct, hilbert, quadrature};
use crate::method::{FiniteElement, Method, Transform};
use crate::response::{BendingRequest, BendingResponses};
use crate::waves::lateral::BendingNetwork;

/// Builds the lateral responses of a string by one method.
///
/// # Errors
/// Where a parameter is out of range, the method cannot treat the string, or
/// the responses would not fit in memory.
pub fn bending_responses(
    string: &Drillstring,
    bending: &Bending,
    method: &Method,
    request: &BendingRequest,
) -> Result<BendingResponses, BuildError> {
    check_request(
        string,
        &request.sites,
        request.sampling_frequency,
        request.longest_time,
    )?;
    let needed = needed_taps(request.longest_time, request.sampling_frequency);
    if needed > MOST_TAPS as f64 {
        return Err(too_many(needed));
    }
    let needed = needed as usize;
    let network = BendingNetwork::new(string, *bending, request.support, &request.sites)?;
    let sites = request.sites.len();
    let displacement =
        |s: c64, channels: &mut [c64]| fill(&network, s, c64::new(1.0, 0.0), channels);
    let by_formula = |formula: Formula| {
        quadrature::taps(
            formula,
            request.sampling_frequency,
            needed,
            sites * sites,
            &displacement,
        )
    };
    let channels = match method {
        Method::Quadrature => by_formula(Formula::BackwardDifferences),
        Method::Trapezoidal => by_formula(Formula::Trapezoidal),
        Method::FiniteElement(parameters) => {
            element_taps(string, bending, parameters, request, needed)?
        }
        Method::Hilbert(transform) | Method::DirectIdft(transform) => {
            if bending.damping <= 0.0 {
                return Err(BuildError::NeedsDamping {
                    method: method.name(),
                });
            }
            let samples = transform_samples(transform, request);
            let length = transform_length(samples, request.sampling_frequency)?;
            let velocity = |s: c64, channels: &mut [c64]| {
                if s.norm() == 0.0 {
                    fill_rigid(string, bending, request, channels);
                } else {
                    fill(&network, s, s, channels);
                }
            };
            let filter = if matches!(method, Method::Hilbert(_)) {
                hilbert::taps(request.sampling_frequency, length, sites * sites, &velocity)
            } else {
                direct::taps(request.sampling_frequency, length, sites * sites, &velocity)
            };
            integrate(filter, needed, request.sampling_frequency)
        }
    };
    all_finite(&channels, method.name())?;
    let mut channels = channels.into_iter();
    Ok(BendingResponses {
        sites: request.sites.clone(),
        sampling_frequency: request.sampling_frequency,
        from_force: (0..sites)
            .map(|_| channels.by_ref().take(sites).collect())
            .collect(),
    })
}

/// The transform behind a filter is twice as long as the simulation.
pub(crate) fn transform_samples(transform: &Transform, request: &BendingRequest) -> f64 {
    let needed = needed_taps(request.longest_time, request.sampling_frequency);
    samples_of(transform, 2.0 * needed, request.sampling_frequency)
}

/// Writes `factor` times the receptances between all sites.
fn fill(network: &BendingNetwork, s: c64, factor: c64, channels: &mut [c64]) {
    let receptance = network.receptance(s);
    let sites = receptance.nrows();
    for (channel, value) in channels.iter_mut().enumerate() {
        *value = factor * receptance[(channel / sites, channel % sites)];
    }
}

/// Writes the velocity responses at zero frequency, where the string moves as
/// a rigid rod against its dashpots: translation and rotation where the surface
/// is free, rotation alone where it is pinned, nothing where it is clamped.
fn fill_rigid(
    string: &Drillstring,
    bending: &Bending,
    request: &BendingRequest,
    channels: &mut [c64],
) {
    let length = string.length();
    let depths: Vec<f64> = (request.sites.distances_from_bit().iter())
        .map(|distance| (length - distance) / length)
        .collect();
    let sites = depths.len();
    for (channel, value) in channels.iter_mut().enumerate() {
        let (a, b) = (depths[channel / sites], depths[channel % sites]);
        let shape = match request.support {
            SurfaceSupport::Free => 1.0 + 12.0 * (a - 0.5) * (b - 0.5),
            SurfaceSupport::Pinned => 3.0 * a * b,
            SurfaceSupport::Clamped => 0.0,
        };
        *value = c64::new(shape / (bending.damping * length), 0.0);
    }
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

fn element_taps(
    string: &Drillstring,
    bending: &Bending,
    parameters: &FiniteElement,
    request: &BendingRequest,
    needed: usize,
) -> Result<Vec<Vec<f64>>, BuildError> {
    let weights = Weights::new(parameters, request.sampling_frequency)?;
    let beam = CondensedBeam::new(
        string,
        bending,
        request.support,
        &request.sites,
        parameters.elements_per_cell,
        weights,
    )?;
    let sites = request.sites.len();
    let mut by_input: Vec<Vec<Vec<f64>>> = (0..sites)
        .into_par_iter()
        .map(|input| unit_run(&beam, input, sites, needed))
        .collect();
    let pairs = (0..sites).flat_map(|output| (0..sites).map(move |input| (input, output)));
    Ok(pairs
        .map(|(input, output)| std::mem::take(&mut by_input[input][output]))
        .collect())
}

/// Displacements of all sites after a unit force in the first step.
fn unit_run(beam: &CondensedBeam, input: usize, sites: usize, needed: usize) -> Vec<Vec<f64>> {
    let mut motion = beam.rest();
    let mut displacements = vec![Vec::with_capacity(needed); sites];
    for step in 0..needed {
        beam.step_free(&mut motion);
        if step == 0 {
            beam.apply_force(&mut motion, input, 1.0);
        }
        for (site, displacements) in displacements.iter_mut().enumerate() {
            displacements.push(beam.displacement(&motion, site));
        }
    }
    displacements
}
