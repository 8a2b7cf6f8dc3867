//! The top drive: a motor with inertia that a controller holds at a set speed. To the string it
//! is a linear termination, one more impedance.

use num_complex::Complex64;

use crate::error::DrillstringError;

/// A top drive under proportional and integral control: with e the set speed less its own, its
/// motor turns it with the torque K_p e + K_i ∫ e dt. None of its numbers being negative, it
/// takes energy and never gives any but for its set speed, so that no string is unstable
/// under it; but one that answers to a speed measured some time ago gives some at high frequencies
/// ([`crate::drive_delay`]). Presets are in [`crate::controllers`].
///
/// ```
/// use linear::{Complex64, TopDrive};
///
/// let drive = TopDrive { inertia: 2000.0, proportional_gain: 300.0, integral_gain: 80.0, delay: 0.0, late_inertia: 0.0 };
/// // Inertia and integral gain oppose one another: at √(K_i/J) only K_p is left.
/// let rate = (80.0f64 / 2000.0).sqrt();
/// let impedance = drive.impedance(Complex64::new(0.0, rate));
/// assert!((impedance - 300.0).norm() < 1e-10);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopDrive {
    /// Moment of inertia of what turns with the string's upper end, seen from there (rotor and
    /// gears included), less what the controller makes up for, kg m².
    pub inertia: f64,
    /// Proportional gain K_p, N m s/rad.
    pub proportional_gain: f64,
    /// Integral gain K_i, N m/rad.
    pub integral_gain: f64,
    /// How long ago the speed was measured that the controller answers to, τ, s. The set speed it
    /// knows at once.
    pub delay: f64,
    /// Inertia that the controller makes up for by the acceleration that it measured as long ago, kg m²; it
    /// plays no part without a delay.
    pub late_inertia: f64,
}

impl TopDrive {
    /// Checks that such a drive is possible.
    pub(crate) fn check(&self) -> Result<(), DrillstringError> {
        let numbers = [
            ("inertia", self.inertia),
            ("proportional gain", self.proportional_gain),
            ("integral gain", self.integral_gain),
            ("delay", self.delay),
            ("late inertia", self.late_inertia),
        ];
        for (quantity, value) in numbers {
            if !(value.is_finite() && value >= 0.0) {
                return Err(DrillstringError::TopDrive { quantity, value });
            }
        }
        if self.proportional_gain + self.integral_gain == 0.0 {
            return Err(DrillstringError::NoControl);
        }
        Ok(())
    }

    /// Torque per speed that it opposes at the Laplace variable s (rad/s):
    /// s J + s J_l (1 − e^(−s τ)) + (K_p + K_i/s) e^(−s τ), J_l the late inertia.
    pub fn impedance(&self, s: Complex64) -> Complex64 {
        if self.delay == 0.0 {
            return s * self.inertia + self.proportional_gain + self.integral_gain / s;
        }
        let controlled = self.integral_gain / s + self.proportional_gain;
        let late = (-self.delay * s).exp();
        s * (self.inertia + self.late_inertia * (1.0 - late)) + controlled * late
    }
}
