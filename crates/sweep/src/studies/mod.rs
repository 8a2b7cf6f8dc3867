//! Studies: linear methods at sampling frequencies, held against one another on the same
//! cases. `tradeoff` charts what each costs and how far off it is, `stability` where each
//! fails, and `accuracy` chooses one for a sweep.
//!
//! What they share stands beside them: `trial` steps a case and keeps the reason where
//! there is no answer, `limit` finds where a regime changes, `methods` says what methods
//! are told apart by, `scenes` are the shipped sweeps.

pub mod accuracy;
mod limit;
mod methods;
pub mod promises;
mod scenes;
pub mod stability;
pub mod tradeoff;
mod trial;
