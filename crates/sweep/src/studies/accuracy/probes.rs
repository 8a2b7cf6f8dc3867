//! A few of the sweep's own cases, simulated to compare methods, and the limits near
//! them.

use std::sync::OnceLock;

use anyhow::{Result, anyhow, bail};
use linear::cost::Memory;
use linear::deviation::{bending_error, exact_undershoot, torsion_error};
use linear::estimates::{largest_undershoot, torsional_travel_time};
use linear::{ImpulseTrains, Method};
use rayon::prelude::*;
use sim::Stopping;

use super::answer::{Answer, Difference, is_inside, measures, regimes};
use crate::engine::{MethodSystem, StringMemory};
use crate::memory::{Limit, Size};
use crate::plan::{Conditions, Setting, Sweep};
use crate::studies::limit::{bisected, geometric};
use crate::studies::trial;

/// Cases compared, evenly spread over the design.
const MOST_PROBES: usize = 8;

/// A limit is looked for up to this many doublings from a case, or halvings.
const DOUBLINGS: i32 = 3;

/// A limit is found to this part of the accuracy.
const LIMIT_PART: f64 = 1.0 / 16.0;

/// A limit is looked for within this factor of a known one.
const NEAR: f64 = 1.2;

/// Islands are looked for within this factor of a limit.
const FURTHEST: f64 = 1.3;

/// Duration of the impulse in bending where the scene has none, s.
const DURATION: f64 = 0.02;

/// One method's system of every string among the probes.
pub type Systems = Vec<MethodSystem>;

/// A case, and its string among those of the probes.
struct Probe {
    case: usize,
    string: usize,
}

/// The cases compared.
pub struct Probes<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    probes: Vec<Probe>,
    /// A case of each string.
    strings: Vec<usize>,
    longest: f64,
    asked: f64,
    limit: Limit,
    /// The trains of impulses of each string, as soon as they are wanted, or why there are
    /// none.
    trains: Vec<OnceLock<Result<Option<ImpulseTrains>, String>>>,
}

impl<'a> Probes<'a> {
    /// Chooses the probes of a sweep that asks for an accuracy.
    ///
    /// # Errors
    /// Where none of them can be.
    pub fn of(sweep: &'a Sweep, asked: f64, limit: &Limit) -> Result<Self> {
        let mut found = Self {
            sweep,
            probes: Vec::new(),
            strings: Vec::new(),
            longest: 0.0,
            asked,
            limit: *limit,
            trains: Vec::new(),
        };
        let cases = sweep.design.cases();
        let count = cases.min(MOST_PROBES);
        let mut reason = anyhow!("there is nothing to compare");
        for case in (0..count).map(|index| (2 * index + 1) * cases / (2 * count)) {
            // A string that cannot be has cases that fail, and nothing to compare.
            match found.longest_of(case) {
                Ok(longest) => found.add(case, longest),
                Err(why) => reason = why,
            }
        }
        if found.probes.is_empty() {
            return Err(reason);
        }
        Ok(found)
    }

    /// Numbers of the cases.
    pub fn cases(&self) -> Vec<usize> {
        self.probes.iter().map(|probe| probe.case).collect()
    }

    fn add(&mut self, case: usize, longest: f64) {
        let design = &self.sweep.design;
        let has_its_string = |other: &usize| design.string_of(*other) == design.string_of(case);
        let string = self.strings.iter().position(has_its_string);
        let string = string.unwrap_or_else(|| {
            self.strings.push(case);
            self.trains.push(OnceLock::new());
            self.strings.len() - 1
        });
        self.probes.push(Probe { case, string });
        self.longest = self.longest.max(longest);
    }

    fn longest_of(&self, case: usize) -> Result<f64> {
        let values = self.sweep.design.values(case);
        let setting = self.sweep.setting_at(&values)?;
        let mut longest = 0.0f64;
        for exponent in [-DOUBLINGS, 0, DOUBLINGS] {
            let conditions = self.conditions(case, 2f64.powi(exponent));
            let case = trial::case(self.sweep, &setting, &conditions)?;
            longest = longest.max(case.scene.timing.duration);
        }
        Ok(longest)
    }

    /// The conditions of a case with its surface speed, or its friction where there is a
    /// wall, multiplied.
    fn conditions(&self, case: usize, factor: f64) -> Conditions {
        let mut conditions = self.sweep.conditions_at(&self.sweep.design.values(case));
        if self.sweep.setting.lateral.is_some() {
            conditions.friction_factor = Some(factor);
        } else if let Some(speed) = &mut conditions.surface_speed_rpm {
            *speed *= factor;
        }
        conditions
    }

    /// The time (s) a torsional wave takes along the string of the first probe.
    ///
    /// # Errors
    /// Where that string cannot be.
    pub fn travel(&self) -> Result<f64> {
        let values = self.sweep.design.values(self.strings[0]);
        Ok(torsional_travel_time(
            &self.sweep.setting_at(&values)?.string,
        ))
    }

