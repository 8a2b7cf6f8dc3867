//! Building the linear system of a method, for one string or after another's.

use std::borrow::Cow;

use anyhow::{Context, Result, bail};
use linear::estimates::largest_undershoot;
use linear::{
    BendingPoles, Budget, BuildError, Earlier, ImpulseTrains, Method, Request, ResponsePlan,
    Responses, parallel,
};
use sim::excitation::reach_of_impulse;
use sim::{Sampling, Simulator, SimulatorPlan, System};

use super::MethodSystem;
use crate::engine::dry_run;
use crate::engine::finer::finer_frequency;
use crate::engine::limited;
use crate::engine::poles;
use crate::engine::rubbing;
use crate::engine::stepped::{self, stepped_by};
use crate::engine::stopwatch::Stopwatch;
use crate::engine::system_plan::{Stepping, SystemPlan};
use crate::plan::{ImpulseSettings, LARGEST_IMPULSE, Setting, Sweep};

/// What the linear system of a method is built from. There is no other way to build one but
/// [`MethodSystem::of`], of responses that are there already.
#[derive(Debug, Clone)]
pub struct Recipe<'a> {
    /// The sweep whose cases it is for: what its impulses and measures need is checked and built,
    /// too.
    pub sweep: Option<&'a Sweep>,
    /// The string, its sites and how it is sampled by the method.
    pub setting: Cow<'a, Setting>,
    /// By which method.
    pub method: Method,
    /// Whether a torque acts on the bit.
    pub cuts: bool,
    /// The longest time of its cases, s.
    pub longest_time: f64,
    /// What is there of it already.
    pub basis: Basis<'a>,
    /// Whether it is to be known how the string is bent, stressed and shaken along its length, where the
    /// setting asks for that.
    pub measures_along: bool,
}

