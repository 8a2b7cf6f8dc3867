//! Measures of the torque that turns the surface.

use serde::{Deserialize, Serialize};

use crate::sampling::Sampling;

/// Torque that turns the surface, of a top drive its motor's, N m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
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
        let window = ((closing_window * sampling.frequency).round() as usize).max(1);
        let closing = &torques[torques.len().saturating_sub(window)..];
        let greatest = |torques: &[f64]| torques.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self {
            peak_torque: greatest(torques),
            least_torque: closing.iter().copied().fold(f64::INFINITY, f64::min),
            mean_torque: closing.iter().sum::<f64>() / closing.len().max(1) as f64,
            greatest_torque: greatest(closing),
        }
    }
}