    /// Whether no string has a step of impedance: then fronts travel the whole of it.
    pub fn are_uniform(&self) -> bool {
        self.strings.iter().all(|&case| {
            let setting = self.sweep.setting_at(&self.sweep.design.values(case));
            setting.is_ok_and(|setting| {
                let parts = setting.string.sections().iter().flat_map(|one| &one.parts);
                let mut moments = parts.map(|part| part.polar_moment());
                let first = moments.next();
                moments.all(|moment| Some(moment) == first)
            })
        })
    }

    /// The setting of a string's case, sampled at another frequency.
    fn setting(&self, case: usize, frequency: f64) -> Result<Setting> {
        let values = self.sweep.design.values(case);
        let setting = self.sweep.setting_sampled(&values, frequency);
        setting.map_err(|error| anyhow!(error.message().to_owned()))
    }

    /// The memory that a method's systems keep, bytes, where they can be built beside
    /// others that keep `held`.
    ///
    /// # Errors
    /// Where building and stepping them would take more than the limit.
    pub fn fits(&self, method: Method, frequency: f64, held: f64) -> Result<f64> {
        let cuts = self.sweep.bit.is_some();
        // A string that cannot be is told when it is to be built.
        let settings = (self.strings.iter()).filter_map(|&case| self.setting(case, frequency).ok());
        let (mut systems, mut case) = (Memory::default(), 0.0f64);
        for setting in settings {
            let of_string = StringMemory::of(&setting, &[method], cuts, self.longest);
            // A transform that is too long is refused at once, and takes nothing; others
            // are built longer and longer until then.
            let is_transform = matches!(method, Method::Hilbert(_) | Method::DirectIdft(_));
            if of_string.too_long.is_some() && is_transform {
                continue;
            }
            systems = systems.beside(of_string.systems);
            case = case.max(of_string.case);
        }
        let stepped = Memory::lasting(rayon::current_num_threads() as f64 * case);
        let bytes = held + self.memory_of_trains() + systems.then(stepped).peak;
        if bytes > self.limit.bytes {
            let (size, limit) = (Size(bytes), self.limit);
            bail!("is too large for the memory: {size}, more than {limit}; --memory changes that");
        }
        Ok(systems.kept)
    }

    /// A method's system of every string.
    ///
    /// # Errors
    /// Where it cannot treat one, or a stuck site chatters.
    pub fn systems(&self, method: Method, frequency: f64) -> Result<Systems> {
        let build = |string: usize| {
            let setting = self.setting(self.strings[string], frequency)?;
            let trains = match method {
                Method::Held => self.trains_of(string, &setting)?,
                _ => None,
            };
            let cuts = self.sweep.bit.is_some();
            let system = MethodSystem::build_with(&setting, method, cuts, self.longest, trains)
                .map_err(|error| anyhow!("{error:#}"))?;
            match system.instability() {
                Some(instability) => Err(instability.into()),
                None => Ok(system),
            }
        };
        // The first string's error, whichever was found first.
        let strings = (0..self.strings.len()).into_par_iter();
        let systems: Vec<Result<MethodSystem>> = strings.map(build).collect();
        systems.into_iter().collect()
    }

    /// The trains of a string, found once.
    fn trains_of(&self, string: usize, setting: &Setting) -> Result<Option<&ImpulseTrains>> {
        let found = self.trains[string].get_or_init(|| {
            let cuts = self.sweep.bit.is_some();
            let trains = MethodSystem::trains(setting, cuts, self.longest);
            trains.map_err(|reason| format!("{reason:#}"))
        });
        match found {
            Ok(trains) => Ok(trains.as_ref()),
            Err(reason) => bail!(reason.clone()),
        }
    }

    /// Memory that is kept for all sampling frequencies, bytes.
    pub fn memory_of_trains(&self) -> f64 {
        let found = self.trains.iter().filter_map(OnceLock::get);
        let trains = found.filter_map(|found| found.as_ref().ok()?.as_ref());
        trains.map(ImpulseTrains::bytes).sum()
    }

    /// The answers to all probes, their limits looked for near those of `known`
    /// answers.
    pub fn answers(&self, systems: &Systems, stopping: Stopping, known: &[Answer]) -> Vec<Answer> {
        (self.probes.par_iter().enumerate())
            .map(|(index, probe)| {
                let near = known.get(index).and_then(|known| known.limit);
                self.answer(&systems[probe.string], probe.case, stopping, near)
            })
            .collect()
    }

    fn answer(
        &self,
        system: &MethodSystem,
        case: usize,
        stopping: Stopping,
        near: Option<f64>,
    ) -> Answer {
        let mut found = Answer {
            case,
            ..Answer::default()
        };
        match trial::outcome(self.sweep, system, &self.conditions(case, 1.0), stopping) {
            Ok(outcome) => {
                found.regimes = regimes(&outcome);
                found.measures = measures(&outcome, system.setting.sites.len());
                found.limit = self.limit(system, case, is_inside(&outcome), near);
            }
            Err(reason) => found.regimes = format!("without an answer ({reason})"),
        }
        let least = (system.least_impulses.iter()).filter(|least| least.is_finite());
        let least = least.map(|&least| ("least impulse", least));
        found.measures.extend(least);
        found
    }

