//! What building responses costs in memory, told before anything is built.
//!
//! Counts of what the builders hold at once, times bytes: taps, channels, nodes and
//! elements, so that they grow as the real ones do. They are upper bounds, and as
//! floating-point numbers do not overflow, whatever is asked for. The response of a
//! damped string in torsion is as long as its slowest motion lasts, which is bounded
//! from below by the damping of its heaviest tube and by how torque seeps along it.

use crate::assembly::lanes::Lanes;
use crate::assembly::number::Number;
use crate::cascade::{AT_LINK, AT_TOP, first_taps};
use crate::drillstring::Drillstring;
use crate::elements::mesh::most_elements;
use crate::estimates::{torsional_inertia, torsional_settling_time};
use crate::filters::held;
use crate::filters::quadrature::Sampling;
use crate::method::{FiniteElement, Method};
use crate::parallel::threads;
use crate::passivity::REFINEMENT;
use crate::responses::length::{MOST_TAPS, needed_taps, transformable};
use crate::responses::trains::on_lattice;
use crate::responses::{ChannelRequest, Request, bending, decay, torsion};
use crate::sites::Sites;
use crate::waves::lattice::Lattice;

/// Bytes of a real and of a complex number.
const REAL: f64 = 8.0;
const COMPLEX: f64 = 16.0;

/// What a transform holds for each of its samples beside its input: its output, its
/// plan and, for lengths with large prime factors, another, longer transform. Like the
/// next numbers it is measured and rounded up.
const TRANSFORM: f64 = 60.0;

/// The same of a margin, for powers of two.
const MARGIN_TRANSFORM: f64 = 40.0;

/// What assembling and factorising holds for each element, in torsion and in bending.
const BEAM_ELEMENT: f64 = 2400.0;

/// Memory that a piece of work takes, bytes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Memory {
    /// The most while it is done, what it leaves included.
    pub peak: f64,
    /// What it leaves.
    pub kept: f64,
}

impl Memory {
    /// What is taken and kept.
    pub fn lasting(bytes: f64) -> Self {
        Self {
            peak: bytes,
            kept: bytes,
        }
    }

    /// So many such pieces of work at the same time.
    pub fn times(self, count: usize) -> Self {
        Self {
            peak: count as f64 * self.peak,
            kept: count as f64 * self.kept,
        }
    }

    /// Both pieces of work at the same time.
    pub fn beside(self, other: Self) -> Self {
        Self {
            peak: self.peak + other.peak,
            kept: self.kept + other.kept,
        }
    }

    /// This, and then the other.
    pub fn then(self, other: Self) -> Self {
        Self {
            peak: self.peak.max(self.kept + other.peak),
            kept: self.kept + other.kept,
        }
    }
}

/// The lengths of responses and the memory to build them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ResponseCost {
    /// Taps of each response in torsion, at most; none where it is not asked for.
    pub torsion_taps: f64,
    /// The same in bending.
    pub bending_taps: f64,
    /// What building takes.
    pub memory: Memory,
    /// The length asked for, where it is longer than any builder gives
    /// ([`crate::BuildError::TooManyTaps`]).
    pub too_long: Option<f64>,
}

/// The same of one channel.
struct ChannelCost {
    /// Samples or taps that are asked for, and taps that are kept of them.
    asked: f64,
    taps: f64,
    memory: Memory,
}

/// Responses of a [`crate::Cascade`] last at most so many times as long as is tried first: up to
/// 37 times on random strings.
const LASTS: f64 = 64.0;

/// The taps of each response of a [`crate::Cascade`], at most, and what cutting a string takes.
pub fn cascade(
    string: &Drillstring,
    nodes: &Sites,
    sampling_frequency: f64,
    longest_time: f64,
) -> (f64, Memory) {
    let most = needed_taps(longest_time, sampling_frequency);
    let longest = (LASTS * first_taps(string, nodes, sampling_frequency)).min(most);
    let taps = if longest > MOST_TAPS as f64 {
        // It will be refused.
        longest
    } else {
        transformable(longest.ceil() as usize) as f64
    };
    let responses = (AT_TOP + AT_LINK * nodes.len()) as f64;
    let kept = REAL * responses * taps;
    let samples = COMPLEX * samples_of(Sampling::Close, responses * taps);
    let memory = Memory {
        peak: kept + samples + TRANSFORM * samples_of(Sampling::Close, taps) * threads() as f64,
        kept,
    };
    (taps, memory)
}

/// What [`crate::responses()`] takes on the threads of the present pool.
pub fn responses(string: &Drillstring, method: &Method, request: &Request) -> ResponseCost {
    let mut cost = ResponseCost::default();
    for channel in &request.channels {
        let found = match channel {
            ChannelRequest::Torsion { torques } => {
                let found = of_torsion(string, method, request, torques.len());
                cost.torsion_taps = found.taps;
                found
            }
            ChannelRequest::Bending { .. } => {
                let found = of_bending(method, request);
                cost.bending_taps = found.taps;
                found
            }
        };
        cost.memory = cost.memory.beside(found.memory);
        if found.asked > cost.too_long.unwrap_or(MOST_TAPS as f64) {
            cost.too_long = Some(found.asked);
        }
    }
    cost
}

