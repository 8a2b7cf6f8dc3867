//! Torsional responses by any method (Sections 2.4 and 3).

use super::channels::ChannelResponses;
use super::decay::first_length;
use super::length::{all_finite, samples_of, transform_length};
use super::request::Request;
use super::rounds::{Built, Rounds};
use super::slowest::{Scheme, loss_per_step};
use super::trains::{ImpulseTrains, TrainsPlan};
use super::wanted::Wanted;
use crate::assembly::lanes::Lanes;
use crate::assembly::working_bytes;
use crate::budget::{Budget, Need, OutOfBudget, REAL, What};
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::elements::newmark::Weights;
use crate::elements::recurrence::ElementChain;
use crate::error::BuildError;
use crate::estimates::torsional_settling_time;
use crate::filters::quadrature::{Formula, Sampling};
use crate::filters::{Buffers, direct, held, hilbert, quadrature};
use crate::method::{FiniteElement, Method, Transform};
use crate::passivity::Ending;
use crate::waves::network::TorsionNetwork;

/// A digital filter lasts at least this number of time constants of seepage along the string: its
/// static stiffness is then right to a part in a thousand.
const SEEPING_TIMES: f64 = 8.0;

/// Torsional responses before they are built.
#[derive(Debug)]
pub(super) struct TorsionPlan<'a> {
    string: &'a Drillstring,
    method: &'a Method,
    request: &'a Request,
    /// What is to be known.
    wanted: Wanted<'a>,
    lengths: Lengths<'a>,
}

