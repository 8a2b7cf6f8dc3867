//! A few of the sweep's own cases, simulated to compare methods, and the limits near
//! them.

use anyhow::{Result, anyhow, bail};
use linear::Method;
use linear::cost::Memory;
use linear::deviation::{bending_error, torsion_error};
use linear::method::Transform;
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

    /// The method of the reference. In torsion alone the limit of stick-slip hangs on
    /// wave fronts, which the digital filter has within its band and the quadrature
    /// smooths up to a hundred times higher frequencies; in bending the filter loses
    /// the slow tail, and without damping it cannot be.
    pub fn reference(&self) -> Method {
        let is_damped = |&case: &usize| {
            let setting = self.sweep.setting_at(&self.sweep.design.values(case));
            setting.is_ok_and(|setting| setting.string.torsional_damping() > 0.0)
        };
        if self.sweep.setting.lateral.is_none() && self.strings.iter().all(is_damped) {
            Method::Hilbert(Transform::default())
        } else {
            Method::Quadrature
        }
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
        let bytes = held + systems.then(stepped).peak;
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
        let build = |&case: &usize| {
            let setting = self.setting(case, frequency)?;
            let cuts = self.sweep.bit.is_some();
            let system = MethodSystem::build(&setting, method, cuts, self.longest)
                .map_err(|error| anyhow!("{error:#}"))?;
            match system.instability() {
                Some(instability) => Err(instability.into()),
                None => Ok(system),
            }
        };
        // The first string's error, whichever was found first.
        let systems: Vec<Result<MethodSystem>> = self.strings.par_iter().map(build).collect();
        systems.into_iter().collect()
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

    /// The error of the linear responses of all strings, on smooth motions.
    ///
    /// # Errors
    /// Where they are none of these strings'.
    pub fn linear_error(&self, systems: &Systems) -> Result<Difference> {
        let mut worst = Difference {
            part: 0.0,
            of: "the linear responses".to_owned(),
        };
        for system in systems {
            let (string, responses) = (&system.setting.string, &system.responses);
            let torsion = torsion_error(string, responses)?;
            let bending = match &system.setting.lateral {
                None => 0.0,
                Some(lateral) => {
                    let durations = lateral.impulses.iter().map(|impulse| impulse.duration);
                    let shortest = durations.reduce(f64::min).unwrap_or(DURATION);
                    let (bending, support) = (&lateral.bending, lateral.support);
                    bending_error(string, bending, support, shortest, responses)?
                }
            };
            for (part, of) in [(torsion, "torsion"), (bending, "bending")] {
                if part > worst.part {
                    worst.part = part;
                    worst.of = format!("the linear responses in {of}");
                }
            }
        }
        Ok(worst)
    }
}
