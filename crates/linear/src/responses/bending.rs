//! Lateral responses by any method: displacements per force, as long as the
//! simulation.

use num_complex::Complex64;

use super::channels::ChannelResponses;
use super::drag_at_rest::DragAtRest;
use super::length::{
    MOST_TAPS, all_finite, needed_taps, samples_of, taps_of, too_many, transform_length,
};
use super::place_quantity::PlaceQuantity;
use super::request::Request;
use crate::assembly::lanes::Lanes;
use crate::assembly::matrix::ResponseMatrix;
use crate::assembly::number::Number;
use crate::assembly::working_bytes;
use crate::bending::{Bending, SurfaceSupport};
use crate::budget::{Budget, Need, REAL, What};
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::elements::newmark::Weights;
use crate::elements::recurrence::ElementChain;
use crate::error::BuildError;
use crate::filters::quadrature::{Formula, Sampling};
use crate::filters::{Buffers, direct, held, hilbert, quadrature};
use crate::method::{FiniteElement, Method, Transform};
use crate::passivity::{Ending, Reciprocity};
use crate::poles::PolePlan;
use crate::sites::{Sites, SitesAndPlaces};
use crate::waves::lateral::BendingNetwork;

/// Lateral responses before they are built.
#[derive(Debug)]
pub(super) struct BendingPlan<'a> {
    string: &'a Drillstring,
    method: &'a Method,
    request: &'a Request,
    bending: &'a Bending,
    support: SurfaceSupport,
    wanted: Wanted,
    /// Whose displacements are made, by the nodes at which the string is cut; none where moments are
    /// wanted.
    pairs: Vec<Pair>,
    /// Taps of each response.
    taps: usize,
    /// Of what they are made of.
    buffers: Buffers,
    /// What makes them of it, where poles do.
    poles: Option<PolePlan<'a>>,
}

/// What is wanted of a string that bends.
#[derive(Debug, Clone)]
pub(super) enum Wanted {
    /// Displacements of all sites of the request from forces there.
    Displacements,
    /// The same or moments at some places.
    AtPlaces(PlaceQuantity, SitesAndPlaces),
}

