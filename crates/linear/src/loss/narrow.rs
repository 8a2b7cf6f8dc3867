//! The drag on a tube that moves slowly across a narrow hole: where waves of vorticity are longer
//! than the hole is wide, the differences between Bessel functions in [`super::mud`] are small, and
//! are summed term by term instead.
//!
//! Logarithms cancel but for ln(R_h/R), which leaves a ratio of power series in s.

use std::f64::consts::PI;

use num_complex::Complex64;

/// The series serve up to this κR_h.
pub(super) const WIDEST: f64 = 2.0;

/// Far beyond rounding, of powers of up to (WIDEST/2)² over squares of factorials.
const TERMS: u32 = 24;

/// Force per length, speed and viscosity on a tube between these radii, its own and the hole's (m),
/// where vorticity has the wavenumber κ (1/m). With a = α²/4, q = (R_h/R)² and L = ln(R_h/R), and the
/// four differences of the general formula in parts of powers of a.
pub(super) fn against_moving(kappa: Complex64, [outer, hole]: [f64; 2]) -> Complex64 {
    let alpha = kappa * outer;
    let a = alpha * alpha * 0.25;
    let wider = (hole - outer) * (hole + outer) / outer.powi(2);
    let logarithm = 0.5 * wider.ln_1p();
    let Sums {
        i0,
        i2,
        k2,
        i0_grows,
        i2_grows,
        k0_falls,
        k2_falls,
    } = sums(a, wider);
    let a_squared = a * a;
    let falls = k2_falls + a * i2 * (4.0 * logarithm) + 2.0 * wider;
    let along = i0 * logarithm + k0_falls;
    let doublet =
        a * falls * i2 + i2_grows * ((-a + 1.0) * 0.5 + a_squared * (i2 * logarithm + k2 * 0.25));
    let between = i2_grows * along - falls * i0_grows;
    (2.0 * doublet / between - a) * (4.0 * PI)
}

/// Power series at the tube (in a), and how they change to the hole (in qa).
struct Sums {
    /// I₀.
    i0: Complex64,
    /// I₂/a.
    i2: Complex64,
    /// What K₂'s series adds to its logarithm and its first two terms, z²K₂/a².
    k2: Complex64,
    /// The change of I₀, over a.
    i0_grows: Complex64,
    /// That of z²I₂, over a².
    i2_grows: Complex64,
    /// That of K₀'s series, negated.
    k0_falls: Complex64,
    /// That of z²K₂'s, negated, over a.
    k2_falls: Complex64,
}

fn sums(a: Complex64, wider: f64) -> Sums {
    let zero = Complex64::ZERO;
    let (mut i0, mut i2, mut k2) = (zero, zero, zero);
    let (mut i0_grows, mut i2_grows, mut k0_falls, mut k2_falls) = (zero, zero, zero, zero);
    // aᵐ/(m!)², H_m, and qᵐ − 1.
    let (mut term, mut harmonic, mut power) = (Complex64::ONE, 0.0, 0.0);
    for m in 0..TERMS {
        let m = f64::from(m);
        let [next, after] = [m + 1.0, m + 2.0];
        let next_power = power + wider + power * wider;
        let after_power = next_power + wider + next_power * wider;
        // Of order two: aᵐ/(m!(m + 2)!).
        let second = term / (next * after);
        let harmonics = 2.0 * harmonic + next.recip() + after.recip();
        i0 += term;
        i2 += second;
        k2 += second * (2.0 * harmonics);
        i0_grows += term * (next_power / (next * next));
        i2_grows += second * (4.0 * after_power);
        k0_falls -= term * (harmonic * power);
        k2_falls -= a * second * (2.0 * harmonics * after_power);
        term *= a / (next * next);
        harmonic += next.recip();
        power = next_power;
    }
    Sums {
        i0,
        i2,
        k2,
        i0_grows,
        i2_grows,
        k0_falls,
        k2_falls,
    }
}
