//! Pieces of a beam that are short against its waves, joined without loss.
//!
//! A short piece is many orders of magnitude stiffer than it is heavy. Its inertia, which is
//! all that a free string has to oppose to a slow force, would be lost in the rounding of
//! stiffnesses between its ends. So motion is taken apart: the bottom is carried along as
//! by a rigid piece, and bends away from that.

use num_complex::Complex64;

use super::beam_stiffness::BeamStiffness;
use super::block::Block;
use super::chain::Stiffness;
use super::nodes::Relation;
use super::number::Number;
use crate::bending::Bending;
use crate::drillstring::Tube;

/// Dynamic stiffness of a piece of beam, its bottom seen from its top.
///
/// With u = (x, x′) and f = (force, moment) at either end, and R u the motion of the bottom
/// of a rigid piece, `d = u_bottom − R u_top` is what the piece bends by. Then
/// `f_bottom = elastic d + mixed u_top`, and all that acts on the piece, its moment taken
/// about the top, is `mixedᵀ d + rigid u_top`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StiffBeam<T = Complex64> {
    /// Length, m.
    pub length: f64,
    /// By how much its waves turn from end to end, rad.
    pub turns: f64,
    /// Stiffness against bending, the top held; symmetric.
    pub elastic: Block<T>,
    /// What the bottom takes to be carried along, as by a rigid piece.
    pub mixed: Block<T>,
    /// What the whole of a rigid piece takes; symmetric.
    pub rigid: Block<T>,
}

impl<T: Number> Stiffness for StiffBeam<T> {
    /// The node that they share moves by R u_top + G⁻¹(A d + B u_top).
    fn join(&self, lower: &Self) -> Self {
        T::wide(
            #[inline(always)]
            || {
                let carried = lower.mixed.carried(self.length);
                let rigid = lower.rigid.carried(self.length);
                let bent = self.elastic + lower.rigid - lower.mixed.moved(lower.length);
                let a = lower.elastic.moved(lower.length) - lower.mixed.transpose();
                let b = carried.moved(lower.length) - self.mixed - rigid;
                let shared = (bent + a.carried(lower.length)).inverse();
                let along = shared * b;
                let joined = lower.mixed + a.transpose() * (shared * bent);
                Self {
                    length: self.length + lower.length,
                    turns: self.turns + lower.turns,
                    elastic: joined.carried(-lower.length),
                    mixed: carried - a.transpose() * along,
                    rigid: self.rigid + rigid.moved(self.length) - b.transpose() * along,
                }
            },
        )
    }
}

impl<T: Number> StiffBeam<T> {
    /// Stiffness and inertia multiplied by a number.
    pub fn multiplied(self, by: T) -> Self {
        Self {
            elastic: self.elastic.multiplied(by),
            mixed: self.mixed.multiplied(by),
            rigid: self.rigid.multiplied(by),
            ..self
        }
    }

    /// The same between its ends.
    pub fn between_ends(&self) -> BeamStiffness<T> {
        BeamStiffness {
            top: self.rigid
                - self.mixed.moved(self.length)
                - self.mixed.transpose().carried(self.length)
                + self.elastic.carried(self.length).moved(self.length),
            cross: self.mixed.transpose() - self.elastic.moved(self.length),
            bottom: self.elastic,
        }
    }

    /// This below a piece that may be long. Their node moves as the bottom would without the
    /// bending `d = shared (crossᵀ u_top + b u_bottom)`.
    pub fn below(&self, upper: &BeamStiffness<T>) -> BeamStiffness<T> {
        T::wide(
            #[inline(always)]
            || {
                let back = -self.length;
                let mixed = self.mixed.carried(back);
                let b = (upper.bottom + self.rigid - self.mixed.moved(self.length)).carried(back);
                let shared =
                    (self.elastic.moved(self.length) + b - self.mixed.transpose()).inverse();
                let bent = self.elastic - mixed;
                let along = shared * upper.cross.transpose();
                BeamStiffness {
                    top: upper.top - upper.cross.carried(back) * along,
                    cross: (bent * along).transpose(),
                    bottom: mixed + bent * (shared * b),
                }
            },
        )
    }

    /// The motion of the bottom, which meets a stiffness, by that of the top: that of a rigid
    /// piece, and what it bends by.
    pub fn carried(&self, below: Block<T>) -> Block<T> {
        T::wide(
            #[inline(always)]
            || {
                let (zero, one) = (T::zero(), T::real(1.0));
                let rigid = Block([[one, T::real(self.length)], [zero, one]]);
                let load = self.mixed + below.carried(self.length);
                rigid - (self.elastic + below).inverse() * load
            },
        )
    }

    /// This above a piece that may be long. It bends by `−shared (b u_top + cross u_bottom)`.
    pub fn above(&self, lower: &BeamStiffness<T>) -> BeamStiffness<T> {
        T::wide(
            #[inline(always)]
            || {
                let top = lower.top.carried(self.length);
                let b = self.mixed + top;
                let shared = (self.elastic + lower.top).inverse();
                let along = shared * lower.cross;
                BeamStiffness {
                    top: self.rigid + top.moved(self.length) - b.transpose() * (shared * b),
                    cross: lower.cross.moved(self.length) - b.transpose() * along,
                    bottom: lower.bottom - lower.cross.transpose() * along,
                }
            },
        )
    }
}

/// By how much waves turn along a tube that per metre takes the force `q` (N/m²) for each
/// metre that it moves (Eq. 20: its inertia and damping), rad; at several frequencies the
/// most.
pub fn turns(bending: &Bending, tube: &Tube, q: impl Number) -> f64 {
    let rigidity = bending.youngs_modulus * tube.second_moment();
    let square = q.squares().fold(0.0, f64::max);
    let by_inertia = (square.sqrt() / rigidity).sqrt().sqrt();
    let by_compression = (bending.compression.abs() / rigidity).sqrt();
    by_inertia.max(by_compression) * tube.length
}
