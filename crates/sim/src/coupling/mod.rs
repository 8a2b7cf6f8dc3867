//! All sites of a step at once: those that feel one another within it are solved in
//! turn, each with the others' latest loads, until what has changed of these no longer
//! matters. Sites that these cannot bring to their walls wait until the others have settled.
//!
//! Where walls do not rub, a turn of all sites is a descent in each of them of a convex energy
//! (h₀ of all sites is positive definite), and so converges from anywhere; the closer the
//! sites, the slower. Friction has no energy. So where some turns do not do, each is begun with
//! a step of Newton's method on all loads together.

mod loads;
mod newton;
mod sites;
#[cfg(test)]
mod tests;
mod turns;

pub(crate) use sites::{Coupling, Free, Solved, Unloaded};
