//! Limits traced over two axes: from labels at some points of a lattice to the points
//! that are wanted next, and to where the limits are.
//!
//! A coarse scan is halved level by level, in the cells that a limit passes and in those
//! around them alone (`refine`). Where halving does not make a limit simpler (`ragged`), it
//! is no line, and a tile of the map gives the fraction of it with the regime. What is left are
//! lines (`contour`). Points are those of a full grid, so that every label is one that the grid
//! would have. Everything here follows from the labels that are known, so that a run may be stopped
//! anywhere and gives the same.
//!
//! A quarter of a circle is found from a part of the points:
//!
//! ```
//! use campaign::trace::{Class, Known, Lattice, Next, contours, next};
//!
//! let lattice = Lattice::new([8, 8], 0.01);
//! let [columns, rows] = lattice.size();
//! let mut known = Known::nothing(lattice, 1);
//! let mut asked = 0;
//! let traced = loop {
//!     let points = match next(&known, 0) {
//!         Next::Wanted(points) => points,
//!         Next::Done(traced) => break traced,
//!     };
//!     asked += points.len();
//!     for point in points {
//!         let [x, y] = [point / rows, point % rows].map(|it| it as f64 / (columns - 1) as f64);
//!         let class = if x.hypot(y) < 0.7 { Class::With } else { Class::Without };
//!         known.set(0, point, class);
//!     }
//! };
//! assert_eq!(contours(&traced, 0).len(), 1);
//! assert!(asked < lattice.points() / 5);
//! ```

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
