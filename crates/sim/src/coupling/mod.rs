//! All ports of a step at once: those that feel one another within it are solved in
//! turn, each with the others' latest loads, until what has changed of these no longer
//! matters. Ports that these cannot bring to their walls wait until the others have settled.
//!
//! Where walls do not rub, a turn of all ports is a descent in each of them of a convex energy
//! (h₀ of all ports is positive definite), and so converges from anywhere; the closer the
//! ports, the slower. Friction has no energy. So where some turns do not do, each is begun with
//! a step of Newton's method on all loads together, and where that does not do either, half of each turn
//! is taken ([`halved`]).
//!
//! Ports in a row, which feel their neighbours alone, are solved in turn under the speeds of
//! these: Gauss and Seidel's method for a symmetric positive matrix where no law acts. A turn says
//! what is held and what turns, and all that turn are then brought nearer at once.

mod gauss_seidel;
mod halved;
mod loads;
mod neighbours;
mod newton;
mod ports;
mod row;
#[cfg(test)]
mod tests;

pub(crate) use loads::Load;
pub(crate) use ports::{Coupling, Free, Solved, Unloaded};
