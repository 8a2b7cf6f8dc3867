//! What a sweep costs on this machine: memory by count, wall time by a short probe of
//! the sweep's own cases.

use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::Result;
use linear::parallel;
use sim::Scene;

use campaign::design::Design;
use campaign::engine::{
    Case, MethodSystem, Recipe, RunOptions, StringMemory, Survey, add_finer, answer,
};
use campaign::memory::{Estimate, Limit, Size};
use campaign::plan::{Setting, Sweep};
use campaign::words::counted;

/// The probe builds and steps for no longer than this.
const PROBE: Duration = Duration::from_secs(10);

/// Cases are stepped for this part of it at most, after what was built.
const STEPPING: Duration = Duration::from_secs(1);

/// Steps of a case in the probe, at most.
const STEPS: f64 = 10_000.0;

/// Cases in the probe for each thread, evenly spread over the design.
const CASES_PER_THREAD: usize = 32;

/// A prime number, to take cases in an order that follows no axis.
const SHUFFLE: usize = 7919;

/// How often a wait looks whether it is to end.
const GLANCE: Duration = Duration::from_millis(50);

/// Wall time of a run.
#[derive(Debug)]
pub enum WallTime {
    /// About this number of seconds.
    About(f64),
    /// Not known: the probe was not done in its time.
    Unknown,
    /// It would not finish; why.
    Refused(anyhow::Error),
}

impl WallTime {
    /// The time that a probe extrapolates to, s, which is a number only where it stepped a case.
    fn from_seconds(seconds: f64) -> Self {
        match seconds.is_finite() {
            true => Self::About(seconds),
            false => Self::Unknown,
        }
    }
}

/// What a sweep costs, in words: the memory it takes at most, the limit on that, and
/// its time.
pub fn cost_lines(memory: &Estimate, limit: &Limit, time: &WallTime) -> String {
    let threads = counted(parallel::threads(), "thread");
    let time = match time {
        WallTime::About(seconds) => {
            format!(
                "{} on {threads} for the cases, by a short probe",
                in_words(*seconds)
            )
        }
        WallTime::Unknown => {
            let probe = PROBE.as_secs();
            format!("not known; a probe of {probe} s was too short")
        }
        WallTime::Refused(reason) => format!("none, for {reason:#}"),
    };
    let bytes = Size(memory.bytes);
    format!("memory: at most {bytes}; limit: {limit}\nwall time: {time}\n")
}

/// A time as a person would say it.
pub fn in_words(seconds: f64) -> String {
    const MINUTE: f64 = 60.0;
    const HOUR: f64 = 60.0 * MINUTE;
    const DAY: f64 = 24.0 * HOUR;
    let units = [("s", 1.0), ("min", MINUTE), ("h", HOUR), ("days", DAY)];
    if seconds < 1.0 {
        return "less than a second".to_owned();
    }
    let (unit, length) = (units.into_iter().rev())
        .find(|(_, length)| seconds >= 1.5 * length)
        .unwrap_or(units[0]);
    let count = seconds / length;
    if count < 10.0 {
        format!("about {count:.1} {unit}")
    } else if count < 1e5 {
        format!("about {count:.0} {unit}")
    } else {
        format!("about {count:.0e} {unit}")
    }
}

/// How often a trace builds each string, where its limit goes along the axis of the string: 510
/// times for 257 values of made-up limits.
const BUILT_BY_A_TRACE: f64 = 2.0;

/// What a case takes on one thread of this machine, as a mean over cases and methods.
#[derive(Debug, Clone, Copy)]
struct Pace {
    /// Building the systems of a string, s.
    building: f64,
    /// Stepping one case by one method, s.
    stepping: f64,
}

impl Pace {
    /// Seconds for a number of simulations.
    fn seconds(&self, sweep: &Sweep, simulations: usize) -> f64 {
        let all = (sweep.design.cases() * sweep.methods.len()).max(1);
        let part = simulations as f64 / all as f64;
        let (design, strings) = (&sweep.design, sweep.design.strings());
        let varied = match design {
            _ if !design.varies_string() => 0.0,
            // Whose cases of one string are of several rounds, unless each has its own.
            Design::Trace(_) if strings < design.cases() => BUILT_BY_A_TRACE * strings as f64,
            _ => part * strings as f64,
        };
        let stepped = simulations as f64 * self.stepping / parallel::threads() as f64;
        (1.0 + varied) * self.building + stepped
    }
}