impl<'a> BendingPlan<'a> {
    /// By one method.
    ///
    /// # Errors
    /// Where the method cannot treat the string, or responses would be too long.
    pub(super) fn new(
        string: &'a Drillstring,
        method: &'a Method,
        request: &'a Request,
        (bending, support): (&'a Bending, SurfaceSupport),
        wanted: Wanted,
    ) -> Result<Self, BuildError> {
        bending.check()?;
        let taps = taps_of(request.longest_time, request.sampling_frequency)?;
        let sites = request.sites.len();
        let (pairs, channels) = match &wanted {
            Wanted::Displacements => {
                let pairs = pairs(method, sites);
                let count = pairs.len();
                (pairs, count)
            }
            Wanted::AtPlaces(quantity, cut) => {
                let pairs = match quantity {
                    PlaceQuantity::Displacement => cut.pairs().collect(),
                    PlaceQuantity::Moment => Vec::new(),
                };
                (pairs, cut.places.len() * sites)
            }
        };
        let buffers = match method {
            Method::Held | Method::Poles => held::smooth_buffers(taps, channels),
            Method::Quadrature | Method::Trapezoidal | Method::FiniteElement(_) => {
                quadrature::buffers(taps, channels, Sampling::Close)
            }
            Method::Hilbert(transform) => {
                let length = transform_length_of(string, method, bending, transform, request)?;
                hilbert::buffers(length, channels)
            }
            Method::DirectIdft(transform) => {
                let length = transform_length_of(string, method, bending, transform, request)?;
                direct::buffers(length, channels)
            }
        };
        let poles = match (method, &wanted) {
            (Method::Poles, Wanted::Displacements) => {
                let frequency = request.sampling_frequency;
                let bends = (bending, support);
                Some(PolePlan::new(string, bends, &request.sites, frequency)?)
            }
            _ => None,
        };
        if buffers.taps > MOST_TAPS {
            return Err(too_many(buffers.taps as f64));
        }
        Ok(Self {
            string,
            method,
            request,
            bending,
            support,
            wanted,
            pairs,
            taps,
            buffers,
            poles,
        })
    }

    /// Taps of each response.
    pub(super) fn taps(&self) -> usize {
        self.taps
    }

    /// What building takes.
    pub(super) fn need(&self) -> Need {
        let sites = self.request.sites.len();
        let (responses, nodes) = match &self.wanted {
            Wanted::Displacements => (sites * sites, sites),
            Wanted::AtPlaces(_, cut) => (cut.places.len() * sites, cut.nodes.len()),
        };
        let kept = REAL * (responses * self.taps) as f64;
        let made = match &self.poles {
            None => self.buffers.need(working_bytes::<Lanes>(nodes, 4)),
            Some(poles) => poles.need().then(Need::lasting(kept)),
        };
        match self.method {
            Method::Held
            | Method::Poles
            | Method::Quadrature
            | Method::Trapezoidal
            | Method::FiniteElement(_) => Need {
                peak: made.peak.max(kept),
                kept,
            },
            // Taps are made of velocities, of more of them, which then go.
            Method::Hilbert(_) | Method::DirectIdft(_) => Need {
                kept,
                ..made.then(Need::lasting(kept))
            },
        }
    }

    /// Builds the displacements of all sites from a force at each.
    ///
    /// # Errors
    /// Where they are not finite, or ask for more memory than is left.
    pub(super) fn build(&self, budget: &Budget) -> Result<ChannelResponses, BuildError> {
        let working = budget.begin(self.need(), What::Responses)?;
        let taps = self.taps_of_pairs()?;
        working.done();
        let sites = self.request.sites.len();
        Ok(ChannelResponses {
            channel: Channel::Bending,
            loads: (0..sites).collect(),
            from_surface: Vec::new(),
            from_loads: self.in_both_directions(taps),
            ending: Ending::Cut,
        })
    }

    /// Responses of all sites from all, `[output][input]`, from those of the pairs.
    fn in_both_directions(&self, of_pairs: Vec<Vec<f64>>) -> Vec<Vec<Vec<f64>>> {
        let sites = self.request.sites.len();
        let mut all = vec![vec![Vec::new(); sites]; sites];
        for (&(output, input), taps) in self.pairs.iter().zip(of_pairs) {
            if all[input][output].is_empty() {
                all[input][output] = taps.clone();
            }
            all[output][input] = taps;
        }
        all
    }

    /// Puts down the receptances of the pairs.
    fn write_pairs(&self, receptance: &ResponseMatrix<Lanes>, responses: &mut [Lanes]) {
        for (response, pair) in responses.iter_mut().zip(&self.pairs) {
            *response = receptance[*pair];
        }
    }

    /// Responses by pair of sites, or of what is wanted at each place from each force.
    ///
    /// # Errors
    /// Where they are not finite.
    pub(super) fn taps_of_pairs(&self) -> Result<Vec<Vec<f64>>, BuildError> {
        let taps = self.made_taps()?;
        all_finite(&taps, self.method)?;
        Ok(taps)
    }

    /// Where the string is cut.
    fn nodes(&self) -> &Sites {
        match &self.wanted {
            Wanted::Displacements => &self.request.sites,
            Wanted::AtPlaces(_, cut) => &cut.nodes,
        }
    }

    fn made_taps(&self) -> Result<Vec<Vec<f64>>, BuildError> {
        let (bending, support, request) = (self.bending, self.support, self.request);
        let network = BendingNetwork::new(self.string, *bending, support, self.nodes())?;
        let (frequency, needed, count) =
            (request.sampling_frequency, self.taps, self.buffers.channels);
        let answer = |s: Lanes, responses: &mut [Lanes]| match &self.wanted {
            Wanted::AtPlaces(PlaceQuantity::Moment, cut) => {
                responses.copy_from_slice(&network.moments(s, cut));
            }
            Wanted::Displacements | Wanted::AtPlaces(PlaceQuantity::Displacement, _) => {
                self.write_pairs(&network.receptance(s), responses);
            }
        };
        let by_formula = |formula: Formula| {
            let sampling = Sampling::Close;
            quadrature::taps(formula, frequency, needed, count, sampling, &answer)
        };
        let drag = DragAtRest::of(self.string, bending);
        let velocity = |s: Lanes, responses: &mut [Lanes]| {
            answer(s, responses);
            for (pair, response) in responses.iter_mut().enumerate() {
                let answer = *response;
                *response = Lanes::of_lanes(|lane| match s.lane(lane) {
                    Complex64::ZERO => self.rigid(pair, &drag).into(),
                    s => s * answer.lane(lane),
                });
            }
        };
        if let Some(poles) = &self.poles {
            let poles = poles.build(&Budget::unlimited())?;
            let of_pair = |(output, input): &Pair| poles.taps(*output, *input, needed);
            return Ok(self.pairs.iter().map(of_pair).collect());
        }
        Ok(match self.method {
            Method::Held | Method::Poles => {
                let taps = held::smooth_taps(frequency, needed, count, &velocity);
                at_mid_step(integrate(taps, needed, frequency))
            }
            Method::Quadrature => by_formula(Formula::BackwardDifferences),
            Method::Trapezoidal => by_formula(Formula::Trapezoidal),
            Method::FiniteElement(parameters) => self.element_taps(parameters)?,
            Method::Hilbert(_) => {
                let filter = hilbert::taps(frequency, self.buffers, &velocity);
                integrate(filter, needed, frequency)
            }
            Method::DirectIdft(_) => {
                let filter = direct::taps(frequency, self.buffers, &velocity);
                integrate(filter, needed, frequency)
            }
        })
    }

    /// The velocity response at zero frequency, where the string moves as a rigid rod against the
    /// drag along it: translation and rotation where the surface is free, rotation alone where it is
    /// pinned, nothing where it is clamped. An axial force does not let it turn for ever.
    fn rigid(&self, response: usize, drag: &DragAtRest) -> f64 {
        if let Wanted::AtPlaces(PlaceQuantity::Moment, _) = self.wanted {
            // That bends nothing.
            return 0.0;
        }
        let (output, input) = self.pairs[response];
        let (length, distances) = (
            self.string.bending_length(),
            self.nodes().distances_from_bit(),
        );
        let depth = |site: usize| (length - distances[site]) / length;
        let places = [depth(output), depth(input)];
        let turns = self.bending.compression == 0.0 && self.string.axial_force().is_empty();
        let springs = self.nodes().springs().iter();
        let held: Vec<usize> = springs
            .enumerate()
            .filter_map(|(site, spring)| (*spring > 0.0).then_some(site))
            .collect();
        match self.support {
            SurfaceSupport::Free if turns && held.len() == 1 => {
                drag.of_turning_about(depth(held[0]), places)
            }
            _ if !held.is_empty() => 0.0,
            SurfaceSupport::Free if turns => drag.of_rod(places),
            SurfaceSupport::Free => 1.0 / drag.whole,
            SurfaceSupport::Pinned if turns => drag.of_turning_about(0.0, places),
            SurfaceSupport::Pinned | SurfaceSupport::Clamped => 0.0,
        }
    }

    fn element_taps(&self, parameters: &FiniteElement) -> Result<Vec<Vec<f64>>, BuildError> {
        let request = self.request;
        let chain = ElementChain::new(
            self.string,
            Channel::Bending,
            self.nodes(),
            parameters.elements_per_cell,
            Weights::new(parameters, request.sampling_frequency)?,
        )?;
        let (bending, support) = (self.bending, self.support);
        let answer = |zeta: Lanes, responses: &mut [Lanes]| match &self.wanted {
            Wanted::AtPlaces(PlaceQuantity::Moment, cut) => {
                let moments = chain.moments(bending, support, zeta, cut);
                responses.copy_from_slice(&moments);
            }
            Wanted::Displacements | Wanted::AtPlaces(PlaceQuantity::Displacement, _) => {
                let receptance = chain.receptance(bending, support, zeta);
                self.write_pairs(&receptance, responses);
            }
        };
        let (taps, count) = (self.taps, self.buffers.channels);
        Ok(quadrature::series(taps, count, Sampling::Close, &answer))
    }
}

/// Two nodes: output and input.
type Pair = (usize, usize);

/// Whether the responses of a method are the same in both directions.
pub(super) fn reciprocity(method: &Method) -> Reciprocity {
    match method.is_reciprocal() {
        true => Reciprocity::Exact,
        false => Reciprocity::None,
    }
}

/// The pairs of sites whose responses differ, row by row.
fn pairs(method: &Method, sites: usize) -> Vec<Pair> {
    let inputs = |output: usize| match reciprocity(method) {
        Reciprocity::Exact => output + 1,
        Reciprocity::None => sites,
    };
    let row = |output: usize| (0..inputs(output)).map(move |input| (output, input));
    (0..sites).flat_map(row).collect()
}

/// Length of the transform behind a filter, which is twice as long as the simulation.
fn transform_length_of(
    string: &Drillstring,
    method: &Method,
    bending: &Bending,
    transform: &Transform,
    request: &Request,
) -> Result<usize, BuildError> {
    if bending.damping <= 0.0 && string.loss().viscous_mud().is_none() {
        let (method, channel) = (method.name(), Channel::Bending);
        return Err(BuildError::NeedsDamping { method, channel });
    }
    let needed = needed_taps(request.longest_time, request.sampling_frequency);
    let samples = samples_of(transform, 2.0 * needed, request.sampling_frequency);
    transform_length(samples, request.sampling_frequency)
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
