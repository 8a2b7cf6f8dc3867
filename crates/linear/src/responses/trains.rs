//! Torsional responses as trains of impulses, once for all sampling frequencies.

use super::request::{ChannelRequest, Request};
use super::rounds::{Built, Rounds, bytes_of};
use super::slowest::{Scheme, loss_per_step};
use super::wanted::Wanted;
use crate::assembly::lanes::ManyLanes;
use crate::assembly::working_bytes;
use crate::budget::{Budget, Need, REAL, What};
use crate::drillstring::{Drillstring, StringId};
use crate::error::{BuildError, ResponseError};
use crate::filters::{held, quadrature};
use crate::parallel;
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
    /// Of all sites from the surface, then of all sites from each torque; equal ones once.
    trains: Vec<Vec<f64>>,
    /// Which of them each response is made of.
    made_of: Vec<usize>,
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
            ChannelRequest::Bending { .. } | ChannelRequest::Axial { .. } => None,
        });
        torques
            .map(|torques| {
                let plan = TrainsPlan::new(string, request, Wanted::Sites { torques })?;
                plan.build()
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
        let taps = taps_of_each(&self.trains, self.step * sampling_frequency, self.ending);
        let all = self.made_of.iter().map(|&train| taps[train].clone());
        (all.collect(), self.ending)
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

/// Taps that trains are shared out among.
fn taps_of_each(trains: &[Vec<f64>], spacing: f64, ending: Ending) -> Vec<Vec<f64>> {
    parallel::map(trains.len(), 8, |place| {
        let train = &trains[place];
        let count = held::taps_of(train.len(), spacing, ending);
        held::shared(train, spacing, count)
    })
}

/// The number of turns in which trains are made. A lattice has thousands of steps in a travel time: of a
/// string that rubs, trains between twenty nodes take a hundred times as much as the taps that are kept of
/// them; but each turn goes along the whole string again.
const TURNS: f64 = 5.0;

/// The least and the most bytes of a turn, as sampled and kept. They are the same on any machine and under any
/// limit of memory, as taps are: trains that are made apart are cut where each of them has decayed.
const AT_A_TIME: [f64; 2] = [(1u64 << 28) as f64, (1u64 << 30) as f64];

/// Trains of impulses before they are built.
#[derive(Debug)]
pub(super) struct TrainsPlan<'a> {
    string: &'a Drillstring,
    request: &'a Request,
    wanted: Wanted<'a>,
    lattice: Lattice,
    /// Of all trains, and of those that are made at a time.
    rounds: Rounds,
    at_a_time: Rounds,
    /// Responses that are not equal to one before, by place.
    different: Vec<usize>,
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
        let different = wanted.different(sites);
        let size = (different.len(), working_bytes::<ManyLanes>(sites, 1));
        let on_lattice = on_lattice(request, &lattice);
        let loss = loss_per_step(string, Scheme::Lattice, on_lattice.sampling_frequency);
        let rounds = Rounds::new(string, &on_lattice, (held::SAMPLING, loss), size);
        let rounds = rounds.map_err(on_its_lattice)?;
        let all = rounds.together();
        let [least, most] = AT_A_TIME;
        Ok(Self {
            rounds,
            at_a_time: rounds.within((all / TURNS).clamp(least, most)),
            string,
            request,
            wanted,
            lattice,
            different,
        })
    }

    /// Impulses of each train, at most, and the time between two, s.
    pub(super) fn length(&self) -> (usize, f64) {
        (self.rounds.taps(), self.lattice.step)
    }

    /// What building taps takes that are a number of bytes.
    pub(super) fn need(&self, bytes: f64) -> Need {
        let trains = self.at_a_time.need();
        let kept = bytes;
        if self.at_a_time.channels() == self.different.len() {
            // The trains go once the taps are there.
            let peak = trains.then(Need::lasting(bytes)).peak;
            return Need { peak, kept };
        }
        let peak = trains.peak + bytes;
        Need { peak, kept }
    }

    /// Builds the trains, all at once.
    fn build(&self) -> Result<ImpulseTrains, BuildError> {
        let budget = Budget::unlimited();
        let built = self.trains(&self.rounds, &self.different, &budget)?;
        Ok(ImpulseTrains {
            string: self.string.id(),
            sites: self.request.sites.clone(),
            torques: self.wanted.torques().to_vec(),
            longest_time: self.request.longest_time,
            step: self.lattice.step,
            made_of: self.made_of(),
            trains: built.taps,
            ending: built.ending,
        })
    }

    /// Builds the taps, of some trains at a time, within a budget.
    ///
    /// # Errors
    /// As [`crate::ResponsePlan::build`].
    pub(super) fn taps_within<'b>(&self, budget: &'b Budget) -> Result<Built<'b>, BuildError> {
        let spacing = self.lattice.step * self.request.sampling_frequency;
        let rounds = &self.at_a_time;
        let (mut taps, mut ending) = (Vec::new(), Ending::Whole);
        let mut memory = budget.reserve(0.0, What::Responses)?;
        for places in self.different.chunks(rounds.channels()) {
            let trains = self.trains(rounds, places, budget)?;
            let lengths = trains.taps.iter().map(Vec::len);
            let count: usize = lengths
                .map(|length| held::taps_of(length, spacing, trains.ending))
                .sum();
            memory = memory.and(budget.reserve(REAL * count as f64, What::Responses)?);
            taps.extend(taps_of_each(&trains.taps, spacing, trains.ending));
            if trains.ending != Ending::Whole {
                ending = trains.ending;
            }
        }
        let longest = taps.iter().map(Vec::len).max().unwrap_or(0);
        let made_of = self.made_of();
        let more = REAL * (made_of.len() * longest) as f64 - bytes_of(&taps);
        memory = memory.and(budget.reserve(more, What::Responses)?);
        for taps in &mut taps {
            taps.resize(longest, 0.0);
        }
        // Each response in its place: the first that is made of taps takes them, others copy them.
        let mut all: Vec<Vec<f64>> = vec![Vec::new(); made_of.len()];
        for (&place, taps) in self.different.iter().zip(taps) {
            all[place] = taps;
        }
        for (place, made_of) in made_of.iter().enumerate() {
            let first = self.different[*made_of];
            if first != place {
                all[place] = all[first].clone();
            }
        }
        Ok(Built {
            taps: all,
            ending,
            memory,
        })
    }

    /// For each response which of the trains it is made of.
    fn made_of(&self) -> Vec<usize> {
        let same_as = self.wanted.same_as(self.request.sites.len());
        let train = |place: usize| self.different.partition_point(|&other| other < place);
        same_as.into_iter().map(train).collect()
    }

    /// Some of the trains.
    fn trains<'b>(
        &self,
        rounds: &Rounds,
        places: &[usize],
        budget: &'b Budget,
    ) -> Result<Built<'b>, BuildError> {
        let Self {
            wanted, lattice, ..
        } = self;
        let response = |zeta: ManyLanes, responses: &mut [ManyLanes]| {
            let torque = || lattice.surface_torque(zeta);
            let surface = || lattice.at_surface(zeta);
            wanted.write_some(places, || lattice.driven(zeta), torque, surface, responses);
        };
        let built = rounds.build(budget, |impulses, sampling| {
            quadrature::series(impulses, places.len(), sampling, &response)
        });
        let built = built.map_err(on_its_lattice)?;
        Ok(Built {
            ending: match built.ending {
                // Nothing makes fronts on a lattice smoother.
                Ending::Cut => Ending::Ringing,
                ending => ending,
            },
            ..built
        })
    }
}

