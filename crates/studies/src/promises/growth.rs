//! Whether small vibration about smooth rotation grows under a torque that falls with the bit's
//! speed: as simulated at the default sampling frequency, against the criterion, which is exact in
//! frequency, on random strings in viscous mud, of a material with loss, on which high-frequency
//! torsional oscillation decides.

use std::f64::consts::TAU;

use anyhow::{Context, Result, ensure};
use linear::estimates::torsional_travel_time;
use linear::falling_torque::{Resonance, highest_frequency, resonances};
use linear::sampling::frequency_for_growth;
use linear::steady::rotation;
use linear::{ChannelRequest, Drillstring, Method, Request, Sites};
use rayon::prelude::*;
use sim::{BitTorque, Scene, Simulator, Start, Stopping, Timing, Trajectory};

use super::draw::Draw;
use super::problem::{Begins, Problem, TORQUE};
use campaign::accuracy::bisection::{bisected, geometric};
use campaign::records::to_rpm;

/// The torque falls from rest to full speed by between these parts of [`TORQUE`],
const DROP: [f64; 2] = [0.1, 0.5];

/// and close to rest this many times as steeply as the resonance bears that bears least.
const STEEPER: f64 = 3.0;

/// The fall at which vibration begins to grow is looked for within this factor of the criterion's,
const WITHIN: f64 = 1.1;

/// in this number of halvings: to a few ten-thousandths.
const HALVINGS: usize = 9;

/// A case lasts this number of travel times: the resonance that grows has outlasted all others.
const TRAVELS: f64 = 1000.0;

/// What the disturbance takes of the torque at first, a part of it.
const DISTURBANCE: f64 = 1e-6;

/// Vibration of more than the second part of the surface speed has grown, however fast that was; of
/// less than the first it is rounding.
const ROUNDING: f64 = 1e-11;
const GROWN: f64 = 1e-3;

/// High is what is faster than this number of modes of a uniform string of the same travel time.
const SLOW_MODES: f64 = 24.0;

/// Random numbers of the bits: no string has these.
const STREAM: u64 = 1 << 35;

/// How many steps are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Steps {
    /// At the default sampling frequency.
    Default,
    /// As many as the rule has for vibration that grows, fronts apart.
    ForGrowth,
}

impl Steps {
    const ALL: [Steps; 2] = [Steps::Default, Steps::ForGrowth];

    /// The word in the table.
    pub fn name(self) -> &'static str {
        match self {
            Steps::Default => "default",
            Steps::ForGrowth => "for-growth",
        }
    }
}

/// The fall of the torque at which vibration begins to grow.
#[derive(Debug, Clone, PartialEq)]
pub struct Onset {
    /// On which string.
    pub problem: Problem,
    /// The resonance that bears least.
    pub resonance: Resonance,
    /// How many steps were taken.
    pub steps: Steps,
    /// Hz.
    pub sampling_frequency: f64,
    /// The fall in simulations, N m s/rad; `None` where it is not near the criterion's.
    pub fall: Option<f64>,
}

impl Onset {
    /// The error of the fall, a part of one, with its sign; infinite where it is not near.
    pub fn error(&self) -> f64 {
        let exact = self.resonance.steepest_fall();
        self.fall.map_or(f64::INFINITY, |fall| fall / exact - 1.0)
    }
}

/// Onsets by `held` on a number of strings, the first of those drawn whose resonance that bears
/// least is high; `done` is called after each.
///
/// # Errors
/// Where a string cannot be drawn, or its responses cannot be built.
pub fn onsets_of_growth(strings: usize, seed: u64, done: &(dyn Fn() + Sync)) -> Result<Vec<Onset>> {
    let drawn = (0..).map(|number| Drawn::new(number, seed));
    let wanted = drawn.filter(|drawn| drawn.as_ref().map_or(true, Drawn::is_fast));
    let wanted = wanted.take(strings).collect::<Result<Vec<_>>>()?;
    let onsets = |drawn: &Drawn| {
        let onsets = drawn.onsets();
        done();
        onsets.with_context(|| format!("string {}", drawn.problem.number))
    };
    let found: Vec<Result<Vec<Onset>>> = wanted.par_iter().with_max_len(1).map(onsets).collect();
    Ok(found.into_iter().collect::<Result<Vec<_>>>()?.concat())
}

/// A string and what grows on it first.
struct Drawn {
    problem: Problem,
    string: Drillstring,
    resonance: Resonance,
    bit: BitTorque,
}

