//! How much friction whirl needs where the string may touch at more and more contacts: simulated
//! limits, together with the bounds by the balance of forces.
//!
//! Contacts are at even distances within a range of the string, and the impulses are the same for
//! any number of them ([`LateralImpulse`]): at one place, or all along the range. A place with an
//! impulse but no contact touches nothing. A case whirls if it has that label at its end and has
//! gone round in its closing window.

mod bounds;
mod impulse;
mod places;
mod search;
mod subject;
mod touching;

pub use bounds::Bounds;
pub use impulse::LateralImpulse;
pub use places::Range;
pub use search::{HALVINGS, Least, SCANNED};
pub use subject::{StudiedString, StudiedStringError};
pub use touching::Whirl;

use anyhow::Result;
use linear::Method;

use bounds::bounds;
use places::with_others;
use touching::Touching;

/// The result for a number of contacts, an impulse and a method.
#[derive(Debug)]
pub struct LimitRow {
    /// Name of the string.
    pub string: String,
    /// The method.
    pub method: Method,
    /// Sampling frequency, Hz.
    pub sampling_frequency: f64,
    /// Number of contacts.
    pub contacts: usize,
    /// Their distance, m.
    pub spacing: f64,
    /// The impulse on the string.
    pub impulse: LateralImpulse,
    /// The least friction at which whirl lasts, or why it is not known.
    pub limit: Result<Least<Whirl>, String>,
    /// The share of the contacts that touch their wall for most of the closing window there.
    pub share_touching: Option<f64>,
    /// What steady whirl needs at least.
    pub bounds: Bounds,
}

/// Simulations that a string takes at most.
pub fn simulations(subject: &StudiedString) -> usize {
    let impulses = subject.struck_at.len() * subject.ratios.len() + subject.per_metre.len();
    let limits = subject.counts.len() * subject.sweep.methods.len() * impulses;
    limits * (SCANNED + HALVINGS)
}

/// Studies a string; `tick` is called after every simulation.
///
/// # Errors
/// Where a method cannot treat it.
pub fn study(subject: &StudiedString, tick: &(dyn Fn() + Sync)) -> Result<Vec<LimitRow>> {
    let (hit_places, impulses) = (subject.hit_places(), subject.impulses()?);
    let mut rows = Vec::new();
    for &count in &subject.counts {
        let bounds = bounds(subject, count)?;
        for &method in &subject.sweep.methods {
            // Local impulses do not need the sites of distributed ones, which cost time.
            for (hit, impulses) in hit_places.iter().zip(&impulses) {
                let touching = Touching::build(subject, count, hit, method)?;
                let limits = touching.limits(impulses, tick);
                for (impulse, limit) in impulses.iter().zip(limits) {
                    let lasts = limit.as_ref().ok().and_then(|limit| limit.lasts);
                    let share =
                        lasts.map(|(friction, _)| touching.share_touching(impulse, friction));
                    rows.push(LimitRow {
                        string: subject.name.clone(),
                        method,
                        sampling_frequency: touching.sampling_frequency(),
                        contacts: count,
                        spacing: subject.range.length() / count as f64,
                        impulse: *impulse,
                        limit: limit.map_err(|error| error.to_string()),
                        share_touching: share.transpose()?,
                        bounds,
                    });
                }
            }
        }
    }
    Ok(rows)
}

/// Memory that a string takes at once on a number of threads, bytes: an upper bound.
///
/// # Errors
/// Where contacts are not on the string.
pub fn memory(subject: &StudiedString, threads: usize) -> Result<f64> {
    let Some(&most) = subject.counts.iter().max() else {
        return Ok(0.0);
    };
    let contacts = subject.range.even(most);
    let mut bytes: f64 = 0.0;
    for hit in subject.hit_places() {
        let places = with_others(&contacts, &hit);
        for &method in &subject.sweep.methods {
            bytes = bytes.max(subject.memory(&places, method, threads)?);
        }
    }
    Ok(bytes)
}
