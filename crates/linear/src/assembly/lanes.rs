//! Complex numbers side by side, so that the processor works on several at a time.
//!
//! A stiffness is a long chain of operations that wait for one another. Those of other
//! frequencies do not, and fill the gaps.

use std::ops::{Add, Mul, Neg, Sub};

use num_complex::Complex64;

use super::nodes::Relation;
use super::number::{Number, root};

/// Complex numbers at several frequencies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LanesOf<const COUNT: usize> {
    re: [f64; COUNT],
    im: [f64; COUNT],
}

/// Complex numbers at four frequencies. Bending is cut for all lanes together (`waves::bending`): with
/// more, its last digits would be others.
pub type Lanes = LanesOf<4>;

/// Complex numbers at eight frequencies, as fill the gaps in torsion, where few numbers are at work at a
/// time.
pub type ManyLanes = LanesOf<8>;

/// Real and imaginary parts of each lane from those of two operands.
#[inline(always)]
fn zip<const COUNT: usize>(
    one: LanesOf<COUNT>,
    other: LanesOf<COUNT>,
    f: impl Fn([f64; 2], [f64; 2]) -> [f64; 2],
) -> LanesOf<COUNT> {
    let (mut re, mut im) = ([0.0; COUNT], [0.0; COUNT]);
    for lane in 0..COUNT {
        [re[lane], im[lane]] = f(
            [one.re[lane], one.im[lane]],
            [other.re[lane], other.im[lane]],
        );
    }
    LanesOf { re, im }
}

/// The same of one operand.
#[inline(always)]
fn map<const COUNT: usize>(
    one: LanesOf<COUNT>,
    f: impl Fn([f64; 2]) -> [f64; 2],
) -> LanesOf<COUNT> {
    zip(one, one, |one, _| f(one))
}

impl<const COUNT: usize> Add for LanesOf<COUNT> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        zip(self, other, |[a, b], [c, d]| [a + c, b + d])
    }
}

impl<const COUNT: usize> Sub for LanesOf<COUNT> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        zip(self, other, |[a, b], [c, d]| [a - c, b - d])
    }
}

impl<const COUNT: usize> Mul for LanesOf<COUNT> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        zip(self, other, |[a, b], [c, d]| [a * c - b * d, a * d + b * c])
    }
}

impl<const COUNT: usize> Neg for LanesOf<COUNT> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        map(self, |[a, b]| [-a, -b])
    }
}

impl<const COUNT: usize> Add<f64> for LanesOf<COUNT> {
    type Output = Self;
    #[inline(always)]
    fn add(self, real: f64) -> Self {
        map(self, |[a, b]| [a + real, b])
    }
}

impl<const COUNT: usize> Sub<f64> for LanesOf<COUNT> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, real: f64) -> Self {
        map(self, |[a, b]| [a - real, b])
    }
}

impl<const COUNT: usize> Mul<f64> for LanesOf<COUNT> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, real: f64) -> Self {
        map(self, |[a, b]| [a * real, b * real])
    }
}

impl<const COUNT: usize> Relation for LanesOf<COUNT> {
    #[inline(always)]
    fn zero() -> Self {
        Self::real(0.0)
    }

    #[inline(always)]
    fn inverse(self) -> Self {
        map(self, |[a, b]| {
            let square = a * a + b * b;
            [a / square, -b / square]
        })
    }

    #[inline(always)]
    fn transpose(self) -> Self {
        self
    }
}

impl<const COUNT: usize> Number for LanesOf<COUNT> {
    const LANES: usize = COUNT;

    #[inline(always)]
    fn wide<R>(work: impl FnOnce() -> R) -> R {
        pulp::Arch::new().dispatch(work)
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> Complex64 {
        Complex64::new(self.re[lane], self.im[lane])
    }

    #[inline(always)]
    fn of_lanes(mut number: impl FnMut(usize) -> Complex64) -> Self {
        let numbers: [Complex64; COUNT] = std::array::from_fn(&mut number);
        Self {
            re: numbers.map(|z| z.re),
            im: numbers.map(|z| z.im),
        }
    }

    #[inline(always)]
    fn real(value: f64) -> Self {
        Self {
            re: [value; COUNT],
            im: [0.0; COUNT],
        }
    }

    #[inline(always)]
    fn root(self) -> Self {
        map(self, |[a, b]| root(a, b).into())
    }

    #[inline(always)]
    fn towards(self, other: Self) -> Self {
        zip(self, other, |[a, b], [c, d]| {
            let sign = 1f64.copysign(a * c + b * d);
            [a * sign, b * sign]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COUNT: usize = Lanes::LANES;
    use crate::assembly::chain::Stiffness;
    use crate::assembly::torsion::DynamicStiffness;

    /// By the widest instructions and by any, to the bit.
    #[test]
    fn rows_in_lanes_are_those_of_each() {
        let number = |lane: usize| Complex64::new(0.1 + lane as f64, (3.7 * lane as f64).cos());
        let alike = ManyLanes::of_lanes(number);
        let opposite = alike.inverse() + 0.3;
        for pieces in [1, 2, 5, 300] {
            let lanes = ManyLanes::wide(
                #[inline(always)]
                || DynamicStiffness::row(alike, opposite, pieces).repeated(3),
            );
            for lane in 0..ManyLanes::LANES {
                let (alike, opposite) = (alike.lane(lane), opposite.lane(lane));
                let alone = DynamicStiffness::row(alike, opposite, pieces).repeated(3);
                assert_eq!(lanes.top.lane(lane), alone.top);
                assert_eq!(lanes.cross.lane(lane), alone.cross);
                assert_eq!(lanes.bottom.lane(lane), alone.bottom);
            }
        }
    }

    /// Every operation is that of the numbers alone, to the bit.
    #[test]
    fn lanes_do_not_know_of_one_another() {
        let numbers = |seed: u32| -> [Complex64; COUNT] {
            std::array::from_fn(|lane| {
                let angle = f64::from(seed * 7 + lane as u32 * 3);
                Complex64::new(angle.sin(), (1.7 * angle).cos())
            })
        };
        let (one, other) = (numbers(1), numbers(2));
        let (ones, others) = (Lanes::of_lanes(|i| one[i]), Lanes::of_lanes(|i| other[i]));
        let found = [
            ones + others,
            ones - others,
            ones * others,
            -ones,
            ones + 3.0,
            ones - 3.0,
            ones * 3.0,
            ones.inverse(),
            ones.root(),
            ones.towards(others),
            ones.each(|z| z.exp()),
            Lanes::real(2.0),
        ];
        for lane in 0..COUNT {
            let (a, b) = (one[lane], other[lane]);
            let alone = [
                a + b,
                a - b,
                a * b,
                -a,
                a + 3.0,
                a - 3.0,
                a * 3.0,
                a.inverse(),
                a.root(),
                a.towards(b),
                a.exp(),
                2.0.into(),
            ];
            for (found, alone) in found.iter().zip(alone) {
                assert_eq!(found.lane(lane), alone);
            }
        }
    }
}