impl Drawn {
    fn new(number: usize, seed: u64) -> Result<Self> {
        let problem = Problem::draw_in_mud(number, seed, Begins::Stuck)?;
        let string = problem
            .sweep("sampling_frequency_hz = 1000\n")?
            .setting
            .string;
        let found = resonances(&string, highest_frequency(&string))?.into_iter();
        let least = found.max_by(|one, other| one.mobility.total_cmp(&other.mobility));
        let resonance = least.context("the string does not swing")?;
        let drop = TORQUE * Draw::new(seed, STREAM + number as u64).uniform(DROP[0], DROP[1]);
        let bit = BitTorque {
            torque_static: TORQUE + drop,
            torque_dynamic: TORQUE,
            decay_speed: drop / (STEEPER * resonance.steepest_fall()),
        };
        Ok(Self {
            problem,
            string,
            resonance,
            bit,
        })
    }

    /// Whether what grows first is high-frequency torsional oscillation.
    fn is_fast(&self) -> bool {
        let slow = 0.5 * SLOW_MODES / torsional_travel_time(&self.string);
        self.resonance.frequency > slow
    }

    fn onsets(&self) -> Result<Vec<Onset>> {
        let (string, bit, resonance) = (&self.string, self.bit, self.resonance);
        let exact = resonance.steepest_fall();
        let speed_of = |fall: f64| bit.speed_of_fall(fall).context("the torque falls less");
        let bracket = [exact / WITHIN, exact * WITHIN];
        let speeds = [speed_of(bracket[1])?, speed_of(bracket[0])?];
        let problem = self.problem.under_falling_torque(bit, speeds.map(to_rpm));
        let by_rule = problem.sweep("")?.setting.sampling_frequency;
        let onset = |steps: Steps| {
            let sampling_frequency = match steps {
                Steps::Default => by_rule,
                Steps::ForGrowth => frequency_for_growth(string, bracket[1])?,
            };
            let simulated = Simulated::new(self, sampling_frequency)?;
            let grows = |fall: f64| simulated.grows(speed_of(fall).ok()?).ok();
            let differ = grows(bracket[0]) == Some(false) && grows(bracket[1]) == Some(true);
            let fall = differ.then(|| bisected(bracket, false, HALVINGS, geometric, grows));
            Ok(Onset {
                problem: problem.clone(),
                resonance,
                steps,
                sampling_frequency,
                fall: fall.flatten(),
            })
        };
        Steps::ALL.into_iter().map(onset).collect()
    }
}

/// A string with a bit that cuts, in steps.
struct Simulated<'a> {
    string: &'a Drillstring,
    bit: BitTorque,
    /// Hz.
    resonance: f64,
    sampling_frequency: f64,
    sites: Sites,
    duration: f64,
    simulator: Simulator,
}

impl<'a> Simulated<'a> {
    fn new(drawn: &'a Drawn, sampling_frequency: f64) -> Result<Self> {
        let string = &drawn.string;
        let (sites, duration) = (Sites::bit(), TRAVELS * torsional_travel_time(string));
        let request = Request {
            sites: sites.clone(),
            channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
            sampling_frequency,
            longest_time: duration,
        };
        let responses = linear::responses(string, &Method::Held, &request)?;
        Ok(Self {
            string,
            bit: drawn.bit,
            resonance: drawn.resonance.frequency,
            sampling_frequency,
            sites,
            duration,
            simulator: Simulator::new(&responses)?,
        })
    }

    /// Whether a disturbance of smooth rotation at a surface speed (rad/s) grows.
    fn grows(&self, speed: f64) -> Result<bool> {
        let torque = (1.0 - DISTURBANCE) * self.bit.torque_at(speed);
        let scene = Scene {
            surface_speed: speed,
            start: Start::Steady(rotation(self.string, &self.sites, speed, torque)),
            bit: Some(self.bit),
            friction: Vec::new(),
            axial: None,
            lateral: None,
            timing: Timing {
                duration: self.duration,
                closing_window: 1.0,
            },
        };
        let mut motion = Trajectory::default();
        (self.simulator).simulate(&scene, Stopping::Full, Some(&mut motion))?;
        let speeds = &motion.speeds[0];
        let window = speeds.len() / 8;
        ensure!(window > 0, "no steps were taken");
        // Differences from step to step: slow modes die away last, and hardly count in these.
        let per_step = TAU * self.resonance / self.sampling_frequency;
        let vibration = |part: &[f64]| {
            let changes = part.windows(2).map(|ends| (ends[1] - ends[0]).powi(2));
            (changes.sum::<f64>() / part.len() as f64).sqrt() / per_step
        };
        let [early, late] = [5, 7].map(|place| vibration(&speeds[place * window..][..window]));
        let is_there = late > ROUNDING * speed;
        Ok((is_there && late > early) || late > GROWN * speed)
    }
}
