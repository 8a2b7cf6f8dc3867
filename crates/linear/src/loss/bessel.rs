//! Modified Bessel functions I and K of orders 0, 1 and 2 at complex numbers whose real part is
//! not negative, scaled by e^(−z) and e^z, so that no size overflows.
//!
//! Small numbers take the power series, larger ones Miller's recurrence for I and Temme's
//! continued fraction for K (N. M. Temme, "On the numerical evaluation of the modified Bessel
//! function of the third kind", *Journal of Computational Physics* 19, 1975, 324–337), the
//! largest Hankel's expansion (DLMF 10.40). A translation of Amos' general library gives the
//! same digits, of any order, in five to ten times the time; the drag of mud is evaluated at every
//! frequency that a response is sampled at, and most of these are large.

use num_complex::Complex64;

/// I₀, I₁, I₂ times e^(−z), and K₀, K₁, K₂ times e^z.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bessel {
    pub(super) i: [Complex64; 3],
    pub(super) k: [Complex64; 3],
}

/// Below this the power series.
const SMALL: f64 = 2.0;

/// From here on Hankel's expansion, whose smallest term is then far below rounding.
const LARGE: f64 = 20.0;

/// Euler's constant γ.
const EULER: f64 = 0.577_215_664_901_532_9;

/// Far more terms than any of these sums takes.
const MOST_TERMS: u32 = 200;

impl Bessel {
    /// At z, Re z ≥ 0, z ≠ 0.
    pub(super) fn at(z: Complex64) -> Self {
        let size = z.norm();
        let ([k0, k1], i) = if size < SMALL {
            let (i, k) = series(z);
            (k, i)
        } else if size < LARGE {
            (continued_fraction(z), recurrence(z))
        } else {
            let (i, k) = expansion(z);
            (k, i)
        };
        let k2 = k0 + 2.0 * k1 / z;
        Self { i, k: [k0, k1, k2] }
    }
}

/// Power series in t = z²/4 (DLMF 10.25.2 and 10.31.1).
fn series(z: Complex64) -> ([Complex64; 3], [Complex64; 2]) {
    let half = 0.5 * z;
    let t = half * half;
    // t^m/(m!)² with its sums over the orders, and over K's harmonic numbers.
    let mut term = Complex64::ONE;
    let mut i = [Complex64::ZERO; 3];
    let (mut harmonic, mut series) = (0.0, [Complex64::ZERO; 2]);
    for m in 0..MOST_TERMS {
        let m = f64::from(m);
        let next = m + 1.0;
        i[0] += term;
        i[1] += term / next;
        i[2] += term / (next * (m + 2.0));
        series[0] += term * harmonic;
        series[1] += term * ((2.0 * harmonic + next.recip()) / next);
        if term.norm_sqr() < f64::EPSILON.powi(2) {
            break;
        }
        harmonic += next.recip();
        term *= t / (next * next);
    }
    i[1] *= half;
    i[2] *= t;
    let logarithm = half.ln() + EULER;
    let k0 = series[0] - logarithm * i[0];
    let k1 = z.inv() + logarithm * i[1] - 0.5 * half * series[1];
    let (down, up) = ((-z).exp(), z.exp());
    (i.map(|i| i * down), [k0 * up, k1 * up])
}

/// I by the recurrence of its orders downwards, from where they are nothing; 1 = e^(−z)(I₀ + 2 I₁
/// + 2 I₂ + …) says how large they are.
fn recurrence(z: Complex64) -> [Complex64; 3] {
    // Orders beyond |z| fall faster and faster.
    const BEYOND: f64 = 22.0;
    const PART: f64 = 1.2;
    let first = (PART * z.norm() + BEYOND) as u32;
    let per_order = 2.0 * z.inv();
    let (mut above, mut at) = (Complex64::ZERO, Complex64::ONE);
    let (mut sum, mut i2) = (Complex64::ZERO, Complex64::ZERO);
    for order in (1..=first).rev() {
        sum += at;
        if order == 2 {
            i2 = at;
        }
        (above, at) = (at, above + per_order * f64::from(order) * at);
    }
    let scale = (at + 2.0 * sum).inv();
    [at * scale, above * scale, i2 * scale]
}

