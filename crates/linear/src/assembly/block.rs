//! Two-by-two complex matrices: the relation between displacement and slope,
//! force and moment, at one node.

use std::ops::{Add, Mul, Neg, Sub};

use num_complex::Complex64;

use super::nodes::Relation;
use super::number::Number;

/// Rows of a two-by-two matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block<T = Complex64>(pub [[T; 2]; 2]);

impl<T: Number> Block<T> {
    /// Every entry multiplied by a number.
    #[inline(always)]
    pub fn multiplied(self, by: T) -> Self {
        self.zip(self, |a, _| a * by)
    }

    /// M R of this M, R the motion of the bottom of a rigid piece by that of its top.
    #[inline(always)]
    pub fn carried(self, length: f64) -> Self {
        let [[a, b], [c, d]] = self.0;
        Block([[a, b + a * length], [c, d + c * length]])
    }

    /// Rᵀ M: moments taken about the top of a rigid piece.
    #[inline(always)]
    pub fn moved(self, length: f64) -> Self {
        let [[a, b], [c, d]] = self.0;
        Block([[a, b], [c + a * length, d + b * length]])
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        let ([[a, b], [c, d]], [[e, g], [h, i]]) = (self.0, other.0);
        Block([[f(a, e), f(b, g)], [f(c, h), f(d, i)]])
    }
}

impl<T: Number> Relation for Block<T> {
    #[inline(always)]
    fn zero() -> Self {
        Block([[T::zero(); 2]; 2])
    }

    #[inline(always)]
    fn inverse(self) -> Self {
        let [[a, b], [c, d]] = self.0;
        let scale = (a * d - b * c).inverse();
        let minus = -scale;
        Block([[d * scale, b * minus], [c * minus, a * scale]])
    }

    #[inline(always)]
    fn transpose(self) -> Self {
        let [[a, b], [c, d]] = self.0;
        Block([[a, c], [b, d]])
    }
}

impl<T: Number> Add for Block<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<T: Number> Sub for Block<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<T: Number> Neg for Block<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.zip(self, |a, _| -a)
    }
}

impl<T: Number> Mul for Block<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let ([[a, b], [c, d]], [[e, f], [g, h]]) = (self.0, other.0);
        Block([
            [a * e + b * g, a * f + b * h],
            [c * e + d * g, c * f + d * h],
        ])
    }
}
