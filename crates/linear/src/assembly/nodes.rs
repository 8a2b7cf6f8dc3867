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
    /// This piece with `lower` hanging from its bottom, no load acting on the node that they
    /// share.
    #[inline(always)]
    pub fn joined(&self, lower: &Self) -> Self {
        let shared = (self.bottom + lower.top).inverse();
        let (upward, downward) = (self.cross * shared, shared * lower.cross);
        Self {
            top: self.top - upward * self.cross.transpose(),
            cross: -(self.cross * downward),
            bottom: lower.bottom - lower.cross.transpose() * downward,
        }
    }
}

/// What hangs between two nodes.
pub trait StiffnessBetween<K> {
    /// The stiffness at its bottom, when its top meets a stiffness.
    fn below(&self, above: K) -> K;

    /// The stiffness at its top, when its bottom meets a stiffness.
    fn above(&self, below: K) -> K;

    /// The motion of its bottom, which meets a stiffness, by that of its top.
    fn carried(&self, below: K) -> K;
}

impl<K: Relation> StiffnessBetween<K> for Piece<K> {
    fn below(&self, above: K) -> K {
        self.bottom - self.cross.transpose() * ((above + self.top).inverse() * self.cross)
    }

    fn above(&self, below: K) -> K {
        self.top + self.cross * self.carried(below)
    }

    fn carried(&self, below: K) -> K {
        -((self.bottom + below).inverse() * self.cross.transpose())
    }
}

/// Nodes that nothing is between do not feel one another.
impl<K: Relation, L: StiffnessBetween<K>> StiffnessBetween<K> for Option<L> {
    fn below(&self, above: K) -> K {
        self.as_ref().map_or(K::zero(), |link| link.below(above))
    }

    fn above(&self, below: K) -> K {
        self.as_ref().map_or(K::zero(), |link| link.above(below))
    }

    fn carried(&self, below: K) -> K {
        self.as_ref().map_or(K::zero(), |link| link.carried(below))
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
    /// What all that is above each has to oppose to it, and all that is below.
    above: Vec<K>,
    below: Vec<K>,
}

impl<K: Relation> Nodes<K> {
    /// A node that `above` holds, and those below it, each hanging from the last.
    pub fn new(above: K, links: &[impl StiffnessBetween<K>]) -> Self {
        Self::held(above, links, |_| K::zero())
    }

    /// The same where something else holds each node with a stiffness.
    pub fn held(above: K, links: &[impl StiffnessBetween<K>], by: impl Fn(usize) -> K) -> Self {
        let mut carried = vec![K::zero(); links.len() + 1];
        let mut below = vec![K::zero(); links.len() + 1];
        for (node, link) in links.iter().enumerate().rev() {
            // What is below a node, and what holds it.
            let met = below[node + 1] + by(node + 1);
            carried[node + 1] = link.carried(met);
            below[node] = link.above(met);
        }
        let mut all_above = vec![above];
        let mut above = above + by(0);
        let mut own = vec![(above + below[0]).inverse()];
        for (node, (link, below)) in links.iter().zip(&below[1..]).enumerate() {
            let hangs_from = link.below(above);
            above = hangs_from + by(node + 1);
            own.push((above + *below).inverse());
            all_above.push(hangs_from);
        }
        Self {
            own,
            carried,
            above: all_above,
            below,
        }
    }

    /// What all that is above a node has to oppose to it, without what holds it.
    pub fn above(&self, node: usize) -> K {
        self.above[node]
    }

    /// The same of all that is below it.
    pub fn below(&self, node: usize) -> K {
        self.below[node]
    }

    /// The motion of a node by a load at itself.
    pub fn own(&self, node: usize) -> K {
        self.own[node]
    }

    /// The motion of a node, not the first, by that of the node above, no load acting from it down.
    pub fn carried(&self, node: usize) -> K {
        self.carried[node]
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
