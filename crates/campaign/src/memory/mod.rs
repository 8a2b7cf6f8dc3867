//! Memory asked for before it is taken: what a command is going to take, the limit on it, and
//! which key is to blame where it is too much.
//!
//! What is taken is what the builders of `linear` and `sim` ask for in a dry run
//! ([`linear::budget`]), with what this program holds itself. It is an upper bound; a test compares
//! it with the largest memory of real runs.
//!
//! ```
//! use campaign::memory::{Limit, Size};
//!
//! let size: Size = "1.5G".parse()?;
//! assert_eq!(size.0, 1.5 * 1024f64.powi(3));
//! assert_eq!(Limit::of(Some(size)).bytes, size.0);
//! assert!("half of it".parse::<Size>().is_err());
//! # Ok::<(), String>(())
//! ```

mod blame;
mod demand;
mod limit;

use anyhow::Result;

use crate::engine::Survey;
use crate::plan::{Setting, Sweep};
pub use demand::{Demand, Estimate, Purpose};
pub use limit::{Limit, Size};

/// What a command takes that is about to build `setting` for the cases surveyed.
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
    Ok(demand.within(limit))
}