fn of_torsion(
    string: &Drillstring,
    method: &Method,
    request: &Request,
    torques: usize,
) -> ChannelCost {
    let torques = torques as f64;
    let responses = request.sites.len() as f64 * (1.0 + torques);
    let networks = threads() as f64 * network(request.sites.len(), 1);
    let cost = |asked, taps, memory| ChannelCost {
        asked,
        taps,
        memory,
    };
    let transform_samples =
        |transform| torsion::transform_samples(string, transform, request.sampling_frequency);
    match method {
        Method::Held => {
            let ((impulses, sampling), taps) = held_length(string, method, request);
            let samples = samples_of(sampling, impulses);
            let memory = filter(responses, samples, impulses.max(taps), networks);
            cost(impulses, taps, memory)
        }
        Method::Quadrature | Method::Trapezoidal | Method::FiniteElement(_) => {
            let (taps, sampling) = torsion_length(string, method, request, Sampling::Close);
            let memory = filter(responses, samples_of(sampling, taps), taps, networks);
            cost(taps, taps, memory)
        }
        Method::Hilbert(transform) => {
            let samples = transform_samples(transform);
            let taps = 0.5 * samples + 2.0;
            cost(samples, taps, filter(responses, samples, taps, networks))
        }
        Method::DirectIdft(transform) => {
            let samples = transform_samples(transform);
            let memory = filter(responses, samples, samples, networks);
            cost(samples, samples, memory)
        }
    }
}

/// Samples on a circle for so many taps.
fn samples_of(sampling: Sampling, taps: f64) -> f64 {
    sampling.per_tap() as f64 * taps
}

/// Impulses on the lattice until they have decayed, how they are sampled, and the taps that they
/// become; none where there is no lattice, which building refuses.
fn held_length(string: &Drillstring, method: &Method, request: &Request) -> ((f64, Sampling), f64) {
    let none = ((0.0, held::SAMPLING), 0.0);
    Lattice::new(string, &request.sites).map_or(none, |lattice| {
        let on_lattice = on_lattice(request, &lattice);
        let impulses = torsion_length(string, method, &on_lattice, held::SAMPLING);
        let taps = impulses.0 * lattice.step * request.sampling_frequency;
        (impulses, taps.ceil())
    })
}

fn of_bending(method: &Method, request: &Request) -> ChannelCost {
    let sites = request.sites.len() as f64;
    let responses = sites * sites;
    let taps = needed_taps(request.longest_time, request.sampling_frequency);
    let networks = threads() as f64 * network(request.sites.len(), 4);
    let kept = REAL * responses * taps;
    let (asked, memory) = match method {
        Method::Held => {
            let finer = held::SUBSTEPS as f64 * taps;
            let samples = samples_of(held::SAMPLING, finer);
            (finer, filter(responses, samples, finer, networks))
        }
        Method::Quadrature | Method::Trapezoidal | Method::FiniteElement(_) => {
            let samples = samples_of(Sampling::Close, taps);
            (taps, filter(responses, samples, taps, networks))
        }
        Method::Hilbert(transform) | Method::DirectIdft(transform) => {
            let samples = bending::transform_samples(transform, request);
            let filtered = match method {
                Method::Hilbert(_) => filter(responses, samples, 0.5 * samples, networks),
                _ => filter(responses, samples, samples, networks),
            };
            let peak = filtered.peak.max(filtered.kept + kept);
            (samples.max(taps), Memory { peak, kept })
        }
    };
    ChannelCost {
        asked,
        taps,
        memory,
    }
}

/// What [`crate::elements::reconstruction::WholeString::reconstruct`] takes, with so many
/// shapes kept.
pub fn reconstruction(
    string: &Drillstring,
    sites: &Sites,
    parameters: &FiniteElement,
    snapshots: usize,
) -> Memory {
    let elements = most_elements(string, sites, parameters.elements_per_cell);
    let depths_and_peaks = 2.0;
    let kept = REAL * (elements + 1.0) * (depths_and_peaks + 2.0 * snapshots as f64);
    Memory {
        peak: beam(string, sites, parameters, 2.0) + kept,
        kept,
    }
}

/// Numbers for each element that is stepped: its links in torsion and in bending.
const LINK: f64 = 24.0;

/// Numbers for each element in the motion of a case: in torsion and in two planes of bending.
const MOTION: f64 = 15.0;

