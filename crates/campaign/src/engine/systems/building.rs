//! Building the linear system of a method, for one string or after another's.

use anyhow::{Context, Result, bail};
use linear::estimates::largest_undershoot;
use linear::{
    Budget, BuildError, Drillstring, Earlier, ImpulseTrains, Method, Request, ResponsePlan,
    Responses, parallel,
};
use sim::excitation::reach_of_impulse;
use sim::{Sampling, Simulator, SimulatorPlan};

use super::MethodSystem;
use crate::engine::finer::finer_frequency;
use crate::engine::rubbing;
use crate::engine::stepped::{self, stepped_by};
use crate::engine::stopwatch::Stopwatch;
use crate::engine::system_plan::SystemPlan;
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
        let build = |string: &Drillstring, method: &Method, asked: &Request, budget: &Budget| {
            let Some(earlier) = earlier else {
                return ResponsePlan::new(string, method, asked)?.build(budget);
            };
            let before = SystemPlan {
                setting: &earlier.setting,
                method,
                cuts,
                longest_time: earlier.responses.longest_time,
            };
            let earlier = Earlier {
                string: &earlier.setting.string,
                request: &before.request(),
                responses: &earlier.responses,
            };
            ResponsePlan::after(string, method, asked, earlier)?.build(budget)
        };
        let plan = SystemPlan {
            setting,
            method: &method,
            cuts,
            longest_time,
        };
        let mut system = Self::build_by(&plan, build)
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
        Self::build_with(setting, method, cuts, longest_time, None)
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
        let plan = SystemPlan {
            setting,
            method: &Method::Held,
            cuts,
            longest_time,
        };
        Ok(ImpulseTrains::new(&setting.string, &plan.request())?)
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
        let plan = SystemPlan {
            setting,
            method: &method,
            cuts,
            longest_time,
        };
        Self::build_by(&plan, |string, method, request, budget| match trains {
            None => ResponsePlan::new(string, method, request)?.build(budget),
            Some(trains) => {
                ResponsePlan::with_trains(string, method, request, trains)?.build(budget)
            }
        })
    }

    /// Builds the system of one method from responses that are built in some way.
    fn build_by(
        plan: &SystemPlan,
        responses: impl FnOnce(
            &Drillstring,
            &Method,
            &Request,
            &Budget,
        ) -> Result<Responses, BuildError>,
    ) -> Result<Self> {
        let start = Stopwatch::start();
        let (setting, method, longest_time) = (plan.setting, plan.method, plan.longest_time);
        // The dry run was held against the limit. What outlasts its plan is built all the same.
        let budget = Budget::unlimited();
        if let Some((lateral, parameters)) = stepped_by(setting, method) {
            let (responses, simulator) =
                stepped::build(setting, lateral, &parameters, longest_time, &budget)?;
            return Self::with(setting, responses, simulator, (start, &budget));
        }
        let responses = responses(&setting.string, method, &plan.request(), &budget)?;
        let Some(friction) = &setting.friction else {
            return Self::of_responses(setting, responses, (start, &budget));
        };
        let (simulator, surface) =
            rubbing::build(setting, friction, longest_time, &responses, &budget)?;
        Ok(Self {
            surface_torque: surface,
            ..Self::with(setting, responses, simulator, (start, &budget))?
        })
    }

    /// The system of responses, whoever made them, that were begun at a moment.
    ///
    /// # Errors
    /// Where they are not those of a string.
    pub fn of(setting: &Setting, responses: Responses, begun: Stopwatch) -> Result<Self> {
        Self::of_responses(setting, responses, (begun, &Budget::unlimited()))
    }

    fn of_responses(
        setting: &Setting,
        responses: Responses,
        (begun, budget): (Stopwatch, &Budget),
    ) -> Result<Self> {
        SimulatorPlan::of_responses(&responses).ask(budget)?;
        let simulator = Simulator::started(&responses, &setting.profile)?;
        Self::with(setting, responses, simulator, (begun, budget))
    }

    fn with(
        setting: &Setting,
        responses: Responses,
        simulator: Simulator,
        (begun, budget): (Stopwatch, &Budget),
    ) -> Result<Self> {
        let build_seconds = begun.seconds();
        let reaches = reaches(setting, &responses);
        let [torsion_margin, bending_margin] = responses.margins(budget)?;
        Ok(Self {
            method: responses.method,
            torsion_margin,
            bending_margin,
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
    let sampling = Sampling::new(
        setting.sampling_frequency,
        responses.method.collocation_offset(),
    );
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
