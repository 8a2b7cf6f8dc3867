//! What a turning bit is going to do if it never stops: the torque is then known,
//! and one convolution gives every speed to come. It holds where nothing but that torque
//! acts on the string: if all these speeds are in its direction, it never stops.

use std::sync::Arc;

use linear::Complex64;
use linear::budget::REAL;
use linear::fft::{self, ComplexToReal, RealToComplex};

/// The response of a bit to its own torque, ready for one convolution with as much
/// of the past as it remembers.
#[derive(Clone)]
pub(crate) struct LookAhead {
    memory: usize,
    spectrum: Vec<Complex64>,
    /// Responses to a torque of one that lasts, and to one that grows by one a step.
    step_response: Vec<f64>,
    ramp_response: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
}

impl std::fmt::Debug for LookAhead {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("LookAhead")
            .field("memory", &self.memory)
            .finish_non_exhaustive()
    }
}

/// Numbers for each tap: its spectrum, the responses to a step and to a ramp, and the plans of two
/// transforms of any length.
const PREPARED: f64 = 40.0;

/// Numbers for each tap while one looks: torques, their spectrum, speeds.
const LOOK: f64 = 8.0;

impl LookAhead {
    /// Bytes of a response of a number of taps.
    pub(crate) fn bytes(taps: usize) -> f64 {
        REAL * PREPARED * taps as f64
    }

    /// Bytes of a look.
    pub(crate) fn look_bytes(taps: usize) -> f64 {
        REAL * LOOK * taps as f64
    }

    pub(crate) fn new(taps: &[f64]) -> Self {
        let memory = taps.len();
        // What wraps round the transform falls into the past.
        let length = 2 * memory;
        let forward = fft::forward(length);
        let inverse = fft::inverse(length);
        let mut signal = forward.make_input_vec();
        let mut spectrum = forward.make_output_vec();
        for (value, tap) in signal.iter_mut().zip(taps) {
            *value = tap / length as f64;
        }
        forward
            .process(&mut signal, &mut spectrum)
            .expect("both buffers were made by the plan");
        let step_response = running_sums(taps);
        let ramp_response = running_sums(&step_response);
        Self {
            memory,
            spectrum,
            step_response,
            ramp_response,
            forward,
            inverse,
        }
    }

    /// Steps after which a torque is forgotten.
    pub(crate) fn memory(&self) -> usize {
        self.memory
    }

    /// What the torques of the last steps, `past`, at most as many as are
    /// remembered and the last one last, and from now on `torque`, which grows by `growth` a
    /// step, add to the speed, for as many steps as are remembered.
    pub(crate) fn speeds(
        &self,
        past: impl Iterator<Item = f64>,
        torque: f64,
        growth: f64,
    ) -> Vec<f64> {
        let mut signal = self.forward.make_input_vec();
        let mut known = 0;
        for (value, torque) in signal.iter_mut().zip(past.take(self.memory)) {
            *value = torque;
            known += 1;
        }
        let mut product = self.forward.make_output_vec();
        self.forward
            .process(&mut signal, &mut product)
            .expect("both buffers were made by the plan");
        for (value, factor) in product.iter_mut().zip(&self.spectrum) {
            *value *= factor;
        }
        // Of a real signal; rounding may have left something.
        let last = product.len() - 1;
        (product[0].im, product[last].im) = (0.0, 0.0);
        self.inverse
            .process(&mut product, &mut signal)
            .expect("both buffers were made by the plan");
        let ramps = std::iter::once(&0.0).chain(&self.ramp_response);
        let to_come = signal[known..].iter().zip(&self.step_response).zip(ramps);
        to_come
            .map(|((past, step), ramp)| past + torque * step + growth * ramp)
            .collect()
    }
}

fn running_sums(values: &[f64]) -> Vec<f64> {
    let sums = values.iter().scan(0.0, |sum, value| {
        *sum += value;
        Some(*sum)
    });
    sums.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::convolution::Kernel;

    #[test]
    fn the_future_is_what_stepping_gives() {
        let taps: Vec<f64> = (0..301)
            .map(|n| ((n * n) % 17) as f64 / 17.0 - 0.4)
            .collect();
        let ahead = LookAhead::new(&taps);
        let kernel = Kernel::new(&taps);
        for known in [1usize, 150, 301, 900] {
            let mut torques: Vec<f64> = (0..known).map(|n| ((n * 7) % 23) as f64).collect();
            let past = torques[known.saturating_sub(301)..].iter().copied();
            let found = ahead.speeds(past, -2.5, 0.25);
            assert_eq!(found.len(), 301);
            for (step, found) in found.into_iter().enumerate() {
                let torque = -2.5 + 0.25 * step as f64;
                let expected = kernel.past_sum(&torques) + kernel.instant() * torque;
                assert!((found - expected).abs() < 1e-9);
                torques.push(torque);
            }
        }
    }
}
