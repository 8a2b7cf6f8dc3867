//! In which rock small motion about steady drilling begins to grow, as simulated at the default
//! sampling frequency, against the exact criterion; and how long responses are that were estimated.

use anyhow::{Context, Result, ensure};
use linear::estimates::torsional_travel_time;
use linear::{ChannelRequest, ChannelResponses, Method, Request, ResponsePlan};
use rayon::prelude::*;
use sim::{Stopping, Trajectory};

use super::cutting::{CuttingProblem, WITHIN, in_rock};
use campaign::accuracy::bisection::{bisected, geometric};
use campaign::accuracy::trial;
use campaign::engine::{MethodSystem, Recipe, StringMemory};
use campaign::plan::Sweep;
use campaign::sweep_file::AutoOr;

/// Halvings of the factor on both sides of the exact limit: to a few ten-thousandths.
const HALVINGS: usize = 9;

/// A case lasts this number of travel times, and this time, s, at least: what grows has outlasted all
/// else.
const TRAVELS: f64 = 500.0;
const LEAST: f64 = 200.0;

/// More steps are not taken: their motion would not fit in memory.
const MOST_STEPS: f64 = 4e6;

/// The disturbance at first, a part of torque and weight.
const DISTURBANCE: f64 = 1e-4;

/// A depth of cut that varies by more than the second part of itself has grown, however fast that was;
/// by less than the first it is rounding.
const ROUNDING: f64 = 1e-10;
const GROWN: f64 = 1e-2;

/// The responses that a limit was found with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lengths {
    /// Impulse responses of the bit, the longest in torsion and along the axis: taps.
    pub taps: usize,
    /// The same, as estimated before they were built.
    pub estimated_taps: usize,
    /// How large the last tap is at most, over the largest.
    pub left: f64,
    /// Bytes of the taps.
    pub bytes: f64,
    /// What the system was estimated to keep, and to take at most while it was built, bytes.
    pub estimated_bytes: [f64; 2],
}

/// A limit by a method.
#[derive(Debug, Clone, PartialEq)]
pub struct CuttingLimit {
    /// On which string, under which bit.
    pub problem: CuttingProblem,
    /// The method.
    pub method: &'static str,
    /// Hz.
    pub sampling_frequency: f64,
    /// The hardest rock in simulations, MPa; `None` where it is not near the exact one, or there is no
    /// exact one.
    pub energy: Option<f64>,
    /// What it was found with, where there is a limit to find, and a case takes no more than
    /// four million steps.
    pub lengths: Option<Lengths>,
}

impl CuttingLimit {
    /// The error of the limit, a part of one, with its sign: infinite where it is not near the exact
    /// one; `None` where there is no exact one, or it was not looked for.
    pub fn error(&self) -> Option<f64> {
        let exact = self.problem.exact.as_ref().ok()?;
        let error = |energy: f64| energy / exact.energy - 1.0;
        self.lengths?;
        Some(self.energy.map_or(f64::INFINITY, error))
    }
}

/// Limits by some methods on a number of strings; `done` is called after each string.
///
/// # Errors
/// Where a string cannot be drawn, or its responses cannot be built.
pub fn cutting_limits(
    methods: &[Method],
    strings: usize,
    seed: u64,
    done: &(dyn Fn() + Sync),
) -> Result<Vec<CuttingLimit>> {
    let of_string = |number: usize| {
        let problem = CuttingProblem::draw(number, seed)?;
        let limits = methods.iter().map(|method| limit(&problem, *method));
        let limits: Result<Vec<CuttingLimit>> = limits.collect();
        done();
        limits.with_context(|| format!("string {number}"))
    };
    let numbers = (0..strings).into_par_iter().with_max_len(1);
    let found: Vec<Result<Vec<CuttingLimit>>> = numbers.map(of_string).collect();
    Ok(found.into_iter().collect::<Result<Vec<_>>>()?.concat())
}

fn limit(problem: &CuttingProblem, method: Method) -> Result<CuttingLimit> {
    let mut found = CuttingLimit {
        problem: problem.clone(),
        method: method.name(),
        sampling_frequency: 0.0,
        energy: None,
        lengths: None,
    };
    let Ok(exact) = &problem.exact else {
        return Ok(found);
    };
    let sweep = sweep(problem, method)?;
    found.sampling_frequency = sweep.setting.sampling_frequency;
    let AutoOr::Given(duration) = sweep.time else {
        return Ok(found);
    };
    if duration * found.sampling_frequency > MOST_STEPS {
        return Ok(found);
    }
    // With its parameters, as a sweep has them.
    let method = sweep.methods[0];
    let simulated = Simulated::new(sweep, method, duration)?;
    found.lengths = Some(simulated.lengths()?);
    let ends = [exact.energy / WITHIN, exact.energy * WITHIN];
    let [below, above] = [simulated.grows(ends[0])?, simulated.grows(ends[1])?];
    if !below && above {
        let grows = |energy: f64| simulated.grows(energy).ok();
        found.energy = bisected(ends, false, HALVINGS, geometric, grows);
    }
    Ok(found)
}

