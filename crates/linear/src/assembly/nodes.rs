//! Nodes in a row, each hanging from the one above: how all of them answer loads at each
//! (Eqs. 44–48 and 55–58), by what all that is above a node, and all that is below, has to
//! oppose to it.

use std::ops::{Add, Mul, Neg, Sub};

/// What relates motions and loads at a node: a number in torsion, a block in bending.
pub trait Relation:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// Nothing.
    fn zero() -> Self;

    /// The motions of these loads, or the loads of these motions.
    fn inverse(self) -> Self;

    /// The other way round.
    fn transpose(self) -> Self;
}

/// Dynamic stiffness of a piece of string between its two ends: with loads f and motions u,
/// `[f_top; f_bottom] = [[top, cross], [crossᵀ, bottom]] [u_top; u_bottom]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece<K> {
    /// Driving-point stiffness at the top.
    pub top: K,
    /// Transfer stiffness from the motion of the bottom to the load on the top; its transpose
    /// is the other direction's (reciprocity).
    pub cross: K,
    /// Driving-point stiffness at the bottom.
    pub bottom: K,
}

impl<K: Relation> Piece<K> {
    /// No piece: nodes that do not feel one another.
    pub fn none() -> Self {
        Self {
            top: K::zero(),
            cross: K::zero(),
            bottom: K::zero(),
        }
    }

    /// This piece with `lower` hanging from its bottom, no load acting on the node that they
    /// share.
    pub fn joined(self, lower: Self) -> Self {
        let shared = (self.bottom + lower.top).inverse();
        let (upward, downward) = (self.cross * shared, shared * lower.cross);
        Self {
            top: self.top - upward * self.cross.transpose(),
            cross: -(self.cross * downward),
            bottom: lower.bottom - lower.cross.transpose() * downward,
        }
    }
}

/// Nodes in a row.
#[derive(Debug, Clone)]
pub struct Nodes<K> {
    /// The motion of each by a load at itself.
    own: Vec<K>,
    /// The motion of each by that of the node above, no load acting from it down; of the
    /// first, nothing.
    carried: Vec<K>,
}

impl<K: Relation> Nodes<K> {
    /// A node that `above` holds, and those below it, each by a piece.
    pub fn new(above: K, pieces: &[Piece<K>]) -> Self {
        let mut carried = vec![K::zero(); pieces.len() + 1];
        let mut below = vec![K::zero(); pieces.len() + 1];
        for (node, piece) in pieces.iter().enumerate().rev() {
            let answer = (piece.bottom + below[node + 1]).inverse();
            carried[node + 1] = -(answer * piece.cross.transpose());
            below[node] = piece.top + piece.cross * carried[node + 1];
        }
        let mut above = above;
        let mut own = vec![(above + below[0]).inverse()];
        for (piece, below) in pieces.iter().zip(&below[1..]) {
            let carried = (above + piece.top).inverse() * piece.cross;
            above = piece.bottom - piece.cross.transpose() * carried;
            own.push((above + *below).inverse());
        }
        Self { own, carried }
    }

    /// Motions by a load at a node, of that node and of those below it.
    pub fn moved_by_load(&self, node: usize) -> impl Iterator<Item = K> {
        self.carried_from(node, self.own[node])
    }

    /// Motions of a node and of those below it, where no load acts below it.
    pub fn carried_from(&self, node: usize, motion: K) -> impl Iterator<Item = K> {
        let below = self.carried[node + 1..].iter();
        let further = below.scan(motion, |motion, carried| {
            *motion = *carried * *motion;
            Some(*motion)
        });
        std::iter::once(motion).chain(further)
    }
}
