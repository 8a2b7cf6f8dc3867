//! The true limit of whirl: in very short steps, by quadrature in bending, where nothing is a
//! front, and with fronts as they are in torsion, where quadrature would have them overshoot
//! and the limit off by per cents, however short the steps.

use anyhow::{Context, Result};
use linear::{ChannelRequest, Method, Request, Responses};

use super::finder::{Finder, HALVED, longest};
use super::problem::Problem;
use campaign::accuracy::bisection::Truth;
use campaign::engine::{MethodSystem, Recipe, Stopwatch};
use campaign::plan::Sweep;

/// Sampling frequencies, Hz, each twice the one before.
pub const FREQUENCIES: [f64; 2] = [5120.0, 10_240.0];

/// Where the limit is looked for, coefficient of friction.
pub const BRACKET: [f64; 2] = [0.3, 6.0];

/// The limit at the higher frequency; what it has changed by from the lower is its
/// uncertainty. (Without wave fronts in torsion it would be a third of that.)
pub fn truth(problem: &Problem) -> Result<Truth> {
    let limit = |frequency: f64, bracket: [f64; 2]| {
        let method = Method::Quadrature.name();
        let sweep = problem.sweep(&format!(
            "methods = [\"{method}\"]\nsampling_frequency_hz = {frequency}\n"
        ))?;
        let system = system(&sweep, longest(problem, &sweep, bracket[0])?)?;
        anyhow::Ok(Finder::by(problem, &sweep, system).between(bracket))
    };
    let [coarse, fine] = FREQUENCIES;
    let one = limit(coarse, BRACKET)?.context("there is no limit")?;
    let other = limit(fine, [one / 1.1, one * 1.1])?.context("the limit is ragged")?;
    Ok(Truth {
        limit: other,
        uncertainty: (other / one - 1.0).abs() + HALVED,
    })
}

/// Quadrature in bending, held torques in torsion.
pub fn system(sweep: &Sweep, longest: f64) -> Result<MethodSystem> {
    let (setting, begun) = (&sweep.setting, Stopwatch::start());
    let bending = Recipe::of(sweep, setting, Method::Quadrature, longest)
        .build()?
        .responses;
    let torques = (0..setting.sites.len()).collect();
    let request = Request {
        sites: setting.sites.clone(),
        channels: vec![ChannelRequest::Torsion { torques }],
        sampling_frequency: setting.sampling_frequency,
        longest_time: longest,
    };
    let torsion = linear::responses(&setting.string, &Method::Held, &request)?;
    let channels = [torsion.torsion(), bending.bending()];
    let responses = Responses {
        channels: channels.into_iter().flatten().cloned().collect(),
        ..bending.clone()
    };
    MethodSystem::of(setting, responses, begun)
}
