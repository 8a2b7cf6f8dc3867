//! How long choosing will take, reported before it begins. The choice does not depend on it.

use std::cell::Cell;
use std::time::Instant;

use sim::Stopping;

use super::probes::{HALVINGS_BEFORE, ISLAND_CASES, Probes};
use super::strings::Systems;
use super::trial;
use linear::parallel;

/// Steps of a case that are timed.
const STEPS_TIMED: f64 = 2000.0;

/// Part of its time that a case takes while a limit is looked for: it ends as soon as its
/// regime is certain.
const EARLY: f64 = 0.5;

/// A reference with a wall is confirmed by another method, and in two other steps: rounds of
/// answers, in those at its own frequency.
const CONFIRMED: f64 = 1.0 + 0.9 + 0.75;

/// What building and looking at the candidates takes, in systems of the reference's frequency:
/// six at each frequency, up to a quarter of that.
const CANDIDATES: f64 = 3.0;

/// Where the waves on the lattice are known, building takes this part of what it takes by other
/// methods.
pub const ON_LATTICE: f64 = 0.4;

/// What simulating a probe takes.
#[derive(Debug, Clone, Copy)]
struct Work {
    /// Time simulated, s.
    duration: f64,
    /// Time that one step takes on one thread, s.
    seconds_a_step: f64,
    /// Whether it is the first of those that share a limit.
    leads_group: bool,
}

impl Work {
    /// By its first steps, those of the probe with this place; `None` where its case is invalid.
    fn of(probes: &Probes, index: usize, leads_group: bool, systems: &Systems) -> Option<Self> {
        let system = probes.system(systems, index);
        let conditions = probes.conditions(probes.case(index), 1.0);
        let mut case = trial::case(probes.sweep, &system.setting, &conditions).ok()?;
        let timing = &mut case.scene.timing;
        let frequency = system.setting.sampling_frequency;
        let duration = timing.duration;
        let timed = duration.min(STEPS_TIMED / frequency);
        timing.duration = timed;
        timing.closing_window = timing.closing_window.min(timed);
        let start = Instant::now();
        // A case without an answer takes no longer than one with.
        let _ = system.simulate(&case, Stopping::Full, None);
        Some(Self {
            duration,
            seconds_a_step: start.elapsed().as_secs_f64() / (timed * frequency),
            leads_group,
        })
    }

    /// Seconds that the whole case takes at a sampling frequency, Hz.
    fn seconds(&self, frequency: f64) -> f64 {
        self.seconds_a_step * self.duration * frequency
    }
}

/// What the probes take on this machine.
#[derive(Debug)]
pub struct Forecast {
    /// Building all systems by one method takes so long for each hertz, s.
    building: f64,
    work: Vec<Work>,
    /// Simulations that find the limit of a group; none where it is found without.
    bisections: f64,
    /// Of each case.
    starts: Cell<f64>,
    threads: f64,
    /// By how much the last answers took longer than was thought.
    slower: Cell<f64>,
}

impl Forecast {
    /// Of probes with these systems, which take so long to build for each hertz, s.
    pub fn of(probes: &Probes, systems: &Systems, building: f64) -> Self {
        let groups = probes.groups();
        let leads = |index: usize| groups.iter().any(|group| group[0] == index);
        let work = (0..probes.cases().len())
            .filter_map(|index| Work::of(probes, index, leads(index), systems));
        let bisections = HALVINGS_BEFORE + probes.halvings() as f64;
        let found = Self::new(building, work.collect(), bisections);
        match probes.cuts() {
            false => found,
            true => Self {
                bisections: 0.0,
                starts: Cell::new(probes.starts() as f64),
                ..found
            },
        }
    }

    /// Of systems with this time to build for each hertz (s), and of cases whose limits are found
    /// by a number of simulations.
    fn new(building: f64, work: Vec<Work>, bisections: f64) -> Self {
        Self {
            building,
            work,
            bisections,
            starts: Cell::new(1.0),
            threads: parallel::threads() as f64,
            slower: Cell::new(1.0),
        }
    }

