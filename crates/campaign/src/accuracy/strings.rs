//! The strings of the probes: their systems by any method, what these take, and how far
//! they are off from the exact waves.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use anyhow::{Result, anyhow, bail};
use linear::budget::Need;
use linear::deviation::{ExactMotions, exact_undershoot, undershoot_need};
use linear::estimates::{largest_undershoot, torsional_travel_time};
use linear::waves::lattice::Lattice;
use linear::{ImpulseTrains, Method, parallel};
use sim::SteppedLoop;

use super::answer::Difference;
use crate::engine::{MethodSystem, Recipe, StringMemory};
use crate::memory::{Limit, Size};
use crate::plan::{CuttingSettings, LateralSettings, Setting, Sweep};

/// Duration of the impulse in bending where the scene has none, s.
const DURATION: f64 = 0.02;

/// One method's system of every string among the probes.
pub type Systems = Vec<MethodSystem>;

/// Steps of every string.
#[derive(Debug, Clone, Copy)]
pub enum Steps {
    /// At a frequency, Hz.
    Frequency(f64),
    /// As long as a wave takes along a number of pieces of its lattice.
    Pieces(f64),
}

/// The strings among some cases of a sweep.
pub struct Strings<'a> {
    sweep: &'a Sweep,
    /// A case of each string.
    cases: Vec<usize>,
    /// The longest time that any case is simulated, s.
    longest: f64,
    limit: Limit,
    /// The trains of impulses of each string, as soon as they are wanted, or why there are
    /// none.
    trains: Vec<OnceLock<Result<Option<ImpulseTrains>, String>>>,
    /// The exact motions of each string at each sampling frequency (its bits) so far.
    motions: Mutex<HashMap<(usize, u64), Arc<Motions>>>,
}

/// How the sites of a string truly move.
struct Motions {
    torsion: ExactMotions,
    axial: Option<ExactMotions>,
    bending: Option<ExactMotions>,
}

impl<'a> Strings<'a> {
    /// None yet.
    pub fn new(sweep: &'a Sweep, limit: &Limit) -> Self {
        Self {
            sweep,
            cases: Vec::new(),
            longest: 0.0,
            limit: *limit,
            trains: Vec::new(),
            motions: Mutex::default(),
        }
    }

    /// The place of a case's string among them, which is made if need be; the case takes at
    /// most the `longest` time, s.
    pub fn place_of(&mut self, case: usize, longest: f64) -> usize {
        self.longest = self.longest.max(longest);
        let design = &self.sweep.design;
        let has_its_string = |other: &usize| design.string_of(*other) == design.string_of(case);
        self.cases
            .iter()
            .position(has_its_string)
            .unwrap_or_else(|| {
                self.cases.push(case);
                self.trains.push(OnceLock::new());
                self.cases.len() - 1
            })
    }

    /// The time (s) a torsional wave takes along the first string.
    ///
    /// # Errors
    /// Where that string is invalid.
    pub fn travel(&self) -> Result<f64> {
        let values = self.sweep.design.values(self.cases[0]);
        Ok(torsional_travel_time(
            &self.sweep.setting_at(&values)?.string,
        ))
    }

    /// The frequency (Hz) of steps of one piece of the first string's lattice.
    ///
    /// # Errors
    /// Where that string is invalid, or cannot be cut into a lattice.
    pub fn frequency_of_pieces(&self) -> Result<f64> {
        let values = self.sweep.design.values(self.cases[0]);
        frequency_of_pieces(self.sweep.setting_at(&values)?.as_ref())
    }

    /// The setting of a string's case, sampled otherwise.
    fn setting(&self, case: usize, steps: Steps) -> Result<Setting> {
        let values = self.sweep.design.values(case);
        let frequency = match steps {
            Steps::Frequency(frequency) => frequency,
            Steps::Pieces(pieces) => {
                frequency_of_pieces(self.sweep.setting_at(&values)?.as_ref())? / pieces
            }
        };
        let setting = self.sweep.setting_sampled(&values, frequency);
        setting.map_err(|error| anyhow!(error.message().to_owned()))
    }

