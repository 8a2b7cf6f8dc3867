//! Studies of the program about itself: linear methods at sampling frequencies, held against one
//! another on the same cases. `tradeoff` charts what each costs and how far off it is, `stability`
//! where each fails, `promises` how often limits, labels and estimates are wrong. `contacts` asks of
//! the strings themselves: how much friction whirl needs where they may touch at more and more places.
//!
//! `stick_slip` finds up to which speed a bit sticks, `scenes` are the shipped sweeps, and
//! `waveguide` hands torsional waves on in time: what is true, by no method of the program.

pub mod contacts;
pub mod promises;
pub mod scenes;
pub mod stability;
mod stick_slip;
pub mod tradeoff;
mod waveguide;
