//! Building the linear system of a method, for one string or after another's.

use anyhow::{Context, Result, bail};
use linear::estimates::largest_undershoot;
use linear::{
    BuildError, ChannelRequest, Drillstring, Earlier, ImpulseTrains, Method, Request, Responses,
    parallel, responses, responses_after, responses_with,
};
use sim::excitation::reach_of_impulse;
use sim::{Sampling, Simulator};

use super::MethodSystem;
use crate::engine::finer::finer_frequency;
use crate::engine::rubbing;
use crate::engine::stepped::{self, stepped_by};
use crate::engine::stopwatch::Stopwatch;
use crate::plan::{ImpulseSettings, LARGEST_IMPULSE, Setting, Sweep};

impl MethodSystem {
    /// Builds the system of every method of a sweep for one string.
    ///
    /// # Errors
    /// Where a method cannot treat the string, or an impulse is given in
    /// multiples of an I₀ that does not exist.
    pub fn build_all(sweep: &Sweep, setting: &Setting, longest_time: f64) -> Result<Vec<Self>> {
        // The first method's error, whichever was found first.
        Self::build_each(sweep, setting, longest_time, &[])
            .into_iter()
            .collect()
    }

    /// As [`MethodSystem::build_all`], with an answer for each method: what one cannot
    /// treat, another may. `earlier` are those of another string, where there are any, by
    /// method: what the strings have in common is not built again.
    pub fn build_each(
        sweep: &Sweep,
        setting: &Setting,
        longest_time: f64,
        earlier: &[Self],
    ) -> Vec<Result<Self>> {
        parallel::map(sweep.methods.len(), 1, |place| {
            let method = sweep.methods[place];
            Self::build_after(sweep, setting, method, longest_time, earlier.get(place))
        })
    }

    /// Builds the system of one method for the cases of a sweep.
    ///
    /// # Errors
    /// As [`MethodSystem::build_all`].
    pub fn build_for(
        sweep: &Sweep,
        setting: &Setting,
        method: Method,
        longest_time: f64,
    ) -> Result<Self> {
        Self::build_after(sweep, setting, method, longest_time, None)
    }

    /// The same after that of another string: what both have in common is not built again.
    ///
    /// # Errors
    /// As [`MethodSystem::build_all`].
    pub fn build_after(
        sweep: &Sweep,
        setting: &Setting,
        method: Method,
        longest_time: f64,
        earlier: Option<&Self>,
    ) -> Result<Self> {
        let cuts = sweep.bit.is_some();
        // Elements that are stepped have no responses to take over.
        let has_responses = |earlier: &&Self| stepped_by(&earlier.setting, &method).is_none();
        let earlier = earlier.filter(has_responses);
        let build = |string: &Drillstring, method: &Method, asked: &Request| match earlier {
            None => responses(string, method, asked),
            Some(earlier) => {
                let (setting, longest_time) = (&earlier.setting, earlier.responses.longest_time);
                let earlier = Earlier {
                    string: &setting.string,
                    request: &request(setting, cuts, longest_time),
                    responses: &earlier.responses,
                };
                responses_after(string, method, asked, earlier)
            }
        };
        let mut system = Self::build_by(setting, method, cuts, longest_time, build)
            .with_context(|| format!("the responses by {} cannot be built", method.name()))?;
        if sweep.finds_surface_torque() {
            system.follow_surface().with_context(|| {
                let method = method.name();
                format!("the torque at the surface by {method} cannot be built")
            })?;
        }
        // No impulse is so large: its site cannot reach the wall.
        let is_none = |(_, i0): &(usize, f64)| i0.is_nan() || *i0 > LARGEST_IMPULSE;
        if let Some((index, _)) = system.relative_impulses().find(is_none) {
            let message = "there is no I₀, for no impulse brings this site to the wall; \
                           give `amount_ns`";
            let key = format!("impulses[{index}].ratio");
            bail!(sweep.source.error(&key, message));
        }
        Ok(system)
    }

    /// Builds the system of one method; `cuts` says whether a torque acts on the
    /// bit.
    ///
    /// # Errors
    /// Where the method cannot treat the string.
    pub fn build(setting: &Setting, method: Method, cuts: bool, longest_time: f64) -> Result<Self> {
        Self::build_by(setting, method, cuts, longest_time, responses)
    }

    /// The trains of impulses that systems by [`Method::Held`] are made of at any sampling
    /// frequency; `None` where nothing turns.
    ///
    /// # Errors
    /// As [`MethodSystem::build`].
    pub fn trains(
        setting: &Setting,
        cuts: bool,
        longest_time: f64,
    ) -> Result<Option<ImpulseTrains>> {
        let request = request(setting, cuts, longest_time);
        Ok(ImpulseTrains::new(&setting.string, &request)?)
    }

    /// As [`MethodSystem::build`], with such trains where they are there.
    ///
    /// # Errors
    /// As [`MethodSystem::build`], and where the trains are not of this setting.
    pub fn build_with(
        setting: &Setting,
        method: Method,
        cuts: bool,
        longest_time: f64,
        trains: Option<&ImpulseTrains>,
    ) -> Result<Self> {
        let build = |string: &Drillstring, method: &Method, request: &Request| match trains {
            None => responses(string, method, request),
            Some(trains) => responses_with(string, method, request, trains),
        };
        Self::build_by(setting, method, cuts, longest_time, build)
    }