/// K₀ and K₁ by Temme's continued fraction and the sum that goes with it, evaluated forwards
/// (Steed).
fn continued_fraction(z: Complex64) -> [Complex64; 2] {
    let mut b = 2.0 * (z + 1.0);
    let mut d = b.inv();
    let mut step = d;
    let mut fraction = d;
    let (mut q_before, mut q) = (Complex64::ZERO, Complex64::ONE);
    let (mut a, mut c) = (-0.25, 0.25);
    let mut weight = Complex64::from(c);
    let mut sum = weight * step + 1.0;
    for index in 2..MOST_TERMS {
        let index = f64::from(index);
        a -= 2.0 * (index - 1.0);
        c *= -a / index;
        let next = (q_before - b * q) / a;
        (q_before, q) = (q, next);
        weight += c * q;
        b += 2.0;
        d = (b + a * d).inv();
        step *= b * d - 1.0;
        fraction += step;
        let added = weight * step;
        sum += added;
        if added.norm_sqr() < (0.5 * f64::EPSILON).powi(2) * sum.norm_sqr() {
            break;
        }
    }
    let k0 = (std::f64::consts::FRAC_PI_2 * z.inv()).sqrt() / sum;
    let k1 = k0 * (z + 0.5 - 0.25 * fraction) / z;
    [k0, k1]
}

/// Hankel's expansions, with the wave of I that dies away: on the imaginary axis both are alike.
fn expansion(z: Complex64) -> ([Complex64; 3], [Complex64; 2]) {
    let inverse = z.inv();
    let [even0, odd0] = hankel(0.0, inverse);
    let [even1, odd1] = hankel(4.0, inverse);
    let scale = (inverse / std::f64::consts::TAU).sqrt();
    let other = Complex64::I * (-2.0 * z).exp() * if z.im < 0.0 { -1.0 } else { 1.0 };
    let i0 = scale * (even0 - odd0 + other * (even0 + odd0));
    let i1 = scale * (even1 - odd1 - other * (even1 + odd1));
    let i2 = i0 - 2.0 * i1 * inverse;
    let scale = std::f64::consts::PI * scale;
    (
        [i0, i1, i2],
        [scale * (even0 + odd0), scale * (even1 + odd1)],
    )
}

/// The terms of even and of odd powers of 1/z of one order ν, of which 4ν² is given.
fn hankel(four_squared: f64, inverse: Complex64) -> [Complex64; 2] {
    let mut sums = [Complex64::ONE, Complex64::ZERO];
    let mut term = Complex64::ONE;
    for index in 1..MOST_TERMS {
        let index_real = f64::from(index);
        let odd = 2.0 * index_real - 1.0;
        term *= inverse * ((four_squared - odd * odd) / (8.0 * index_real));
        sums[index as usize % 2] += term;
        if term.norm_sqr() < (0.25 * f64::EPSILON).powi(2) {
            break;
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::super::reference;
    use super::*;

    /// Next to the imaginary axis the recurrence loses two digits. Only poles that hardly swing are
    /// looked for there.
    fn rounding(z: Complex64) -> f64 {
        if z.arg().abs() < std::f64::consts::FRAC_PI_3 {
            1e-14
        } else {
            1e-12
        }
    }

    /// In 34 digits by mpmath (`scripts/mud-drag.py`).
    #[test]
    fn bessel_functions_are_those_of_mpmath() {
        for row in reference::numbers(include_str!("reference/bessel.csv"), 0) {
            let z = Complex64::new(row[0], row[1]);
            let Bessel { i, k } = Bessel::at(z);
            for (index, found) in i.into_iter().chain(k).enumerate() {
                let exact = Complex64::new(row[2 + 2 * index], row[3 + 2 * index]);
                let error = (found - exact).norm() / exact.norm();
                assert!(error < rounding(z), "{z}, {index}: {error:e}");
            }
        }
    }

    /// z (I₀ K₁ + I₁ K₀) = 1 wherever the real part is not negative.
    #[test]
    fn the_wronskian_is_one_over_z() {
        for size in 0..600 {
            for turn in -10..=10 {
                let angle = 0.05 * std::f64::consts::PI * f64::from(turn);
                let z = Complex64::from_polar(1e-3 * (0.025 * f64::from(size)).exp(), angle);
                let Bessel { i, k } = Bessel::at(z);
                let wronskian = z * (i[0] * k[1] + i[1] * k[0]);
                assert!((wronskian - 1.0).norm() < rounding(z), "{z}: {wronskian}");
            }
        }
    }
}
