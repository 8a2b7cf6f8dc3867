//! Studies of the program about itself: linear methods at sampling frequencies, held against one
//! another on the same cases. `tradeoff` charts what each costs and how far off it is, `stability`
//! where each fails, `promises` how often limits, labels and estimates are wrong. `contacts` asks of
//! the strings themselves: how much friction whirl needs where they may touch at more and more places.
//!
//! `stick_slip` finds up to which speed a bit sticks by [`sim::waveguide`], by no method of the
//! program; `scenes` are the shipped sweeps.

pub mod contacts;
pub mod promises;
pub mod scenes;
pub mod stability;
mod stick_slip;
pub mod tradeoff;