/// How long responses are, by what makes them.
#[derive(Debug)]
enum Lengths<'a> {
    /// Built until they have decayed.
    Rounds(Rounds),
    /// Made of trains of impulses, which are to be built.
    Trains(Box<TrainsPlan<'a>>),
    /// Made of trains that are there.
    Known(&'a ImpulseTrains),
    /// Made by one transform.
    Transform(Buffers),
}

impl<'a> TorsionPlan<'a> {
    /// By one method; held responses are made of trains of impulses, where these are there.
    ///
    /// # Errors
    /// Where the method cannot treat the string, or responses would be too long.
    pub(super) fn new(
        string: &'a Drillstring,
        method: &'a Method,
        request: &'a Request,
        wanted: Wanted<'a>,
        trains: Option<&'a ImpulseTrains>,
    ) -> Result<Self, BuildError> {
        let channels = wanted.count(request.sites.len());
        let on_thread = working_bytes::<Lanes>(request.sites.len(), 1);
        let rounds = |scheme: Scheme| {
            let loss = loss_per_step(string, scheme, request.sampling_frequency);
            let continuing = (Sampling::Close, loss);
            Rounds::new(string, request, continuing, (channels, on_thread)).map(Lengths::Rounds)
        };
        let lengths = match (method, trains) {
            (Method::Held | Method::Poles, Some(trains)) => {
                trains.check(string, request, wanted.torques())?;
                Lengths::Known(trains)
            }
            (Method::Held | Method::Poles, None) => {
                Lengths::Trains(Box::new(TrainsPlan::new(string, request, wanted)?))
            }
            (Method::Quadrature, _) => rounds(Scheme::BackwardDifferences)?,
            (Method::Trapezoidal, _) => rounds(Scheme::Trapezoidal)?,
            (Method::FiniteElement(parameters), _) => {
                let weights = Weights::new(parameters, request.sampling_frequency)?;
                rounds(Scheme::Newmark(weights))?
            }
            (Method::Hilbert(transform), _) => {
                let length = transform_length_of(string, method, transform, request)?;
                Lengths::Transform(hilbert::buffers(length, channels))
            }
            (Method::DirectIdft(transform), _) => {
                let length = transform_length_of(string, method, transform, request)?;
                Lengths::Transform(direct::buffers(length, channels))
            }
        };
        Ok(Self {
            string,
            method,
            request,
            wanted,
            lengths,
        })
    }

    /// Taps of each response, at most.
    pub(super) fn taps(&self) -> usize {
        let of_trains = |(impulses, step): (usize, f64)| {
            held::most_taps_of(impulses, step * self.request.sampling_frequency)
        };
        match &self.lengths {
            Lengths::Rounds(rounds) => rounds.taps(),
            Lengths::Trains(plan) => of_trains(plan.length()),
            Lengths::Known(trains) => of_trains(trains.length()),
            Lengths::Transform(buffers) => buffers.taps,
        }
    }

    /// What building takes.
    pub(super) fn need(&self) -> Need {
        let on_thread = working_bytes::<Lanes>(self.request.sites.len(), 1);
        match &self.lengths {
            Lengths::Rounds(rounds) => rounds.need(),
            Lengths::Transform(buffers) => buffers.need(on_thread),
            Lengths::Known(_) => Need::lasting(self.bytes()),
            Lengths::Trains(plan) => plan.need(self.bytes()),
        }
    }

    /// Of all taps, at most.
    fn bytes(&self) -> f64 {
        REAL * (self.count() * self.taps()) as f64
    }

    /// Builds the responses from the surface and from torques on some sites.
    ///
    /// # Errors
    /// Where they are not finite, ask for more memory than is left, or last longer than they may.
    pub(super) fn build(&self, budget: &Budget) -> Result<ChannelResponses, BuildError> {
        let Built {
            taps,
            ending,
            memory,
        } = self.taps_of_all(budget)?;
        all_finite(&taps, self.method)?;
        memory.keep();
        Ok(self.by_site(taps, self.wanted.torques(), ending))
    }

    /// Responses of all sites from the surface, then of all sites from each torque.
    pub(super) fn taps_of_all<'b>(&self, budget: &'b Budget) -> Result<Built<'b>, BuildError> {
        match &self.lengths {
            Lengths::Rounds(rounds) => self.built_in_rounds(rounds, budget),
            Lengths::Trains(plan) => plan.taps_within(budget),
            Lengths::Known(trains) => self.taps_of_trains(trains, budget),
            Lengths::Transform(buffers) => {
                let need = self.need();
                let working = budget.begin(need, What::Responses)?;
                let (frequency, response) =
                    (self.request.sampling_frequency, self.wave_response()?);
                let taps = match self.method {
                    Method::Hilbert(_) => hilbert::taps(frequency, *buffers, &response),
                    _ => direct::taps(frequency, *buffers, &response),
                };
                Ok(Built {
                    taps,
                    ending: Ending::Whole,
                    memory: working.kept(need.kept),
                })
            }
        }
    }

    fn taps_of_trains<'b>(
        &self,
        trains: &ImpulseTrains,
        budget: &'b Budget,
    ) -> Result<Built<'b>, BuildError> {
        let (impulses, step) = trains.length();
        let frequency = self.request.sampling_frequency;
        let taps = self.count() * held::most_taps_of(impulses, step * frequency);
        let memory = budget.reserve(REAL * taps as f64, What::Responses)?;
        let (taps, ending) = trains.taps(frequency);
        Ok(Built {
            taps,
            ending,
            memory,
        })
    }

    fn built_in_rounds<'b>(
        &self,
        rounds: &Rounds,
        budget: &'b Budget,
    ) -> Result<Built<'b>, BuildError> {
        let (count, frequency) = (self.count(), self.request.sampling_frequency);
        if let Method::FiniteElement(parameters) = self.method {
            let chain = self.chain(parameters)?;
            let response = |zeta: Lanes, responses: &mut [Lanes]| {
                let torque = || chain.surface_torque(zeta);
                let surface = || chain.at_surface(zeta);
                (self.wanted).write(|| chain.admittance(zeta), torque, surface, responses);
            };
            return rounds.build(budget, |taps, sampling| {
                quadrature::series(taps, count, sampling, &response)
            });
        }
        let formula = match self.method {
            Method::Trapezoidal => Formula::Trapezoidal,
            _ => Formula::BackwardDifferences,
        };
        let response = self.wave_response()?;
        rounds.build(budget, |taps, sampling| {
            quadrature::taps(formula, frequency, taps, count, sampling, &response)
        })
    }

    /// Exact frequency responses.
    fn wave_response(&self) -> Result<impl Fn(Lanes, &mut [Lanes]) + Sync + '_, BuildError> {
        let network = TorsionNetwork::new(self.string, &self.request.sites)?;
        Ok(move |s: Lanes, responses: &mut [Lanes]| {
            let torque = || network.surface_torque(s);
            let surface = || network.at_surface(s);
            (self.wanted).write(|| network.admittance(s), torque, surface, responses);
        })
    }

    fn chain(&self, parameters: &FiniteElement) -> Result<ElementChain<'_>, BuildError> {
        let weights = Weights::new(parameters, self.request.sampling_frequency)?;
        ElementChain::new(
            self.string,
            self.string.channel(),
            &self.request.sites,
            parameters.elements_per_cell,
            weights,
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
            channel: self.string.channel(),
            loads: loads.to_vec(),
            from_surface: taps,
            from_loads: (0..sites)
                .map(|_| from_torques.by_ref().take(torques).collect())
                .collect(),
            ending,
        }
    }
}

