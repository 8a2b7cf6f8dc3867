//! Loss with a memory that fades: sums of relaxations, of weights that are not negative and real
//! rates. Each is a spring and a dashpot in series (Maxwell's element), so that no sum of them
//! gives energy back, and each is one more variable to a scheme that steps in time.

use num_complex::Complex64;

/// A weight times s/(s + rate).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relaxation {
    /// What it adds far above its rate, in the units of what it is a part of; not negative.
    pub weight: f64,
    /// Rate at which it forgets, 1/s; the pole is its negative.
    pub rate: f64,
}

impl Relaxation {
    /// At the Laplace variable s (rad/s).
    pub fn at(&self, s: Complex64) -> Complex64 {
        s * self.weight / (s + self.rate)
    }
}

/// The sum of all at the Laplace variable s (rad/s).
pub fn sum(relaxations: &[Relaxation], s: Complex64) -> Complex64 {
    relaxations.iter().map(|it| it.at(s)).sum()
}

/// The slowest rate of the ladder of a loss factor, rad/s.
const SLOWEST: f64 = std::f64::consts::TAU * 0.01;

/// Each next rate over the last: closer ones leave less of a ripple, and take more variables.
const STEP: f64 = 4.0;

/// The last is beyond this, rad/s.
const FASTEST: f64 = std::f64::consts::TAU * 2000.0;

/// The relaxations by which a material takes the same part of its energy in every cycle from
/// hundredths of a hertz to kilohertz: its moduli are multiplied by 1 + Σ a s/(s + ω), whose angle
/// is the loss factor η. Rates ω are a factor r apart, and each weight is 2η ln r/π.
///
/// A constant G(1 + iη) is not causal: the material would answer before it is loaded. This
/// is, it is at rest what it is without loss, and stiffens by about 0.9 η in each decade.
pub(super) fn ladder(loss_factor: f64) -> Vec<Relaxation> {
    let weight = 2.0 * loss_factor * STEP.ln() / std::f64::consts::PI;
    let rates = std::iter::successors(Some(SLOWEST), |rate| {
        (*rate < FASTEST).then_some(rate * STEP)
    });
    rates.map(|rate| Relaxation { weight, rate }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// To 7 % of itself, from 0.05 to 500 Hz; the ripple of a step of four is less than 1 %.
    #[test]
    fn the_angle_of_the_modulus_is_the_loss_factor() {
        let terms = ladder(1e-3);
        assert_eq!(terms.len(), 10);
        for index in 0..=400 {
            let frequency = 0.05 * 1e4f64.powf(f64::from(index) / 400.0);
            let s = Complex64::new(0.0, std::f64::consts::TAU * frequency);
            let angle = (1.0 + sum(&terms, s)).arg();
            assert!((0.93e-3..1.0e-3).contains(&angle), "{frequency}: {angle}");
        }
    }

    #[test]
    fn at_rest_nothing_is_added_and_energy_is_only_taken() {
        let terms = ladder(0.02);
        assert_eq!(sum(&terms, Complex64::ZERO), Complex64::ZERO);
        for size in -30..40 {
            for turn in -10..=10 {
                let angle = 0.05 * std::f64::consts::PI * f64::from(turn);
                let s = Complex64::from_polar(f64::from(size).exp(), angle);
                // The torque per speed of a tube of this material.
                assert!(((1.0 + sum(&terms, s)) / s).re >= 0.0, "{s}");
            }
        }
    }
}