    /// Seconds until one method at a sampling frequency (Hz) is built and has answered.
    pub fn round(&self, frequency: f64) -> f64 {
        self.building * frequency + self.slower.get() * self.answers(frequency)
    }

    /// Hears how many starts cases have from here on.
    pub fn has_starts(&self, starts: usize) {
        self.starts.set(starts as f64);
    }

    /// Hears how long answers took.
    pub fn took(&self, frequency: f64, seconds: f64) {
        let thought = self.answers(frequency);
        if thought > 0.0 {
            self.slower.set(seconds / thought);
        }
    }

    /// Seconds for a reference in steps of one piece of the lattice, which begins by a look at
    /// `coarse` times the step; the waves on the lattice itself are found once.
    pub fn in_pieces(&self, frequency: f64, coarse: f64) -> f64 {
        let lattice = self.building / ON_LATTICE * frequency;
        let rounds = [1.0 / coarse, 1.0, 2.0].map(|part| self.round(part * frequency));
        lattice + rounds.iter().sum::<f64>() + self.islands(frequency) + self.candidates(frequency)
    }

    /// Seconds for references whose steps are halved, from one frequency to another (Hz) that is
    /// certain, and for what confirms it.
    pub fn by_doubling(&self, from: f64, to: f64) -> f64 {
        // At each frequency half as long as at the next.
        let ladder = 2.0 * self.round(to) - self.round(from);
        ladder + CONFIRMED * self.round(to) + self.islands(to) + self.candidates(to)
    }

    fn candidates(&self, reference: f64) -> f64 {
        CANDIDATES * self.building * reference
    }

    /// Seconds that the look for islands takes.
    fn islands(&self, frequency: f64) -> f64 {
        let cases = if self.bisections > 0.0 {
            ISLAND_CASES
        } else {
            0.0
        };
        self.slower.get() * self.near_limits(cases, frequency)
    }

    /// Seconds that the answers of all probes take, as thought at first.
    fn answers(&self, frequency: f64) -> f64 {
        let times = (self.work.iter()).map(|work| self.starts.get() * work.seconds(frequency));
        self.on_threads(times) + self.near_limits(self.bisections, frequency)
    }

    /// Seconds that a number of cases near the limit of every group take.
    fn near_limits(&self, cases: f64, frequency: f64) -> f64 {
        let groups = self.work.iter().filter(|work| work.leads_group);
        self.on_threads(groups.map(|work| cases * EARLY * work.seconds(frequency)))
    }

    fn on_threads(&self, times: impl Iterator<Item = f64>) -> f64 {
        let times: Vec<f64> = times.collect();
        let busy = self.threads.min(times.len() as f64).max(1.0);
        times.iter().sum::<f64>() / busy
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn forecast() -> Forecast {
        let work = |leads_group: bool| Work {
            duration: 10.0,
            seconds_a_step: 1e-6,
            leads_group,
        };
        Forecast::new(1e-4, vec![work(true), work(false)], 10.0)
    }

    /// At 1 kHz the systems take 0.1 s, a case 0.01 s, and its limit ten times half of that.
    #[test]
    fn a_round_is_what_is_built_and_stepped() {
        let one_thread = Forecast {
            threads: 1.0,
            ..forecast()
        };
        assert!((one_thread.round(1000.0) - (0.1 + 0.02 + 0.05)).abs() < 1e-12);
        let two_threads = Forecast {
            threads: 2.0,
            ..forecast()
        };
        assert!((two_threads.round(1000.0) - (0.1 + 0.01 + 0.05)).abs() < 1e-12);
    }

    /// Answers that took twice as long will again; what is built does not depend on it.
    #[test]
    fn what_was_taken_is_learnt_from() {
        let forecast = forecast();
        let before = forecast.round(1000.0);
        forecast.took(500.0, 2.0 * forecast.answers(500.0));
        let expected = 0.1 + 2.0 * (before - 0.1);
        assert!((forecast.round(1000.0) - expected).abs() < 1e-12);
        assert!(forecast.by_doubling(500.0, 1000.0) > 2.0 * forecast.round(1000.0));
    }
}
