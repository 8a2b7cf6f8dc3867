//! Studies: linear methods at sampling frequencies, held against one another on the same
//! cases. `tradeoff` charts what each costs and how far off it is, `stability` where each
//! fails, and `accuracy` chooses one for a sweep. `contacts` asks of the strings themselves: how
//! much friction whirl needs where they may touch at more and more places.
//!
//! What they share stands beside them: `trial` steps a case and keeps the reason where
//! there is no answer, `limit` finds where a regime changes, `stick_slip` up to which speed a bit sticks, `methods` says what methods
//! are told apart by, `scenes` are the shipped sweeps, and `waveguide` hands torsional waves on in
//! time: what is true, by no method of the program.

pub mod accuracy;
pub mod contacts;
mod limit;
mod methods;
pub mod promises;
pub mod scenes;
pub mod stability;
mod stick_slip;
pub mod tradeoff;
mod trial;
mod waveguide;