/// What [`crate::SteppedString`] and its responses to loads at so many of the
/// sites take, and the lengths of these.
pub fn stepped(
    string: &Drillstring,
    request: &Request,
    loads: usize,
    parameters: &FiniteElement,
) -> ResponseCost {
    let sites = request.sites.len() as f64;
    let elements = most_elements(string, &request.sites, parameters.elements_per_cell);
    let taps = needed_taps(request.longest_time, request.sampling_frequency);
    // Of a load at each site no more than all nodes feel.
    let kept =
        REAL * elements * (LINK + 3.0 * sites) + REAL * sites * (1.0 + 2.0 * loads as f64) * taps;
    ResponseCost {
        torsion_taps: taps,
        bending_taps: taps,
        memory: Memory {
            peak: kept + elements * BEAM_ELEMENT,
            kept,
        },
        too_long: (taps > MOST_TAPS as f64).then_some(taps),
    }
}

/// What a case takes that such a string is stepped through.
pub fn stepped_motion(string: &Drillstring, sites: &Sites, parameters: &FiniteElement) -> f64 {
    REAL * MOTION * most_elements(string, sites, parameters.elements_per_cell)
}

/// What the positive-real margin of so many driving points takes (see
/// [`crate::passivity`]).
pub fn margin(inputs: usize, taps: f64) -> f64 {
    if inputs == 0 {
        return 0.0;
    }
    let length = REFINEMENT as f64 * power_of_two_from(taps);
    // Of a Hermitian matrix one half is kept.
    let pairs = 0.5 * inputs as f64 * (inputs as f64 + 1.0);
    pairs * 0.5 * COMPLEX * length + MARGIN_TRANSFORM * length
}

/// The same of sites in bending, where it is that of their velocities.
pub fn bending_margin(sites: usize, taps: f64) -> f64 {
    margin(sites, taps) + REAL * (sites as f64).powi(2) * taps
}

/// A beam and so many motions of it: displacements, velocities, accelerations and
/// forces, beside the accelerations from a load at each site.
fn beam(string: &Drillstring, sites: &Sites, parameters: &FiniteElement, motions: f64) -> f64 {
    let elements = most_elements(string, sites, parameters.elements_per_cell);
    let series = sites.len() as f64 + 4.0 * motions;
    elements * (BEAM_ELEMENT + 2.0 * REAL * series)
}

/// What a thread works with at the frequencies that it looks at together: pieces between
/// nodes, what they come to, so many numbers each, and the responses.
fn network(sites: usize, numbers: usize) -> f64 {
    let kept = 7 * (sites + 1) * numbers + 3 * sites * sites;
    COMPLEX * (Lanes::LANES * kept) as f64
}

/// Responses sampled over half of a transform's frequencies, each then transformed.
fn filter(responses: f64, samples: f64, taps: f64, networks: f64) -> Memory {
    let points = 0.5 * samples + 1.0;
    let sampled = COMPLEX * responses * points;
    let one = COMPLEX * points + TRANSFORM * samples;
    let kept = REAL * responses * taps;
    Memory {
        peak: sampled + networks.max(one + kept),
        kept,
    }
}

/// The length at which a response built longer and longer is left, at most, and how it is
/// sampled then: as what goes on is, unless it is certain to have decayed.
fn torsion_length(
    string: &Drillstring,
    method: &Method,
    request: &Request,
    goes_on: Sampling,
) -> (f64, Sampling) {
    let Ok(lengths) = decay::Lengths::new(string, request) else {
        return (f64::INFINITY, goes_on);
    };
    // The trapezoidal rule rings for ever at the highest frequency.
    if string.torsional_damping() == 0.0 || *method == Method::Trapezoidal {
        return (lengths.last(), goes_on);
    }
    let lasts = DECAYED * request.sampling_frequency / slowest_rate(string);
    let most = lengths.last().min(MOST_TAPS as f64);
    let sampling = if lengths.decay && lasts <= most {
        Sampling::Once
    } else {
        goes_on
    };
    (lengths.doubled_to(lasts).min(most), sampling)
}

/// Time constants until a response counts as decayed, and has been quiet for a quarter of its
/// length: 18, and three more where two motions of one rate meet, t e^(−t), as at critical damping.
const DECAYED: f64 = 29.0;

/// No motion in torsion dies away more slowly than this, 1/s: vibration loses at least
/// what the damping takes of the heaviest tube, and what seeps has a time of its own.
fn slowest_rate(string: &Drillstring) -> f64 {
    let heaviest = string
        .tubes()
        .map(|(_, tube)| tube.polar_moment())
        .fold(0.0, f64::max);
    let damped = string.torsional_damping() / (2.0 * string.material().density * heaviest);
    // What a top drive holds of the inertia is not damped by the string.
    let inertia = torsional_inertia(string);
    let of_drive = string.top_drive().map_or(0.0, |drive| drive.inertia);
    let vibrates = damped * inertia / (inertia + of_drive);
    vibrates.min(1.0 / torsional_settling_time(string))
}

fn power_of_two_from(value: f64) -> f64 {
    value.max(1.0).log2().ceil().exp2()
}
