//! A chain of tubes as one dynamic stiffness (Eqs. 4–11).
//!
//! The paper diagonalises the transfer matrix of one pipe and joint and scales
//! its growing wave (Eq. 10). Joining stiffnesses by eliminating the shared
//! node gives the same response without eigenvectors, and N equal cells take
//! log₂ N joins at most; only differences of stiffnesses occur, so no number of cells
//! overflows.

use crate::drillstring::{Section, Tube};
use crate::spans::SurroundedSpan;
use crate::surroundings::Surroundings;

/// Dynamic stiffness of a piece of string between its top and its bottom.
pub trait Stiffness: Copy {
    /// Stiffness of this piece with `lower` hanging from its bottom, nothing
    /// external acting at the node they share.
    fn join(&self, lower: &Self) -> Self;

    /// Whether it is known that waves die away within this piece: its ends do not feel one
    /// another.
    fn is_endless(&self) -> bool {
        false
    }

    /// Stiffness of `count` ≥ 1 of this piece in a row: by repeated doubling, where there
    /// is no shorter way.
    fn repeated(&self, count: usize) -> Self {
        let mut doubled = *self;
        let mut left = count - 1;
        let mut chain = *self;
        while left > 0 {
            if doubled.is_endless() {
                return chain.join(&doubled);
            }
            if left & 1 == 1 {
                chain = chain.join(&doubled);
            }
            left >>= 1;
            if left > 0 {
                doubled = doubled.join(&doubled);
            }
        }
        chain
    }
}

/// Pieces that hang from one another, as [`Stiffness::join`] has them, from the top down; `None` where
/// there are none.
pub fn hung<S: Stiffness>(pieces: impl Iterator<Item = S>) -> Option<S> {
    pieces.reduce(|upper, lower| upper.join(&lower))
}

/// Which ends of a piece are of interest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// Both.
    Both,
    /// The bottom alone: what its top does to it is known once waves from there die away.
    Bottom,
}

/// Stiffness of pieces in a row, from the top down; `None` where there are none. They are made when
/// they are needed: not those from which no wave reaches an end of interest.
fn row<S: Stiffness>(mut pieces: impl DoubleEndedIterator<Item = S>, ends: Ends) -> Option<S> {
    let mut lower = pieces.next_back()?;
    while !lower.is_endless() {
        match pieces.next_back() {
            Some(upper) => lower = upper.join(&lower),
            None => return Some(lower),
        }
    }
    if ends == Ends::Bottom {
        return Some(lower);
    }
    let Some(mut upper) = pieces.next() else {
        return Some(lower);
    };
    while !upper.is_endless() {
        match pieces.next() {
            Some(next) => upper = upper.join(&next),
            None => break,
        }
    }
    Some(upper.join(&lower))
}

/// Stiffness of one section, its cells repeated, from that of its tubes, by the ends of interest.
pub fn section<S: Stiffness>(
    section: &Section,
    ends: Ends,
    tube: impl Fn(&Tube) -> S,
) -> Option<S> {
    let cell = row(section.parts.iter().map(tube), ends)?;
    Some(cell.repeated(section.repeat))
}

/// Stiffness of everything between two neighbouring nodes from that of its tubes and of what is
/// around each, by the ends of interest; `None` where there is nothing.
pub(crate) fn surrounded<S: Stiffness>(
    span: &SurroundedSpan,
    ends: Ends,
    tube: impl Fn(Surroundings, &Tube) -> S,
) -> Option<S> {
    let parts = span.iter();
    let runs = parts.flat_map(|part| part.runs.iter().map(|run| (part.around, run)));
    let pieces = runs.filter_map(|(around, run)| section(run, ends, |it| tube(around, it)));
    row(pieces, ends)
}

/// The pieces of a string between its nodes. The part that hangs from the surface is seen from
/// below: no load acts at the surface.
pub(crate) fn hanging<S: Stiffness>(
    spans: &[SurroundedSpan],
    tube: impl Fn(Surroundings, &Tube) -> S,
) -> impl Iterator<Item = Option<S>> {
    let ends = std::iter::once(Ends::Bottom).chain(std::iter::repeat(Ends::Both));
    std::iter::zip(spans, ends).map(move |(span, ends)| surrounded(span, ends, &tube))
}
