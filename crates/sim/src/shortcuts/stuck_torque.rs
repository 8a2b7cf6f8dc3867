//! The torque of a bit that never slips, per unit of surface speed. It holds where
//! nothing but that torque acts on the string.
//!
//! Until the first slip every case of a string is this one series times its
//! surface speed, so that the first slip is looked up and not stepped to. After
//! it, only the difference d = T − ΩT₁ between the torque T and this one drives
//! the bit: the stuck torque T₁ and the surface together leave it at rest, so
//! that θ̇(k) = Σ A(k − n) d(n) over the steps since the slip.

use linear::budget::REAL;

use crate::convolution::{Convolution, Kernels};

/// T₁ for as long as any case lasts.
#[derive(Debug, Clone)]
pub(crate) struct StuckTorque {
    /// T₁ of each step, N m per rad/s.
    torques: Vec<f64>,
    /// The largest |T₁| up to each step.
    largest: Vec<f64>,
}

impl StuckTorque {
    /// Bytes for a number of steps.
    pub(crate) fn bytes(steps: f64) -> f64 {
        2.0 * REAL * steps
    }

    /// Holds a bit with the given driving-point response against a surface that
    /// starts to turn at 1 rad/s; `surface(step)` is what that does to the speed
    /// of a free bit.
    pub(crate) fn new(kernels: &Kernels, surface: impl Fn(usize) -> f64, steps: usize) -> Self {
        let mut convolution = Convolution::new(kernels, 1, steps);
        let mut torques = Vec::with_capacity(steps);
        for step in 0..steps {
            let mut past = [0.0];
            convolution.write_past(&mut past);
            let torque = -(surface(step) + past[0]) / kernels.instant(0, 0);
            convolution.add(&[torque]);
            torques.push(torque);
        }
        let largest = torques.iter().scan(0.0, |largest: &mut f64, torque| {
            // What is not a number holds nothing.
            let size = torque.abs();
            *largest = if size.is_nan() {
                f64::INFINITY
            } else {
                largest.max(size)
            };
            Some(*largest)
        });
        Self {
            largest: largest.collect(),
            torques,
        }
    }

    /// T₁ of all steps.
    pub(crate) fn torques(&self) -> &[f64] {
        &self.torques
    }

    /// The first step at which a bit that holds `torque_static` slips at a
    /// surface speed, or the number of steps if it never does.
    pub(crate) fn first_slip(&self, surface_speed: f64, torque_static: f64) -> usize {
        self.largest
            .partition_point(|largest| surface_speed.abs() * largest <= torque_static)
    }
}
