//! `accuracy`: the cheapest method and sampling frequency whose error, estimated on
//! the sweep's own string and cases, is within what was asked for.
//!
//! What a case costs grows with f_s and hardly depends on the method, for all are
//! stepped alike; so the ladder goes up in f_s, and at each of its frequencies from
//! the method that is built the fastest to the slowest. Nothing is timed: the same
//! sweep chooses the same on any machine, or is refused where that has too little memory
//! for what is to be tried.
//!
//! The error of a candidate is the largest of
//!
//! - that of its linear responses, on smooth motions, from the exact ones
//!   ([`linear::deviation`]), which share no time step with anything, and of the undershoot
//!   Δ after a front where a limit of stick-slip depends on it,
//! - the shift of the limit between regimes, by surface speed or by friction, near a
//!   few of the sweep's cases (`probes`),
//! - that of the numbers a person would quote of those cases (`answer`),
//!
//! the last two as root mean squares over these cases, from a reference whose own
//! uncertainty counts in full (`reference`).
//!
//! The motion of a bit that cuts is often chaotic. Its numbers are means over some starts, of which chance is
//! a part of what is uncertain, and its limit is that of steady drilling, which is known exactly
//! and, as a method steps it, by its responses (`steady`).

mod answer;
pub mod bisection;
mod candidates;
mod doubling;
mod forecast;
mod fronts;
pub mod methods;
mod probes;
mod reference;
mod search;
mod steady;
mod strings;
pub mod trial;

use linear::Method;
use sim::Stopping;

use crate::memory::Limit;
use crate::plan::{Choice, Sweep};
use crate::sweep_file::{Accuracy, SweepFileError};
pub use answer::is_inside;
use probes::Probes;
use reference::References;
pub use reference::{Attempt, Expected, SearchProgress};
use search::Search;

/// Where the sweep asks for an accuracy, the method chosen for it and the choice, which
/// has the sampling frequency. `tell` hears beforehand how long that will take, and of
/// each attempt.
///
/// # Errors
/// Where nothing delivers the accuracy within the memory, or the sweep's cases are invalid.
pub fn choose(
    sweep: &Sweep,
    full: bool,
    limit: &Limit,
    tell: &dyn Fn(SearchProgress),
) -> Result<Option<(Method, Choice)>, SweepFileError> {
    let Some(Accuracy(asked)) = sweep.content.accuracy else {
        return Ok(None);
    };
    let stopping = if full {
        Stopping::Full
    } else {
        Stopping::Early
    };
    let chosen = Probes::of(sweep, asked, limit).and_then(|probes| {
        let search = Search {
            references: References::new(&probes, asked, tell)?,
            stopping,
        };
        match sweep.setting.lateral {
            None => search.by_fronts(),
            Some(_) => search.by_doubling(),
        }
    });
    let chosen = chosen.map_err(|reason| sweep.source.error("accuracy", reason.to_string()))?;
    Ok(Some(chosen))
}