    /// Builds the system of one method from responses that are built in some way.
    fn build_by(
        setting: &Setting,
        method: Method,
        cuts: bool,
        longest_time: f64,
        responses: impl FnOnce(&Drillstring, &Method, &Request) -> Result<Responses, BuildError>,
    ) -> Result<Self> {
        let start = Stopwatch::start();
        if let Some((lateral, parameters)) = stepped_by(setting, &method) {
            let (responses, simulator) =
                stepped::build(setting, lateral, &parameters, longest_time)?;
            return Self::with(setting, responses, simulator, start);
        }
        let (string, request) = (&setting.string, request(setting, cuts, longest_time));
        let responses = responses(string, &method, &request)?;
        let Some(friction) = &setting.friction else {
            return Self::of(setting, responses, start);
        };
        let (simulator, surface) = rubbing::build(setting, friction, longest_time, &responses)?;
        Ok(Self {
            surface_torque: surface,
            ..Self::with(setting, responses, simulator, start)?
        })
    }

    /// The system of responses, whoever made them, that were begun at a moment.
    ///
    /// # Errors
    /// Where they are not those of a string.
    pub fn of(setting: &Setting, responses: Responses, begun: Stopwatch) -> Result<Self> {
        let simulator = Simulator::started(&responses, &setting.profile)?;
        Self::with(setting, responses, simulator, begun)
    }

    fn with(
        setting: &Setting,
        responses: Responses,
        simulator: Simulator,
        begun: Stopwatch,
    ) -> Result<Self> {
        let build_seconds = begun.seconds();
        let reaches = reaches(setting, &responses);
        Ok(Self {
            method: responses.method,
            torsion_margin: responses.torsion_margin()?,
            bending_margin: responses.bending_margin()?,
            least_impulses: least_impulses(setting, &reaches),
            reaches,
            front: None,
            build_seconds,
            setting: setting.clone(),
            undershoot: responses.at_bit().map(largest_undershoot),
            simulator,
            surface_torque: None,
            finer: None,
            responses,
        })
    }

    /// The same with one that is sampled more often ([`finer_frequency`]), where this is the method at
    /// such a place of a sweep's list as certifies labels.
    ///
    /// # Errors
    /// As [`MethodSystem::build`].
    pub fn with_finer(self, sweep: &Sweep, place: usize, longest_time: f64) -> Result<Self> {
        if !(sweep.certifying).is_some_and(|places| places.contains(&place)) {
            return Ok(self);
        }
        let frequency = finer_frequency(&self.setting, &self.method);
        let setting = self.setting.sampled_at(frequency);
        let finer = Self::build(&setting, self.method, sweep.bit.is_some(), longest_time);
        let finer = finer.with_context(|| {
            let (method, frequency) = (self.method.name(), setting.sampling_frequency);
            format!("the responses by {method} at {frequency} Hz cannot be built")
        })?;
        Ok(Self {
            finer: Some(Box::new(finer)),
            ..self
        })
    }
}

/// What a system is built from; `cuts` says whether a torque acts on the bit.
pub(in crate::engine) fn request(setting: &Setting, cuts: bool, longest_time: f64) -> Request {
    let sites = setting.sites.len();
    let torques = match &setting.lateral {
        // Where the string rubs along its well, torques act on its nodes.
        _ if setting.friction.is_some() => Vec::new(),
        // Friction turns the string wherever it touches the wall.
        Some(_) => (0..sites).collect(),
        None if cuts => vec![sites - 1],
        None => Vec::new(),
    };
    let in_bending = (setting.lateral.as_ref()).map(|lateral| ChannelRequest::Bending {
        bending: lateral.bending,
        support: lateral.support,
    });
    let in_torsion = ChannelRequest::Torsion { torques };
    Request {
        sites: setting.sites.clone(),
        channels: std::iter::once(in_torsion).chain(in_bending).collect(),
        sampling_frequency: setting.sampling_frequency,
        longest_time,
    }
}

/// The systems of a sweep, by method, with those by shorter steps that certify labels.
///
/// # Errors
/// As [`MethodSystem::with_finer`].
pub fn add_finer(
    systems: Vec<MethodSystem>,
    sweep: &Sweep,
    longest_time: f64,
) -> Result<Vec<MethodSystem>> {
    let placed = systems.into_iter().enumerate().collect();
    parallel::each(placed, |(place, system): (usize, MethodSystem)| {
        system.with_finer(sweep, place, longest_time)
    })
    .into_iter()
    .collect()
}

/// How far every impulse moves its own site by this method, m per N s.
fn reaches(setting: &Setting, responses: &Responses) -> Vec<f64> {
    let Some((lateral, bending)) = setting.lateral.as_ref().zip(responses.bending()) else {
        return Vec::new();
    };
    let sampling = Sampling::new(setting.sampling_frequency, responses.method.moment());
    let of = |impulse: &ImpulseSettings| {
        let taps = bending.taps_between(impulse.site, impulse.site);
        reach_of_impulse(taps.unwrap_or_default(), sampling, impulse.duration)
    };
    lateral.impulses.iter().map(of).collect()
}

/// I₀ of every impulse: what brings its site to the wall as the file says it.
fn least_impulses(setting: &Setting, reaches: &[f64]) -> Vec<f64> {
    let lateral = setting.lateral.iter();
    let of_each = lateral.flat_map(|lateral| {
        let impulses = lateral.impulses.iter().zip(reaches);
        impulses.map(|(impulse, reach)| lateral.walls[impulse.site].clearance / reach)
    });
    of_each.collect()
}