/// What is there of a system before it is built.
#[derive(Debug, Clone, Copy, Default)]
pub enum Basis<'a> {
    /// Nothing.
    #[default]
    Nothing,
    /// The system of another string: what both have in common is not built again.
    Earlier(&'a MethodSystem),
    /// The trains of impulses of its string at any sampling frequency, for [`Method::Held`].
    Trains(&'a ImpulseTrains),
}

impl<'a> Recipe<'a> {
    /// For the cases of a sweep.
    pub fn of(sweep: &'a Sweep, setting: &'a Setting, method: Method, longest_time: f64) -> Self {
        Self {
            sweep: Some(sweep),
            measures_along: true,
            ..Self::alone(setting, method, sweep.bit.is_some(), longest_time)
        }
    }

    /// For any cases; `cuts` says whether a torque acts on the bit.
    pub fn alone(setting: &'a Setting, method: Method, cuts: bool, longest_time: f64) -> Self {
        Self {
            sweep: None,
            setting: setting.by(&method),
            method,
            cuts,
            longest_time,
            basis: Basis::Nothing,
            measures_along: false,
        }
    }

    /// The same without what is measured along the string, which changes no label.
    pub fn for_labels(self) -> Self {
        Self {
            measures_along: false,
            ..self
        }
    }

    /// The same with the system of another string, where there is one.
    pub fn after(self, earlier: Option<&'a MethodSystem>) -> Self {
        Self {
            basis: earlier.map_or(Basis::Nothing, Basis::Earlier),
            ..self
        }
    }

    /// The same with trains of impulses, where there are any.
    pub fn with_trains(self, trains: Option<&'a ImpulseTrains>) -> Self {
        Self {
            basis: trains.map_or(Basis::Nothing, Basis::Trains),
            ..self
        }
    }

    /// Builds the system of every method of a sweep, or says why one has none: what it cannot
    /// treat, another may. `earlier` are those of another string by method, or none.
    pub fn build_each(
        sweep: &Sweep,
        setting: &Setting,
        longest_time: f64,
        earlier: &[MethodSystem],
    ) -> Vec<Result<MethodSystem>> {
        parallel::map(sweep.methods.len(), 1, |place| {
            let method = sweep.methods[place];
            let recipe = Recipe::of(sweep, setting, method, longest_time);
            recipe.after(earlier.get(place)).build()
        })
    }

    /// The trains of impulses that systems by [`Method::Held`] are made of at any sampling
    /// frequency; `None` where nothing turns.
    ///
    /// # Errors
    /// As [`Recipe::build`].
    pub fn trains(&self) -> Result<Option<ImpulseTrains>> {
        let request = self.plan().request();
        Ok(ImpulseTrains::new(&self.setting.string, &request)?)
    }

    /// Builds the system.
    ///
    /// # Errors
    /// Where the method cannot treat the string, trains are not of this setting, or an impulse of
    /// the sweep is given in multiples of an I₀ that does not exist.
    pub fn build(&self) -> Result<MethodSystem> {
        let Some(sweep) = self.sweep else {
            return self.build_alone();
        };
        let method = self.method.name();
        let mut system = (self.build_alone())
            .with_context(|| format!("the responses by {method} cannot be built"))?;
        if sweep.finds_surface_torque() {
            system.follow_surface().with_context(|| {
                format!("the torque at the surface by {method} cannot be built")
            })?;
        }
        if self.measures_along {
            system.follow_places().with_context(|| {
                format!("what is measured along the string by {method} cannot be built")
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

    fn plan(&self) -> SystemPlan<'_> {
        SystemPlan {
            setting: &self.setting,
            method: &self.method,
            cuts: self.cuts,
            longest_time: self.longest_time,
        }
    }

    /// The system without what only a sweep asks of it, within the memory that its dry run asks for.
    fn build_alone(&self) -> Result<MethodSystem> {
        let start = Stopwatch::start();
        let plan = self.plan();
        let (setting, longest_time) = (self.setting.as_ref(), self.longest_time);
        if let Some((lateral, parameters)) = stepped_by(setting, &self.method) {
            let budget = within(|budget| dry_run::ask(&plan, budget))?;
            let (responses, simulator) =
                stepped::build(setting, lateral, &parameters, longest_time, &budget)?;
            return MethodSystem::with(setting, responses, simulator, (start, &budget));
        }
        let request = plan.request_of_taps();
        let before = self.request_before();
        let planned = self.response_plan(&request, before.as_ref())?;
        let asked = (&request, &planned);
        let budget = within(|budget| dry_run::ask_for_responses(&plan, asked, budget))?;
        let responses = planned.build(&budget)?;
        let Some(friction) = &setting.friction else {
            return MethodSystem::of_responses(setting, responses, (start, &budget));
        };
        let (simulator, surface) =
            rubbing::build(setting, friction, longest_time, &responses, &budget)?;
        Ok(MethodSystem {
            surface_torque: surface,
            ..MethodSystem::with(setting, responses, simulator, (start, &budget))?
        })
    }

    /// The system of another string, and what its responses were built from.
    fn request_before(&self) -> Option<(&'a MethodSystem, Request)> {
        let Basis::Earlier(earlier) = self.basis else {
            return None;
        };
        // Elements that are stepped have no responses to take over.
        let has_responses = stepped_by(&earlier.setting, &self.method).is_none();
        let before = SystemPlan {
            setting: &earlier.setting,
            longest_time: earlier.responses.longest_time,
            ..self.plan()
        };
        has_responses.then(|| (earlier, before.request_of_taps()))
    }

    fn response_plan<'b>(
        &'b self,
        request: &'b Request,
        before: Option<&'b (&MethodSystem, Request)>,
    ) -> Result<ResponsePlan<'b>, BuildError> {
        let (string, method) = (&self.setting.string, &self.method);
        match (self.basis, before) {
            (Basis::Trains(trains), _) => {
                ResponsePlan::with_trains(string, method, request, trains)
            }
            (_, Some((earlier, before))) => {
                let earlier = Earlier {
                    string: &earlier.setting.string,
                    request: before,
                    responses: &earlier.responses,
                };
                ResponsePlan::after(string, method, request, earlier)
            }
            _ => ResponsePlan::new(string, method, request),
        }
    }
}

/// A budget of what is asked for in a dry run.
///
/// # Errors
/// Those of the dry run.
fn within(ask: impl FnOnce(&Budget) -> Result<Stepping, BuildError>) -> Result<Budget, BuildError> {
    let asked = Budget::unlimited();
    ask(&asked)?;
    Ok(Budget::new(asked.need().peak.ceil()))
}

impl MethodSystem {
    /// The system of responses that are there already; building them began at a moment.
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
        let plan = SimulatorPlan::of_responses(&responses);
        let simulator = match (&setting.cutting, setting.drive_limit) {
            (None, None) => {
                plan.ask(budget)?;
                Simulator::started(&responses, &setting.profile)?
            }
            (cutting, limit) => {
                let mut system = System::started(&responses, &setting.profile)?;
                if let Some(cutting) = cutting {
                    system = system.moving_along(&responses, &cutting.profile)?;
                }
                match limit {
                    None => plan.ask(budget)?,
                    Some(limit) => {
                        let drive = (setting, limit);
                        system = limited::below(system, drive, &responses, (plan, budget))?;
                    }
                }
                Simulator::of(system)
            }
        };
        Self::with(setting, responses, simulator, (begun, budget))
    }

    fn with(
        setting: &Setting,
        mut responses: Responses,
        simulator: Simulator,
        (begun, budget): (Stopwatch, &Budget),
    ) -> Result<Self> {
        let of_taps = begun.seconds();
        let [torsion_margin, by_taps] = responses.margins(budget)?;
        let axial_margin = responses.axial_margin()?;
        let begun = Stopwatch::start();
        let (simulator, poles) = poles::build(setting, simulator, &mut responses, budget)?;
        let build_seconds = of_taps + begun.seconds();
        let simulator = match setting.motor {
            None => simulator,
            Some(motor) => simulator.above_motor(motor)?,
        };
        let reaches = reaches(setting, &responses);
        Ok(Self {
            method: responses.method,
            torsion_margin,
            bending_margin: poles.as_ref().map(BendingPoles::margin).or(by_taps),
            axial_margin,
            least_impulses: least_impulses(setting, &reaches),
            reaches,
            front: None,
            build_seconds,
            setting: setting.clone(),
            undershoot: responses.at_bit().map(largest_undershoot),
            simulator,
            poles,
            surface_torque: None,
            moments: None,
            displacements: None,
            rates: None,
            finer: None,
            longer: Default::default(),
            responses,
        })
    }

    /// The same with one that is sampled more often ([`finer_frequency`]), where this is the method at
    /// such a place of a sweep's list as certifies labels.
    ///
    /// # Errors
    /// As [`Recipe::build`].
    pub fn with_finer(self, sweep: &Sweep, place: usize, longest_time: f64) -> Result<Self> {
        if !(sweep.certifying).is_some_and(|places| places.contains(&place)) {
            return Ok(self);
        }
        let frequency = finer_frequency(&self.setting, &self.method);
        let setting = self.setting.sampled_at(frequency);
        let recipe = Recipe::alone(&setting, self.method, sweep.bit.is_some(), longest_time);
        let finer = recipe.build().with_context(|| {
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
