//! How much friction whirl needs where the string may touch at more and more contacts: simulated
//! limits, with the bounds of the balance of forces beside them.
//!
//! Contacts are at even distances within a range of the string, and what it is hit with is the
//! same however many there are ([`Blow`]): a knock at one place, or a blow all along the range. A
//! place that is hit and is no contact touches nothing. Whirl is what has that label at the end of
//! the case and has gone round in its closing window.

mod blow;
mod bounds;
mod places;
mod search;
mod subject;
mod touching;

pub use blow::Blow;
pub use bounds::Bounds;
pub use places::Range;
pub use search::{HALVINGS, Least, SCANNED};
pub use subject::{Subject, SubjectError};
pub use touching::Whirl;

use anyhow::Result;
use linear::Method;

use bounds::bounds;
use places::with_others;
use touching::Touching;

/// What was found of some contacts, a blow and a method.
#[derive(Debug)]
pub struct Row {
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
    /// What the string was hit with.
    pub blow: Blow,
    /// The least friction at which whirl lasts, or why it is not known.
    pub limit: Result<Least<Whirl>, String>,
    /// The share of the contacts that touch their wall for most of the closing window there.
    pub share_touching: Option<f64>,
    /// What steady whirl needs at least.
    pub bounds: Bounds,
}

/// Simulations that a string takes at most.
pub fn simulations(subject: &Subject) -> usize {
    let blows = subject.knocked_at.len() * subject.knocks.len() + subject.blows.len();
    let limits = subject.counts.len() * subject.sweep.methods.len() * blows;
    limits * (SCANNED + HALVINGS)
}

/// Studies a string; `tick` is told of every simulation.
///
/// # Errors
/// Where a method cannot treat it.
pub fn study(subject: &Subject, tick: &(dyn Fn() + Sync)) -> Result<Vec<Row>> {
    let (hit_places, blows) = (subject.hit_places(), subject.blows()?);
    let mut rows = Vec::new();
    for &count in &subject.counts {
        let bounds = bounds(subject, count)?;
        for &method in &subject.sweep.methods {
            // Knocks do without the sites of blows along the range, which cost time.
            for (hit, blows) in hit_places.iter().zip(&blows) {
                let touching = Touching::build(subject, count, hit, method)?;
                let limits = touching.limits(blows, tick);
                for (blow, limit) in blows.iter().zip(limits) {
                    let lasts = limit.as_ref().ok().and_then(|limit| limit.lasts);
                    let share = lasts.map(|(friction, _)| touching.share_touching(blow, friction));
                    rows.push(Row {
                        string: subject.name.clone(),
                        method,
                        sampling_frequency: touching.sampling_frequency(),
                        contacts: count,
                        spacing: subject.range.length() / count as f64,
                        blow: *blow,
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

/// Memory that a string takes at once on so many threads, bytes: an upper bound.
///
/// # Errors
/// Where contacts are not on the string.
pub fn memory(subject: &Subject, threads: usize) -> Result<f64> {
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