    /// The memory that a method's systems keep, bytes, where they can be built together with others
    /// that keep `held`.
    ///
    /// # Errors
    /// Where building and stepping them would take more than the limit.
    pub fn fits(&self, method: Method, steps: Steps, held: f64) -> Result<f64> {
        // An invalid string is reported when it is to be built.
        let settings = (self.cases.iter()).filter_map(|&case| self.setting(case, steps).ok());
        let (mut systems, mut case) = (Need::default(), 0.0f64);
        for setting in settings {
            let of_string = StringMemory::of(self.sweep, &setting, &[method], self.longest);
            // A transform that is too long is refused at once, and takes nothing; others
            // are built longer and longer until then.
            let is_transform = matches!(method, Method::Hilbert(_) | Method::DirectIdft(_));
            match of_string.too_long {
                Some(_) if is_transform => continue,
                Some(taps) => bail!("would have responses of {taps:.1e} steps, which is too long"),
                None => {}
            }
            systems = systems.and(of_string.systems);
            case = case.max(of_string.case);
            if setting.cutting.is_some() {
                case = case.max(SteppedLoop::bytes(
                    self.longest * setting.sampling_frequency,
                ));
            }
        }
        let stepped = Need::lasting(parallel::threads() as f64 * case);
        let bytes = held + self.memory_of_trains() + systems.then(stepped).peak;
        let bytes = bytes.max(self.memory_of_fronts());
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
    pub fn systems(&self, method: Method, steps: Steps) -> Result<Systems> {
        let build = |string: usize| {
            let setting = self.setting(self.cases[string], steps)?;
            let trains = match method {
                Method::Held => self.trains_of(string, &setting)?,
                _ => None,
            };
            let recipe = self.recipe(&setting, method).with_trains(trains);
            let system = recipe.build().map_err(|error| anyhow!("{error:#}"))?;
            match system.instability() {
                Some(instability) => Err(instability.into()),
                None => Ok(system),
            }
        };
        // The first string's error, whichever was found first.
        let systems: Vec<Result<MethodSystem>> = parallel::map(self.cases.len(), 1, build);
        systems.into_iter().collect()
    }

    fn recipe<'b>(&self, setting: &'b Setting, method: Method) -> Recipe<'b> {
        Recipe::alone(setting, method, self.sweep.bit.is_some(), self.longest)
    }

    /// The trains of a string, found once.
    fn trains_of(&self, string: usize, setting: &Setting) -> Result<Option<&ImpulseTrains>> {
        let found = self.trains[string].get_or_init(|| {
            let trains = self.recipe(setting, Method::Held).trains();
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

    /// Whether Eq. 74 is the limit of its cases: no wall, bit that cuts, or free bit.
    fn has_fronts(&self) -> bool {
        let setting = &self.sweep.setting;
        setting.lateral.is_none() && setting.cutting.is_none() && self.sweep.bit.is_some()
    }

    /// Memory that [`Self::exact_undershoots`] takes, bytes.
    fn memory_of_fronts(&self) -> f64 {
        if !self.has_fronts() {
            return 0.0;
        }
        let settings = (self.cases.iter())
            .filter_map(|&case| self.sweep.setting_at(&self.sweep.design.values(case)).ok());
        let needs = settings.map(|setting| undershoot_need(&setting.string).peak);
        let at_once = parallel::threads().min(self.cases.len());
        at_once as f64 * needs.fold(0.0, f64::max)
    }

    /// Δ of Eq. 75 of every string as it is, rad/s per N m; empty with a wall, where limits depend
    /// on more than that, above a bit that cuts, without a bit, and where memory is too small, which
    /// [`Self::fits`] refuses.
    ///
    /// # Errors
    /// Where a string cannot be cut into a lattice.
    pub fn exact_undershoots(&self) -> Result<Vec<f64>> {
        if !self.has_fronts() || self.memory_of_fronts() > self.limit.bytes {
            return Ok(Vec::new());
        }
        let of_string = |string: usize| {
            let case = self.cases[string];
            let setting = self.sweep.setting_at(&self.sweep.design.values(case))?;
            Ok(exact_undershoot(&setting.string)?)
        };
        let found: Vec<Result<f64>> = parallel::map(self.cases.len(), 1, of_string);
        found.into_iter().collect()
    }

    /// How the sites of a string truly move, sampled as a system of it is; found once.
    fn motions_of(&self, string: usize, system: &MethodSystem) -> Result<Arc<Motions>> {
        let found = || self.motions.lock().unwrap_or_else(PoisonError::into_inner);
        let place = (string, system.responses.sampling_frequency.to_bits());
        if let Some(motions) = found().get(&place) {
            return Ok(Arc::clone(motions));
        }
        let motions = Arc::new(Motions::of(system)?);
        found().insert(place, Arc::clone(&motions));
        Ok(motions)
    }

    /// The error of the linear responses of all strings: on smooth motions, and of the
    /// `undershoots` that are.
    ///
    /// # Errors
    /// Where they do not belong to these strings.
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
        for (string, system) in systems.iter().enumerate() {
            let motions = self.motions_of(string, system)?;
            let torsion = motions.torsion.error_of(&system.responses)?;
            count(torsion, "the linear responses in torsion");
            if let Some(axial) = &motions.axial {
                let axial = axial.error_of(&system.responses)?;
                count(axial, "the linear responses along the axis");
            }
            if let Some(bending) = &motions.bending {
                let bending = bending.error_of(&system.responses)?;
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

impl Motions {
    fn of(system: &MethodSystem) -> Result<Self> {
        let (string, sites) = (&system.setting.string, &system.responses.sites);
        let frequency = system.responses.sampling_frequency;
        let in_bending = |lateral: &LateralSettings| {
            let durations = lateral.impulses.iter().map(|impulse| impulse.duration);
            let shortest = durations.reduce(f64::min).unwrap_or(DURATION);
            let (bending, support) = (&lateral.bending, lateral.support);
            ExactMotions::in_bending(string, bending, support, sites, shortest, frequency)
        };
        let along_axis = |cutting: &CuttingSettings| {
            ExactMotions::along_axis(string, &cutting.rod, sites, frequency)
        };
        Ok(Self {
            torsion: ExactMotions::in_torsion(string, sites, frequency)?,
            axial: (system.setting.cutting.as_ref())
                .map(along_axis)
                .transpose()?,
            bending: system
                .setting
                .lateral
                .as_ref()
                .map(in_bending)
                .transpose()?,
        })
    }
}

fn frequency_of_pieces(setting: &Setting) -> Result<f64> {
    Ok(Lattice::new(&setting.string, &setting.sites)?.step.recip())
}