/// The torque with which the surface of a string has to be turned, before its taps are built.
#[derive(Debug)]
pub struct SurfaceTorquePlan<'a>(TorsionPlan<'a>);

impl<'a> SurfaceTorquePlan<'a> {
    /// By one method, for the string, time and sampling frequency of a request.
    ///
    /// # Errors
    /// As [`crate::ResponsePlan::new`].
    pub fn new(
        string: &'a Drillstring,
        method: &'a Method,
        request: &'a Request,
    ) -> Result<Self, BuildError> {
        request.check(string)?;
        TorsionPlan::new(string, method, request, Wanted::SurfaceTorque, None).map(Self)
    }

    /// Number of taps, at most.
    pub fn taps(&self) -> usize {
        self.0.taps()
    }

    /// What building takes of a budget.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(&self, budget: &Budget) -> Result<(), OutOfBudget> {
        budget.pass(self.0.need(), What::Responses)
    }

    /// Builds the taps (see [`surface_torque`]).
    ///
    /// # Errors
    /// As [`crate::ResponsePlan::build`].
    pub fn build(&self, budget: &Budget) -> Result<Vec<f64>, BuildError> {
        let mut built = self.0.taps_of_all(budget)?;
        all_finite(&built.taps, self.0.method)?;
        built.memory.keep();
        Ok(built.taps.pop().unwrap_or_default())
    }
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
    SurfaceTorquePlan::new(string, method, request)?.build(&Budget::unlimited())
}

/// Length of the transform behind a filter.
fn transform_length_of(
    string: &Drillstring,
    method: &Method,
    transform: &Transform,
    request: &Request,
) -> Result<usize, BuildError> {
    if !string.loss().damps_torsion() {
        let (method, channel) = (method.name(), Channel::Torsion);
        return Err(BuildError::NeedsDamping { method, channel });
    }
    let sampling_frequency = request.sampling_frequency;
    let samples = transform_samples(string, transform, sampling_frequency);
    transform_length(samples, sampling_frequency)
}

/// The transform behind a filter is as long as the string's vibration lasts,
/// however short the simulation: what it cuts off is folded back (Section 2.4).
/// The taps have an algebraic tail, so that watching them decay would not tell
/// when to stop.
fn transform_samples(string: &Drillstring, transform: &Transform, sampling_frequency: f64) -> f64 {
    let seeps = SEEPING_TIMES * torsional_settling_time(string) * sampling_frequency;
    let first = first_length(string, sampling_frequency)
        .map_or(f64::INFINITY, |taps| taps.next_power_of_two() as f64);
    samples_of(transform, 2.0 * seeps.max(first), sampling_frequency)
}