/// The error of trains that are too long, whose steps no sampling frequency makes longer.
fn on_its_lattice(error: BuildError) -> BuildError {
    match error {
        BuildError::TooManyTaps { taps, most } => BuildError::TooManyImpulses {
            impulses: taps,
            most,
        },
        error => error,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drillstring::{Material, Section, Tube};

    fn string(damping: f64) -> Drillstring {
        let tube = |outer_radius| Tube {
            length: 300.0,
            inner_radius: 0.04,
            outer_radius,
        };
        let section = Section {
            repeat: 1,
            parts: vec![tube(0.06), tube(0.1)],
        };
        let steel = Material {
            density: 7850.0,
            shear_modulus: 79.3e9,
        };
        Drillstring::new(steel, vec![section], damping).unwrap()
    }

    /// The number of trains that are made together: where they are cut as they have decayed depends on it.
    #[cfg(feature = "parallel")]
    #[test]
    fn as_many_trains_are_made_at_a_time_on_one_thread_as_on_sixteen() {
        let string = string(0.5);
        let places: Vec<f64> = (0..12).map(|place| 50.0 * f64::from(place)).collect();
        let torques: Vec<usize> = (0..12).collect();
        let at_a_time = |threads: usize| {
            let request = Request {
                sites: Sites::new(&string, &places).unwrap(),
                channels: Vec::new(),
                sampling_frequency: 100.0,
                longest_time: 200.0,
            };
            let wanted = Wanted::Sites { torques: &torques };
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.unwrap().install(|| {
                let plan = TrainsPlan::new(&string, &request, wanted).unwrap();
                (plan.different.len(), plan.at_a_time.channels())
            })
        };
        let (all, some) = at_a_time(1);
        assert!(1 < some && some < all, "{some} of {all}");
        assert_eq!(at_a_time(16), (all, some));
    }

    /// To the last bit where nothing is cut before the end of the simulation; else up to what a
    /// response that has decayed is cut off.
    #[test]
    fn taps_of_trains_made_one_by_one_are_those_of_all_at_once() {
        for (damping, off_by_most) in [(0.5, 0.0), (50.0, 1e-9)] {
            let string = string(damping);
            let request = Request {
                sites: Sites::new(&string, &[400.0, 170.0, 0.0]).unwrap(),
                channels: Vec::new(),
                sampling_frequency: 100.0,
                longest_time: 6.0,
            };
            let torques = &[0, 1, 2];
            let mut plan = TrainsPlan::new(&string, &request, Wanted::Sites { torques }).unwrap();
            let budget = Budget::unlimited();
            let together = plan.taps_within(&budget).unwrap();
            plan.at_a_time = plan.rounds.within(0.0);
            assert_eq!(plan.at_a_time.channels(), 1);
            let apart = plan.taps_within(&budget).unwrap();
            assert_eq!(apart.ending, together.ending);
            assert_eq!(together.taps.len(), 12);
            let taps = |built: &Built| built.taps[0].len();
            assert!(taps(&apart) <= taps(&together) && taps(&apart) > 100);
            for (one, other) in apart.taps.iter().zip(&together.taps) {
                let sum: f64 = other.iter().map(|tap| tap.abs()).sum();
                let missing = other.len() - one.len();
                let ends = std::iter::repeat_n(&0.0, missing);
                let off =
                    (one.iter().chain(ends).zip(other)).map(|(one, other)| (one - other).abs());
                assert!(off.sum::<f64>() <= off_by_most * sum);
            }
        }
    }
}
