//! What stiffnesses are made of: a complex number, or several side by side.

use std::ops::{Add, Mul, Sub};

use num_complex::Complex64;

use super::nodes::Relation;

/// A complex number at one frequency, or [`super::lanes::Lanes`] of them at several. One
/// formula serves both; several are worked out in little more time than one.
pub trait Number:
    Relation + Add<f64, Output = Self> + Sub<f64, Output = Self> + Mul<f64, Output = Self>
{
    /// How many stand side by side.
    const LANES: usize;

    /// One of them.
    fn lane(&self, lane: usize) -> Complex64;

    /// Those that `number` gives for each lane.
    fn of_lanes(number: impl FnMut(usize) -> Complex64) -> Self;

    /// The result of work that is compiled for the widest instructions of the processor, where several
    /// numbers stand side by side; what the work calls has to be inlined. Numbers are the same by any
    /// instructions: nothing is added in another order.
    #[inline(always)]
    fn wide<R>(work: impl FnOnce() -> R) -> R {
        work()
    }

    /// The square root whose real part is not negative.
    fn root(self) -> Self;

    /// z or −z, whichever turns less than a right angle away from another.
    fn towards(self, other: Self) -> Self;

    /// A real number.
    fn real(value: f64) -> Self;

    /// A function of each.
    fn each(self, function: impl Fn(Complex64) -> Complex64) -> Self {
        Self::of_lanes(|lane| function(self.lane(lane)))
    }

    /// |z|² of every one.
    fn squares(&self) -> impl Iterator<Item = f64> {
        (0..Self::LANES).map(|lane| self.lane(lane).norm_sqr())
    }
}

impl Relation for Complex64 {
    fn zero() -> Self {
        Self::ZERO
    }

    fn inverse(self) -> Self {
        self.inv()
    }

    fn transpose(self) -> Self {
        self
    }
}

impl Number for Complex64 {
    const LANES: usize = 1;

    fn lane(&self, _: usize) -> Complex64 {
        *self
    }

    fn of_lanes(mut number: impl FnMut(usize) -> Complex64) -> Self {
        number(0)
    }

    fn real(value: f64) -> Self {
        value.into()
    }

    fn root(self) -> Self {
        let (re, im) = root(self.re, self.im);
        Complex64::new(re, im)
    }

    fn towards(self, other: Self) -> Self {
        if self.re * other.re + self.im * other.im < 0.0 {
            -self
        } else {
            self
        }
    }
}

/// The square root whose real part is not negative, without its angle, which takes several
/// times as long.
#[inline(always)]
pub(super) fn root(re: f64, im: f64) -> (f64, f64) {
    let norm = (re * re + im * im).sqrt();
    // The larger of both parts first: a difference would lose digits.
    let larger = (0.5 * (norm + re.abs())).sqrt();
    let smaller = if larger > 0.0 { 0.5 * im / larger } else { 0.0 };
    if re >= 0.0 {
        (larger, smaller)
    } else {
        (smaller.abs(), larger.copysign(im))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_those_of_any_number() {
        for angle in -31..=31 {
            let z = Complex64::from_polar(1e5, 0.1 * f64::from(angle));
            assert!(
                (z.root() - z.sqrt()).norm() < 1e-12 * z.sqrt().norm(),
                "{z}"
            );
        }
        for z in [Complex64::ZERO, (-4.0).into(), Complex64::new(0.0, -2.0)] {
            assert_eq!(z.root() * z.root(), z);
            assert!(z.root().re >= 0.0);
        }
    }
}