/// The sweep of a problem by a method, in cases that are long enough, hardly disturbed.
fn sweep(problem: &CuttingProblem, method: Method) -> Result<Sweep> {
    let name = method.name();
    let with = |time: &str| {
        let first = format!("methods = [\"{name}\"]\nstart_disturbance = {DISTURBANCE}\n");
        problem.problem.sweep(&format!("{first}{time}"))
    };
    let travel = torsional_travel_time(&with("")?.setting.string);
    let duration = (TRAVELS * travel).max(LEAST);
    with(&format!("time_s = {duration}\n"))
}

/// A string with a bit that cuts, in steps.
struct Simulated {
    sweep: Sweep,
    method: Method,
    duration: f64,
    system: MethodSystem,
}

impl Simulated {
    fn new(sweep: Sweep, method: Method, duration: f64) -> Result<Self> {
        let system = Recipe::of(&sweep, &sweep.setting, method, duration).build()?;
        Ok(Self {
            sweep,
            method,
            duration,
            system,
        })
    }

    /// Whether a disturbance of steady drilling grows in a rock, MPa.
    fn grows(&self, energy: f64) -> Result<bool> {
        let conditions = in_rock(&self.sweep, energy);
        let case = trial::case(&self.sweep, &self.system.setting, &conditions)?;
        let mut motion = Trajectory::default();
        (self.system).simulate(&case, Stopping::Full, Some(&mut motion))?;
        let depths: Vec<f64> = motion.cut.iter().map(|step| step.depth_of_cut).collect();
        let window = depths.len() / 8;
        ensure!(window > 0, "no steps were taken");
        let [early, late] = [5, 7].map(|place| variation(&depths[place * window..][..window]));
        Ok((late > ROUNDING && late > early) || late > GROWN)
    }

    fn lengths(&self) -> Result<Lengths> {
        let setting = &self.sweep.setting;
        let cutting = setting.cutting.as_ref().context("the bit cuts")?;
        let bit = setting.sites.len() - 1;
        let request = Request {
            sites: setting.sites.clone(),
            channels: vec![
                ChannelRequest::Torsion { torques: vec![bit] },
                ChannelRequest::Axial {
                    rod: Box::new(cutting.rod.clone()),
                    forces: vec![bit],
                },
            ],
            sampling_frequency: setting.sampling_frequency,
            longest_time: self.duration,
        };
        let plan = ResponsePlan::new(&setting.string, &self.method, &request)?;
        let channels = &self.system.responses.channels;
        let methods = [self.method];
        let memory = StringMemory::of(&self.sweep, setting, &methods, self.duration).systems;
        Ok(Lengths {
            taps: (channels.iter().map(ChannelResponses::taps))
                .max()
                .unwrap_or(0),
            estimated_taps: plan.torsion_taps().max(plan.axial_taps()),
            left: channels.iter().map(left).fold(0.0, f64::max),
            bytes: channels.iter().flat_map(series).map(size).sum(),
            estimated_bytes: [memory.kept, memory.peak],
        })
    }
}

/// The root mean square of what depths of cut differ by from their mean, a part of that.
pub(super) fn variation(depths: &[f64]) -> f64 {
    let count = depths.len() as f64;
    let mean = depths.iter().sum::<f64>() / count;
    let squares: f64 = depths.iter().map(|depth| (depth - mean).powi(2)).sum();
    (squares / count).sqrt() / mean.abs()
}

/// All responses of a motion.
fn series(channel: &ChannelResponses) -> impl Iterator<Item = &Vec<f64>> {
    channel
        .from_surface
        .iter()
        .chain(channel.from_loads.iter().flatten())
}

fn size(taps: &Vec<f64>) -> f64 {
    size_of_val(taps.as_slice()) as f64
}

/// The last tap from a load over the largest, in the worst response of a motion.
fn left(channel: &ChannelResponses) -> f64 {
    let part = |taps: &Vec<f64>| {
        let largest = taps.iter().fold(0.0f64, |most, tap| most.max(tap.abs()));
        taps.last().map_or(0.0, |last| last.abs() / largest)
    };
    let from_loads = channel.from_loads.iter().flatten();
    from_loads.map(part).fold(0.0, f64::max)
}
