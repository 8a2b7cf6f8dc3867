//! Memory known before it is taken: an estimate of what a command is going to take,
//! the limit on it, and what is to blame where it is too much.
//!
//! The estimate adds what `linear` and `sim` say of what they build and step
//! ([`linear::cost`], [`sim::cost`]) to what this program holds itself. It is an upper
//! bound; a test compares it with the largest memory of real runs.

mod blame;
mod demand;
mod limit;

use anyhow::Result;

use crate::engine::Survey;
use crate::plan::{Setting, Sweep};
pub use demand::Purpose;
use demand::{Demand, strings_at_once};
pub use limit::{Limit, Size};

/// What a command is going to take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The most at any time, bytes.
    pub bytes: f64,
    /// Distinct strings to build at once.
    pub strings_at_once: usize,
}

/// Estimates what a command takes that builds `setting` for the cases surveyed.
///
/// # Errors
/// Where the string that takes most cannot be.
pub fn estimate(
    sweep: &Sweep,
    setting: &Setting,
    survey: &Survey,
    purpose: Purpose,
    limit: &Limit,
) -> Result<Estimate> {
    let demand = Demand::of(sweep, setting, survey, purpose)?;
    Ok(within(&demand, limit))
}

/// The same, for a command that is about to begin.
///
/// # Errors
/// Where it would take more than the limit, or more than any method builds, with the
/// key that is to blame.
pub fn admit(
    sweep: &Sweep,
    setting: &Setting,
    survey: &Survey,
    purpose: Purpose,
    limit: &Limit,
) -> Result<Estimate> {
    let demand = Demand::of(sweep, setting, survey, purpose)?;
    let cost = demand.cost(1);
    if cost.too_long.is_some() || cost.bytes > limit.bytes {
        return Err(blame::refusal(&demand, survey, &cost, limit));
    }
    Ok(within(&demand, limit))
}

/// As many strings at once as the limit allows.
fn within(demand: &Demand, limit: &Limit) -> Estimate {
    let strings_at_once = strings_at_once(demand, limit);
    Estimate {
        bytes: demand.cost(strings_at_once).bytes,
        strings_at_once,
    }
}
