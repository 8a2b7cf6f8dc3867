//! How each method differentiates in time: the operator between the
//! displacements and the velocities of its own scheme.
//!
//! A response is stable against any wall only if its velocity is positive-real
//! in the scheme's own sense: a plain difference of displacements would lead or
//! lag by part of a step, and so misjudge what is in phase with a force.

use crate::method::Method;

/// A ratio of polynomials in the delay ζ of one step, in units of f_s:
/// `num(ζ) / den(ζ)`, with `den(0)` not zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Derivative {
    numerator: [f64; 3],
    denominator: [f64; 3],
}

impl Method {
    /// The derivative in time of this method's displacements.
    pub(crate) fn derivative(&self) -> Derivative {
        match self {
            // Displacements are running sums of velocities.
            Method::Hilbert(_) | Method::DirectIdft(_) => Derivative {
                numerator: [1.0, -1.0, 0.0],
                denominator: [1.0, 0.0, 0.0],
            },
            // δ(ζ) of BDF2.
            Method::Quadrature => Derivative {
                numerator: [1.5, -2.0, 0.5],
                denominator: [1.0, 0.0, 0.0],
            },
            // δ(ζ) of the trapezoidal rule; a displacement that is the mean of those at
            // both ends of a step has the mean speed over it.
            Method::Held | Method::Poles | Method::Trapezoidal => Derivative {
                numerator: [2.0, -2.0, 0.0],
                denominator: [1.0, 1.0, 0.0],
            },
            // Newmark's two updates, the acceleration eliminated.
            Method::FiniteElement(parameters) => {
                let (gamma, beta) = (parameters.gamma, parameters.beta());
                Derivative {
                    numerator: [gamma, 1.0 - 2.0 * gamma, gamma - 1.0],
                    denominator: [beta, 0.5 + gamma - 2.0 * beta, 0.5 - gamma + beta],
                }
            }
        }
    }
}

impl Derivative {
    /// The derivative of a series that begins at rest, in units of f_s.
    pub(crate) fn of(&self, series: &[f64]) -> Vec<f64> {
        let mut derivative: Vec<f64> = Vec::with_capacity(series.len());
        let back = |values: &[f64], end: usize, lag: usize| {
            end.checked_sub(lag).map_or(0.0, |index| values[index])
        };
        for index in 0..series.len() {
            let forward: f64 = (self.numerator.iter().enumerate())
                .map(|(lag, factor)| factor * back(series, index, lag))
                .sum();
            let fed_back: f64 = (self.denominator.iter().enumerate().skip(1))
                .map(|(lag, factor)| factor * back(&derivative, index, lag))
                .sum();
            derivative.push((forward - fed_back) / self.denominator[0]);
        }
        derivative
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::FiniteElement;

    /// Every method's derivative of a parabola tends to a straight line, after
    /// the transient of starting from rest.
    #[test]
    fn a_parabola_has_a_straight_derivative() {
        let parabola: Vec<f64> = (0..4000).map(|n| 0.5 * f64::from(n * n)).collect();
        for method in [
            Method::Quadrature,
            Method::Hilbert(Default::default()),
            Method::FiniteElement(FiniteElement::default()),
        ] {
            let derivative = method.derivative().of(&parabola);
            let slopes: Vec<f64> = derivative
                .windows(2)
                .map(|pair| pair[1] - pair[0])
                .collect();
            assert!((slopes[3998] - 1.0).abs() < 1e-6, "{}", method.name());
            assert!((derivative[3999] - 3999.0).abs() < 0.6, "{}", method.name());
        }
    }

    /// A particle under a unit force in the first step, by Newmark's updates.
    #[test]
    fn newmark_velocities_follow_from_its_displacements() {
        let parameters = FiniteElement::default();
        let (gamma, beta) = (parameters.gamma, parameters.beta());
        // Step length and mass one: acceleration is force.
        let (mut displacement, mut velocity, mut acceleration) = (0.0, 0.0, 0.0);
        let (mut displacements, mut velocities) = (Vec::new(), Vec::new());
        for step in 0..50 {
            let next = f64::from(step % 7 == 0);
            displacement += velocity + (0.5 - beta) * acceleration + beta * next;
            velocity += (1.0 - gamma) * acceleration + gamma * next;
            acceleration = next;
            displacements.push(displacement);
            velocities.push(velocity);
        }
        let found = Method::FiniteElement(parameters)
            .derivative()
            .of(&displacements);
        for (found, expected) in found.iter().zip(&velocities) {
            assert!((found - expected).abs() < 1e-10 * velocity);
        }
    }
}
