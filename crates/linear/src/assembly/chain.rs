//! A chain of tubes as one dynamic stiffness (Eqs. 4–11).
//!
//! The paper diagonalises the transfer matrix of one pipe and joint and scales
//! its growing wave (Eq. 10). Joining stiffnesses by eliminating the shared
//! node gives the same response without eigenvectors, and N equal cells take
//! log₂ N joins at most; only differences of stiffnesses occur, so no number of cells
//! overflows.

use crate::drillstring::{Section, Tube};
use crate::spans::{Span, Surrounded, SurroundedSpan};
use crate::surroundings::Surroundings;

/// Dynamic stiffness of a piece of string between its top and its bottom.
pub trait Stiffness: Copy {
    /// Stiffness of this piece with `lower` hanging from its bottom, nothing
    /// external acting at the node they share.
    fn join(self, lower: Self) -> Self;

    /// Whether it is known that waves die away within this piece: its ends do not feel one
    /// another.
    fn is_endless(&self) -> bool {
        false
    }

    /// Stiffness of `count` ≥ 1 of this piece in a row: by repeated doubling, where there
    /// is no shorter way.
    fn repeated(self, count: usize) -> Self {
        let mut doubled = self;
        let mut left = count - 1;
        let mut chain = self;
        while left > 0 {
            if doubled.is_endless() {
                return chain.join(doubled);
            }
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
}

/// Stiffness of one section, its cells repeated, from that of its tubes.
pub fn section<S: Stiffness>(section: &Section, tube: impl Fn(&Tube) -> S) -> Option<S> {
    let cell = section.parts.iter().map(tube).reduce(S::join)?;
    Some(cell.repeated(section.repeat))
}

/// Stiffness of everything between two neighbouring nodes; `None` where there
/// is nothing.
pub(crate) fn span<S: Stiffness>(span: &Span, tube: impl Fn(&Tube) -> S) -> Option<S> {
    of_runs(&span.runs, tube)
}

/// The same from that of its tubes and of what is around each.
pub(crate) fn surrounded<S: Stiffness>(
    span: &SurroundedSpan,
    tube: impl Fn(Surroundings, &Tube) -> S,
) -> Option<S> {
    let part = |part: &Surrounded| of_runs(&part.runs, |it| tube(part.around, it));
    span.iter().filter_map(part).reduce(S::join)
}

fn of_runs<S: Stiffness>(runs: &[Section], tube: impl Fn(&Tube) -> S) -> Option<S> {
    let pieces = runs.iter().filter_map(|run| section(run, &tube));
    pieces.reduce(S::join)
}
