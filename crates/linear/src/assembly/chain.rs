//! A chain of tubes as one dynamic stiffness (Eqs. 4–11).
//!
//! The paper diagonalises the transfer matrix of one pipe and joint and scales
//! its growing wave (Eq. 10). Joining stiffnesses by eliminating the shared
//! node gives the same response without eigenvectors, and N equal cells take
//! log₂ N joins; only differences of stiffnesses occur, so no number of cells
//! overflows.

use crate::drillstring::{Section, Tube};
use crate::spans::Span;

/// Dynamic stiffness of a piece of string between its top and its bottom.
pub trait Stiffness: Copy {
    /// Stiffness of this piece with `lower` hanging from its bottom, nothing
    /// external acting at the node they share.
    fn join(self, lower: Self) -> Self;
}

/// Stiffness of `count` ≥ 1 equal cells in a row, by repeated doubling.
pub fn repeated<S: Stiffness>(cell: S, count: usize) -> S {
    let mut doubled = cell;
    let mut left = count - 1;
    let mut chain = cell;
    while left > 0 {
        if left & 1 == 1 {
            chain = chain.join(doubled);
        }
        left >>= 1;
        if left > 0 {
            doubled = doubled.join(doubled);
        }
    }
    chain
}

/// Stiffness of one section, its cells repeated, from that of its tubes.
pub fn section<S: Stiffness>(section: &Section, tube: impl Fn(&Tube) -> S) -> Option<S> {
    let cell = section.parts.iter().map(tube).reduce(S::join)?;
    Some(repeated(cell, section.repeat))
}

/// Stiffness of everything between two neighbouring nodes; `None` where there
/// is nothing.
pub(crate) fn span<S: Stiffness>(span: &Span, tube: impl Fn(&Tube) -> S) -> Option<S> {
    let pieces = span.runs.iter().filter_map(|run| section(run, &tube));
    pieces.reduce(S::join)
}
