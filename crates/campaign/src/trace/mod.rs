//! Limits traced over two axes: from labels at some points of a lattice to the points
//! that are wanted next, and to where the limits are.
//!
//! A coarse scan is halved level by level, in the cells that a limit passes and in those
//! around them alone (`refine`). Where halving does not make a limit simpler (`ragged`), it
//! is no line, and a tile of the map gives the fraction of it with the regime. What is left are
//! lines (`contour`). Points are those of a full grid, so that every label is one that the grid
//! would have. Everything here follows from the labels that are known, so that a run may be stopped
//! anywhere and gives the same.

mod band;
mod contour;
mod known;
mod lattice;
mod line;
mod ragged;
mod refine;
#[cfg(test)]
mod tests;

pub use band::Band;
pub use contour::contours;
pub use known::{Class, Known};
pub use lattice::{Lattice, MOST_COARSE, Tile};
pub use line::{LimitLine, join, pieces};
pub use refine::{Next, Traced, next};
