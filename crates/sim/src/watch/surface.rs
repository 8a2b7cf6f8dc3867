//! What the torque that turns the surface comes to.

use serde::{Deserialize, Serialize};

use crate::sampling::Sampling;

/// Torque that turns the surface, of a top drive its motor's, N m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SurfaceMeasures {
    /// The greatest in all the time.
    pub peak_torque: f64,
    /// The least in the closing window.
    pub least_torque: f64,
    /// The mean over the closing window.
    pub mean_torque: f64,
    /// The greatest in the closing window.
    pub greatest_torque: f64,
}

impl SurfaceMeasures {
    /// Of a torque in every step, of which the last seconds are the closing window.
    pub(crate) fn of(torques: &[f64], sampling: Sampling, closing_window: f64) -> Self {
        let mut watch = SurfaceWatch::new(sampling, torques.len(), closing_window);
        torques.iter().for_each(|torque| watch.see(*torque));
        watch.measures()
    }
}

/// Watches the torque step by step.
#[derive(Debug, Clone)]
pub(crate) struct SurfaceWatch {
    closing_from: usize,
    step: usize,
    sum: f64,
    measures: SurfaceMeasures,
}

impl SurfaceWatch {
    pub(crate) fn new(sampling: Sampling, steps: usize, closing_window: f64) -> Self {
        let window = ((closing_window * sampling.frequency).round() as usize).min(steps);
        Self {
            closing_from: steps.saturating_sub(window.max(1)),
            step: 0,
            sum: 0.0,
            measures: SurfaceMeasures {
                peak_torque: f64::NEG_INFINITY,
                least_torque: f64::INFINITY,
                mean_torque: 0.0,
                greatest_torque: f64::NEG_INFINITY,
            },
        }
    }

    pub(crate) fn see(&mut self, torque: f64) {
        let measures = &mut self.measures;
        measures.peak_torque = measures.peak_torque.max(torque);
        if self.step >= self.closing_from {
            measures.least_torque = measures.least_torque.min(torque);
            measures.greatest_torque = measures.greatest_torque.max(torque);
            self.sum += torque;
        }
        self.step += 1;
    }

    pub(crate) fn measures(&self) -> SurfaceMeasures {
        let seen = self.step.saturating_sub(self.closing_from).max(1);
        SurfaceMeasures {
            mean_torque: self.sum / seen as f64,
            ..self.measures
        }
    }
}
