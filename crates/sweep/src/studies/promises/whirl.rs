//! The true limit of whirl: quadrature in very short steps.

use anyhow::{Context, Result};
use linear::Method;

use super::finder::{Finder, HALVED, Truth};
use super::problem::Problem;

/// Sampling frequencies, Hz, each twice the one before.
const FREQUENCIES: [f64; 2] = [5120.0, 10_240.0];

/// Where the limit is looked for, coefficient of friction.
const BRACKET: [f64; 2] = [0.3, 6.0];

/// The limit at the higher frequency; what it has changed by from the lower is its
/// uncertainty. (Without wave fronts in torsion it would be a third of that.)
pub fn truth(problem: &Problem) -> Result<Truth> {
    let limit = |frequency: f64, bracket: [f64; 2]| {
        let method = Method::Quadrature.name();
        let sweep = problem.sweep(&format!(
            "methods = [\"{method}\"]\nsampling_frequency_hz = {frequency}\n"
        ))?;
        anyhow::Ok(Finder::new(problem, &sweep, bracket[0])?.between(bracket))
    };
    let [coarse, fine] = FREQUENCIES;
    let one = limit(coarse, BRACKET)?.context("there is no limit")?;
    let other = limit(fine, [one / 1.1, one * 1.1])?.context("the limit is ragged")?;
    Ok(Truth {
        limit: other,
        uncertainty: (other / one - 1.0).abs() + HALVED,
    })
}