    /// Where the regime changes, in multiples of a case's speed or friction: near a
    /// known limit, or else nearest to the case.
    fn limit(
        &self,
        system: &MethodSystem,
        case: usize,
        inside: bool,
        near: Option<f64>,
    ) -> Option<f64> {
        let is_inside_at = |factor: f64| {
            let conditions = self.conditions(case, factor);
            let outcome = trial::outcome(self.sweep, system, &conditions, Stopping::Early);
            outcome.ok().map(|outcome| is_inside(&outcome))
        };
        let around = near.map(|limit| [limit / NEAR, limit * NEAR]);
        let outwards = (1..=DOUBLINGS).flat_map(|exponent| [exponent, -exponent]);
        let octaves = outwards.map(|exponent| {
            let inner = exponent - exponent.signum();
            [2f64.powi(inner), 2f64.powi(exponent)]
        });
        for [from, to] in around.into_iter().chain(octaves) {
            // Inside an octave looked through already nothing has changed.
            let inside = match near {
                Some(_) => is_inside_at(from)?,
                None => inside,
            };
            if is_inside_at(to)? != inside {
                let width = (to / from).ln().abs();
                let halvings = (width / (LIMIT_PART * self.asked)).log2().ceil() as usize;
                return bisected([from, to], inside, halvings, geometric, is_inside_at);
            }
        }
        None
    }

    /// Refuses answers whose limits have islands of the other regime near: those are limits
    /// too, and none that would hold still.
    ///
    /// # Errors
    /// Names the first case with one.
    pub fn check_for_islands(&self, systems: &Systems, answers: &[Answer]) -> Result<()> {
        let probes = self.probes.par_iter().zip(answers);
        let found: Vec<Result<()>> = probes
            .map(|(probe, answer)| {
                let Some(limit) = answer.limit else {
                    return Ok(());
                };
                let is_inside_at = |factor: f64| {
                    let conditions = self.conditions(probe.case, limit * factor);
                    let system = &systems[probe.string];
                    let outcome = trial::outcome(self.sweep, system, &conditions, Stopping::Early);
                    outcome.ok().map(|outcome| is_inside(&outcome))
                };
                let reach = FURTHEST.ln();
                for side in [-1.0, 1.0] {
                    let distances = (0..).map(|doubled| self.asked * 2f64.powi(doubled));
                    let distances = distances.take_while(|distance| *distance < reach);
                    let places = distances.chain([reach]);
                    let mut regimes = places.map(|distance| {
                        let factor = (side * distance).exp();
                        (factor, is_inside_at(factor))
                    });
                    let Some((_, near)) = regimes.next() else {
                        continue;
                    };
                    if let Some((factor, _)) = regimes.find(|(_, regime)| *regime != near) {
                        let case = probe.case;
                        bail!(
                            "the limit near case {case} is ragged: at {factor:.2} times it there \
                             is another"
                        );
                    }
                }
                Ok(())
            })
            .collect();
        found.into_iter().collect()
    }

    /// Δ of Eq. 75 of every string as it is, rad/s per N m; none with a wall, where no
    /// limit hangs on it, and none without a bit.
    ///
    /// # Errors
    /// Where a string cannot be cut into a lattice.
    pub fn exact_undershoots(&self) -> Result<Vec<f64>> {
        if self.sweep.setting.lateral.is_some() || self.sweep.bit.is_none() {
            return Ok(Vec::new());
        }
        let of_string = |&case: &usize| {
            let setting = self.sweep.setting_at(&self.sweep.design.values(case))?;
            Ok(exact_undershoot(&setting.string)?)
        };
        let found: Vec<Result<f64>> = self.strings.par_iter().map(of_string).collect();
        found.into_iter().collect()
    }

    /// The error of the linear responses of all strings: on smooth motions, and of the
    /// `undershoots` that are.
    ///
    /// # Errors
    /// Where they are none of these strings'.
    pub fn linear_error(&self, systems: &Systems, undershoots: &[f64]) -> Result<Difference> {
        let mut worst = Difference {
            part: 0.0,
            of: "the linear responses".to_owned(),
        };
        let mut count = |part: f64, of: &str| {
            if part > worst.part {
                worst.part = part;
                of.clone_into(&mut worst.of);
            }
        };
        for system in systems {
            let (string, responses) = (&system.setting.string, &system.responses);
            let torsion = torsion_error(string, responses)?;
            count(torsion, "the linear responses in torsion");
            if let Some(lateral) = &system.setting.lateral {
                let durations = lateral.impulses.iter().map(|impulse| impulse.duration);
                let shortest = durations.reduce(f64::min).unwrap_or(DURATION);
                let (bending, support) = (&lateral.bending, lateral.support);
                let bending = bending_error(string, bending, support, shortest, responses)?;
                count(bending, "the linear responses in bending");
            }
        }
        for (system, exact) in systems.iter().zip(undershoots) {
            if let Some(taps) = system.driving_point().filter(|_| *exact > 0.0) {
                let part = (largest_undershoot(taps) / exact - 1.0).abs();
                count(part, "the undershoot after a front");
            }
        }
        Ok(worst)
    }
}
