//! A chain of tubes as one dynamic stiffness (Eqs. 4–11).
//!
//! The paper diagonalises the transfer matrix of one pipe and joint and scales
//! its growing wave (Eq. 10). Joining stiffnesses by eliminating the shared
//! node gives the same response without eigenvectors, and N equal cells take
//! log₂ N joins; only differences of stiffnesses occur, so no number of cells
//! overflows.

use faer::c64;

use super::torsion::{DynamicStiffness, uniform};
use crate::drillstring::{Drillstring, Section, Span};

/// Stiffness of `upper` with `lower` hanging from its bottom, no torque acting
/// at the node they share.
pub fn join(upper: DynamicStiffness, lower: DynamicStiffness) -> DynamicStiffness {
    let shared = (upper.bottom + lower.top).inv();
    DynamicStiffness {
        top: upper.top - upper.cross * upper.cross * shared,
        cross: -upper.cross * lower.cross * shared,
        bottom: lower.bottom - lower.cross * lower.cross * shared,
    }
}

/// Stiffness of `count` ≥ 1 equal cells in a row, by repeated doubling.
pub fn repeated(cell: DynamicStiffness, count: usize) -> DynamicStiffness {
    let mut doubled = cell;
    let mut left = count - 1;
    let mut chain = cell;
    while left > 0 {
        if left & 1 == 1 {
            chain = join(chain, doubled);
        }
        left >>= 1;
        if left > 0 {
            doubled = join(doubled, doubled);
        }
    }
    chain
}

/// Stiffness of one section, its cells repeated, at the Laplace variable `s`.
pub fn section(string: &Drillstring, section: &Section, s: c64) -> DynamicStiffness {
    let cell = in_series(section.parts.iter().map(|part| uniform(string, part, s)));
    repeated(cell, section.repeat)
}

/// Stiffness of everything between two neighbouring nodes.
pub(crate) fn span(string: &Drillstring, span: &Span, s: c64) -> DynamicStiffness {
    in_series(span.runs.iter().map(|run| section(string, run, s)))
}

/// Joins pieces from the top down; a string has at least one.
fn in_series(pieces: impl Iterator<Item = DynamicStiffness>) -> DynamicStiffness {
    let nothing = c64::new(0.0, 0.0);
    pieces.reduce(join).unwrap_or(DynamicStiffness {
        top: nothing,
        cross: nothing,
        bottom: nothing,
    })
}
