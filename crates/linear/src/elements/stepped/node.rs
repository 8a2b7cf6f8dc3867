//! The motion of one node of a chain.

use super::blocks::Values;
use crate::elements::newmark::Weights;

/// Displacement and velocity as predicted, and acceleration.
#[derive(Debug, Clone, Copy)]
pub(super) struct NodeMotion<const D: usize, const P: usize> {
    pub(super) displacement: Values<D, P>,
    pub(super) velocity: Values<D, P>,
    /// Before it is found, what is known of the force.
    pub(super) acceleration: Values<D, P>,
}

impl<const D: usize, const P: usize> NodeMotion<D, P> {
    /// Displacement and velocity of the step, all its loads applied.
    pub(super) fn now(&self, weights: &Weights) -> (Values<D, P>, Values<D, P>) {
        let [mut displacement, mut velocity] = [self.displacement, self.velocity];
        for freedom in 0..D {
            for plane in 0..P {
                let acceleration = self.acceleration[freedom][plane];
                displacement[freedom][plane] += weights.displacement_gain() * acceleration;
                velocity[freedom][plane] += weights.velocity_gain() * acceleration;
            }
        }
        (displacement, velocity)
    }

    /// Proceeds to the next step, of which no force is known yet.
    #[inline(always)]
    pub(super) fn predict(&mut self, weights: &Weights) {
        let step = weights.step;
        let gain = (0.5 + weights.gamma) * step * step;
        for freedom in 0..D {
            for plane in 0..P {
                let acceleration = self.acceleration[freedom][plane];
                let velocity = self.velocity[freedom][plane];
                self.displacement[freedom][plane] += step * velocity + gain * acceleration;
                self.velocity[freedom][plane] = velocity + step * acceleration;
                self.acceleration[freedom][plane] = 0.0;
            }
        }
    }
}
