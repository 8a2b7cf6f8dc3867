//! The linear system of each method, built once for all cases.

use std::panic::{AssertUnwindSafe, catch_unwind};

use anyhow::{Context, Result, bail};
use linear::deviation::exact_undershoot;
use linear::estimates::{largest_undershoot, stick_slip_speed_limit};
use linear::{
    BuildError, Cascade, ChannelRequest, ChannelResponses, Drillstring, Earlier, ImpulseTrains,
    Method, Request, Responses, parallel, responses, responses_after, responses_with,
};
use sim::excitation::reach_of_impulse;
use sim::{
    CascadeScene, CascadeSimulator, Outcome, Sampling, Scene, SimulationError, Simulator, Stopping,
    SurfaceTorque, Trajectory,
};

use super::case::Case;
use super::case_error::CaseError;
use super::front::{Front, Overshoot};
use super::instability::{Instability, is_unstable};
use super::record::{Failure, Record};
use super::run_options::RunOptions;
use super::stepped::{self, stepped_by};
use super::stopwatch::Stopwatch;
use super::verdict::{FINER, Verdict};
use crate::plan::{ImpulseSettings, LARGEST_IMPULSE, Setting, Sweep};

/// One method's responses, ready to simulate with, and what is known of them.
#[derive(Debug)]
pub struct MethodSystem {
    /// The method.
    pub method: Method,
    /// Its impulse responses.
    pub responses: Responses,
    /// I₀ of each impulse with the wall as the file says it, N s.
    pub least_impulses: Vec<f64>,
    /// How far each impulse moves its site, m per N s.
    reaches: Vec<f64>,
    /// Positive-real margin in torsion; `None` where no torque acts.
    pub torsion_margin: Option<f64>,
    /// Positive-real margin in bending; `None` where that is not modelled.
    pub bending_margin: Option<f64>,
    /// Its fronts, where they have been compared with the exact ones.
    pub front: Option<Front>,
    /// Time to build, s.
    pub build_seconds: f64,
    /// What it was built from.
    pub setting: Setting,
    /// How far the bit swings back after a step of torque (Eq. 75), rad/s per N m, where one acts
    /// there.
    undershoot: Option<f64>,
    simulator: Simulator,
    /// What turns the surface, where that is to be known of a string that is not in pieces.
    surface_torque: Option<SurfaceTorque>,
    /// The string in pieces, where friction acts all along it.
    cascade: Option<CascadeSimulator>,
    /// The same by steps that are shorter, where labels are certified.
    finer: Option<Box<MethodSystem>>,
}

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
        let system = Self::of(setting, responses(string, &method, &request)?, start)?;
        let Some(friction) = &setting.friction else {
            return Ok(system);
        };
        let frequency = setting.sampling_frequency;
        let cascade = Cascade::new(string, &method, &friction.nodes, frequency, longest_time)?;
        let simulator = CascadeSimulator::new(&cascade, &setting.profile, setting.rotor_inertia)?;
        Ok(Self {
            build_seconds: start.seconds(),
            cascade: Some(simulator.following_torque(friction.follows_torque)),
            ..system
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
            cascade: None,
            finer: None,
            responses,
        })
    }

    /// The same with one that is sampled [`FINER`] times as often, where this is the method at
    /// such a place of a sweep's list as certifies labels.
    ///
    /// # Errors
    /// As [`MethodSystem::build`].
    pub fn with_finer(self, sweep: &Sweep, place: usize, longest_time: f64) -> Result<Self> {
        if !(sweep.certifying).is_some_and(|places| places.contains(&place)) {
            return Ok(self);
        }
        let setting = self
            .setting
            .sampled_at(FINER * self.setting.sampling_frequency);
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

    /// The impulses that are given in multiples of I₀, each with its I₀, N s.
    fn relative_impulses(&self) -> impl Iterator<Item = (usize, f64)> {
        let lateral = self.setting.lateral.iter();
        let impulses = lateral.flat_map(|lateral| &lateral.impulses).enumerate();
        (impulses.zip(&self.least_impulses))
            .filter(|((_, impulse), _)| impulse.is_relative())
            .map(|((index, _), least)| (index, *least))
    }

    /// Why labels by this method mean little, where its margin says so.
    pub fn instability(&self) -> Option<Instability> {
        let margins = [
            (self.torsion_margin, "torsion"),
            (self.bending_margin, "bending"),
        ];
        let (margin, motion) = (margins.into_iter())
            .find_map(|(margin, motion)| Some((margin.filter(|m| is_unstable(*m))?, motion)))?;
        Some(Instability {
            method: self.method.name(),
            motion,
            margin,
        })
    }

    /// Why it certifies no label: the same of the shorter steps by which it would, and their
    /// sampling frequency, Hz.
    pub fn instability_of_finer(&self) -> Option<(Instability, f64)> {
        let finer = self.finer.as_ref()?;
        Some((finer.instability()?, finer.setting.sampling_frequency))
    }

    /// What is to be said of its fronts, where they were compared and overshoot.
    pub fn overshoot(&self) -> Option<Overshoot> {
        let front = self.front.filter(Front::is_off)?;
        let method = self.method.name();
        Some(Overshoot { method, front })
    }

    /// The torque that holds the bit fast, where only torsion is modelled and a
    /// torque acts there (see [`Simulator::stuck_torque`]).
    pub fn stuck_torque(&self) -> Option<&[f64]> {
        self.simulator.stuck_torque()
    }

    /// Taps of each response in torsion.
    pub fn torsion_taps(&self) -> usize {
        self.responses.torsion().map_or(0, ChannelResponses::taps)
    }

    /// Taps of the bit's speed from a torque on it, where one acts there.
    pub fn driving_point(&self) -> Option<&[f64]> {
        self.responses.at_bit()
    }

    /// Simulates one scene, its relative impulses in N s, writing its time history into
    /// `record` where asked; nothing is left out of that.
    ///
    /// # Errors
    /// Where the case gives no answer.
    pub fn simulate(
        &self,
        case: &Case,
        stopping: Stopping,
        record: Option<&mut Trajectory>,
    ) -> Result<Outcome, SimulationError> {
        if let Some((cascade, torques)) = self.cascade.as_ref().zip(case.along_string.as_ref()) {
            let scene = CascadeScene {
                surface_speed: case.scene.surface_speed,
                torques: torques.clone(),
                timing: case.scene.timing,
            };
            return self.rub(cascade, &scene, record);
        }
        let mut scene = case.scene.clone();
        if let Some(lateral) = &mut scene.lateral {
            // The clearance is the case's own.
            for (index, _) in self.relative_impulses() {
                let impulse = &mut lateral.impulses[index];
                let clearance = lateral.walls[impulse.site].clearance;
                impulse.amount *= clearance / self.reaches[index];
            }
        }
        self.simulator.simulate(&scene, stopping, record)
    }

    /// A string that rubs along its well; of its nodes only the sites are recorded.
    fn rub(
        &self,
        cascade: &CascadeSimulator,
        scene: &CascadeScene,
        mut record: Option<&mut Trajectory>,
    ) -> Result<Outcome, SimulationError> {
        let outcome = cascade.simulate(scene, record.as_deref_mut())?;
        if let (Some(record), Some(friction)) = (record, &self.setting.friction) {
            let mut speeds = std::mem::take(&mut record.speeds);
            let sites = friction.looked_at.iter();
            record.speeds = sites
                .map(|&node| std::mem::take(&mut speeds[node]))
                .collect();
        }
        Ok(outcome)
    }

    /// Speeds of all sites, rad/s, in a motion of which the torque on the bit is known;
    /// where lateral motion is modelled, every site has been simulated, and `None`.
    pub fn driven_speeds(&self, case: &Case, motion: &Trajectory) -> Option<Vec<Vec<f64>>> {
        if self.responses.bending().is_some() || self.cascade.is_some() {
            return None;
        }
        let steps = motion.speeds.first().map_or(0, Vec::len);
        let (system, speed) = (self.simulator.system(), case.scene.surface_speed);
        Some(system.driven_speeds(speed, &motion.bit_torque, steps))
    }

    /// Makes the torque known that turns the surface, so that motions have it.
    ///
    /// # Errors
    /// Where the method does not treat the string.
    pub fn follow_surface(&mut self) -> Result<()> {
        let setting = &self.setting;
        let request = request(setting, false, self.responses.longest_time);
        let taps = linear::surface_torque(&setting.string, &self.method, &request)?;
        let (profile, inertia) = (&setting.profile, setting.rotor_inertia);
        let torque = SurfaceTorque::new(&self.responses, &taps, profile, inertia)?;
        self.surface_torque = Some(torque);
        Ok(())
    }

    /// Adds the torque that turns the surface, N m, to a motion where it is to be known; of a
    /// string in pieces the motion has it.
    pub fn add_surface_torque(&self, case: &Case, motion: &mut Trajectory) {
        if let Some(torque) = &self.surface_torque {
            motion.surface_torque = torque.of(case.scene.surface_speed, motion);
        }
    }

    /// How far above the analytic limit of stick-slip (Eq. 74) the surface turns, rad/s: that
    /// knows of no friction but the bit's.
    fn above_limit(&self, scene: &Scene) -> Option<f64> {
        let bit = scene.bit.filter(|_| self.setting.friction.is_none())?;
        let (torque_static, torque_dynamic) = (bit.torque_static, bit.torque_dynamic);
        let limit = stick_slip_speed_limit(self.undershoot?, torque_static, torque_dynamic);
        Some(scene.surface_speed - limit)
    }

    /// What it says of a case, where it has an answer that means something.
    fn verdict(&self, case: &Case, stopping: Stopping) -> Option<Verdict> {
        if self.instability().is_some() {
            return None;
        }
        let simulate = AssertUnwindSafe(|| self.simulate(case, stopping, None));
        let outcome = catch_unwind(simulate).ok()?.ok()?;
        Some(Verdict::of(&outcome, self.above_limit(&case.scene)))
    }

    /// The same by its shorter steps, where it has any.
    pub(super) fn finer_verdict(&self, case: &Case, stopping: Stopping) -> Option<Verdict> {
        self.finer.as_ref()?.verdict(case, stopping)
    }

    /// What it comes to of a case, as a run has it, at the sites that it was built for; `method`
    /// is its place in the sweep's list. The motion is followed to its end where there is one to
    /// be written, and held against what the sweep compares with.
    pub(super) fn follow(
        &self,
        case: &Case,
        method: usize,
        options: RunOptions,
        sweep: &Sweep,
        mut motion: Option<&mut Trajectory>,
    ) -> Record {
        let failed = |reason: CaseError| {
            let values = case.values.clone();
            Record::failed(case.index, method, values, Failure::new(reason))
        };
        if let (Some(instability), false) = (self.instability(), options.allow_unstable) {
            return failed(CaseError::Unstable(instability));
        }
        let stopping = options.stopping(case.index);
        let simulated = catch_unwind(AssertUnwindSafe(|| {
            self.simulate(case, stopping, motion.as_deref_mut())
        }));
        let friction = self.setting.friction.as_ref();
        let sites = friction.map_or(&self.setting.sites, |friction| &friction.nodes);
        let distances = sites.distances_from_bit();
        let mut record = failed(CaseError::Panicked);
        record.torque_dynamic_nm = case.torque_dynamic_nm;
        if let Ok(simulated) = simulated {
            let lateral = simulated.as_ref().ok().and_then(|outcome| outcome.lateral);
            record.site_from_bit_m = lateral.map(|lateral| distances[lateral.site]);
            record.outcome = simulated.map_err(|error| {
                let site = error.site();
                let site = site.and_then(|site| Some((site, *distances.get(site)?)));
                Failure::new(CaseError::Simulation { error, site })
            });
            if record.outcome.is_ok() {
                record.above_limit = self.above_limit(&case.scene);
            }
            if let (Ok(outcome), Some(motion)) = (&mut record.outcome, motion) {
                self.add_surface_torque(case, motion);
                let is_measured = sweep.measures_surface_torque();
                if let Some(torque) = self.surface_torque.as_ref().filter(|_| is_measured) {
                    let window = case.scene.timing.closing_window;
                    outcome.surface = Some(torque.measures(&motion.surface_torque, window));
                }
                record.misfits = (sweep.data.comparisons.iter())
                    .map(|comparison| comparison.misfit(motion))
                    .collect();
            }
        }
        record
    }
}

/// What a system is built from; `cuts` says whether a torque acts on the bit.
pub(super) fn request(setting: &Setting, cuts: bool, longest_time: f64) -> Request {
    let sites = setting.sites.len();
    let torques = match &setting.lateral {
        // Friction turns the string wherever it touches the wall.
        Some(_) => (0..sites).collect(),
        // Where the string rubs, torques act on its pieces.
        None if cuts && setting.friction.is_none() => vec![sites - 1],
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

/// Holds the fronts of systems of one string against the exact ones; where no torque cuts
/// there are none, and where a string does not undershoot nothing is said.
pub fn compare_fronts(systems: &mut [MethodSystem]) {
    let Some(string) = systems.first().map(|system| &system.setting.string) else {
        return;
    };
    if systems
        .iter()
        .all(|system| system.driving_point().is_none())
    {
        return;
    }
    // A string whose lattice does not fit in memory stays without a comparison.
    let Some(exact) = exact_undershoot(string).ok().filter(|exact| *exact > 0.0) else {
        return;
    };
    for system in systems {
        let undershoot = system.driving_point().map(largest_undershoot);
        system.front = undershoot.map(|undershoot| Front { undershoot, exact });
    }
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