/// The time that a number of simulations of a sweep take, by building its systems for short
/// cases and stepping some, for a bounded time. `stops` ends it sooner.
pub fn probe(
    sweep: &Sweep,
    survey: &Survey,
    options: RunOptions,
    simulations: usize,
    stops: &dyn Fn() -> bool,
) -> WallTime {
    let start = Instant::now();
    let (send, receive) = channel();
    let (owned, longest) = (sweep.clone(), survey.longest);
    thread::spawn(move || {
        let paced = build_and_step(&owned, longest, options);
        // The receiver may have stopped waiting.
        let _ = send.send(paced);
    });
    loop {
        match receive.recv_timeout(GLANCE) {
            Ok(Ok(pace)) => return WallTime::from_seconds(pace.seconds(sweep, simulations)),
            Ok(Err(reason)) => return WallTime::Refused(reason),
            Err(RecvTimeoutError::Timeout) if start.elapsed() < PROBE && !stops() => {}
            Err(_) => return WallTime::Unknown,
        }
    }
}

/// The time that all simulations of a sweep take, its systems being built.
pub fn of_built(sweep: &Sweep, survey: &Survey, systems: &[MethodSystem], built: f64) -> WallTime {
    let stepping = step(sweep, systems, survey.longest, RunOptions::default());
    let pace = Pace {
        building: built,
        stepping,
    };
    WallTime::from_seconds(pace.seconds(sweep, sweep.design.likely_cases() * sweep.methods.len()))
}

fn build_and_step(sweep: &Sweep, longest: f64, options: RunOptions) -> Result<Pace> {
    let setting = sweep.setting.for_labels();
    let prepared = longest.min(STEPS / sweep.highest_frequency());
    let start = Instant::now();
    let systems = Recipe::build_each(sweep, &setting, prepared, &[]);
    let systems = systems.into_iter().collect::<Result<_>>()?;
    let systems = add_finer(systems, sweep, prepared)?;
    let built = start.elapsed().as_secs_f64();
    Ok(Pace {
        // What takes so much more memory takes as much more time.
        building: built * systems_memory(sweep, &setting, longest)
            / systems_memory(sweep, &setting, prepared),
        stepping: step(sweep, &systems, prepared, options),
    })
}

fn systems_memory(sweep: &Sweep, setting: &Setting, longest: f64) -> f64 {
    let memory = StringMemory::of(sweep, setting, &sweep.methods, longest);
    memory.systems.kept
}

/// Mean time of a case by a method, s, from some of them, evenly spread and shortened
/// to what systems are prepared for.
fn step(sweep: &Sweep, systems: &[MethodSystem], prepared: f64, options: RunOptions) -> f64 {
    // An unstable method takes its time too.
    let options = RunOptions {
        allow_unstable: true,
        ..options
    };
    let start = Instant::now();
    let cases = sweep.design.cases();
    let count = cases.min(CASES_PER_THREAD * parallel::threads());
    let most = prepared.min(STEPS / sweep.highest_frequency());
    let of_case = |index: usize| -> Option<f64> {
        if start.elapsed() > STEPPING {
            return None;
        }
        // In an order that follows no axis.
        let place = index * SHUFFLE % count;
        let case = (2 * place + 1) * cases / (2 * count);
        let mut case = Case::of(sweep, &systems.first()?.setting, case).ok()?;
        let part = shorten(&mut case.scene, most);
        let begun = Instant::now();
        for (method, system) in systems.iter().enumerate() {
            answer(system, &case, method, options, sweep);
        }
        Some(begun.elapsed().as_secs_f64() / part)
    };
    let times = parallel::map(count, 1, of_case);
    let times: Vec<f64> = times.into_iter().flatten().collect();
    times.iter().sum::<f64>() / (times.len() * systems.len()).max(1) as f64
}

/// Shortens a case to a duration (s), and gives the part of it that is left. Impulses
/// come as much earlier; where only torsion is modelled, all goes as much faster with a
/// surface that turns so.
fn shorten(scene: &mut Scene, most: f64) -> f64 {
    let part = (most / scene.timing.duration).min(1.0);
    if part < 1.0 {
        scene.timing.duration = most;
        scene.timing.closing_window *= part;
        match &mut scene.lateral {
            Some(lateral) => {
                for impulse in &mut lateral.impulses {
                    impulse.start *= part;
                }
            }
            None => scene.surface_speed /= part,
        }
    }
    part
}
