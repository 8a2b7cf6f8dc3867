//! The top drive: a motor with inertia that a controller holds at a set speed. To the string it
//! is a linear termination, one more impedance.

use crate::assembly::number::Number;
use crate::assembly::torsion::Drive;
use crate::error::DrillstringError;
use crate::estimates::{FirstMode, first_mode, torsional_impedance};
use crate::{Complex64, Drillstring};

/// A top drive under proportional and integral control: with e the set speed less its own, its
/// motor turns it with the torque K_p e + K_i ∫ e dt. None of its numbers being negative, it
/// takes energy and never gives any but for its set speed, so that no string is unstable
/// under it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopDrive {
    /// Moment of inertia of what turns with the string's upper end, seen from there (rotor and
    /// gears included), less what the controller makes up for, kg m².
    pub inertia: f64,
    /// Proportional gain K_p, N m s/rad.
    pub proportional_gain: f64,
    /// Integral gain K_i, N m/rad.
    pub integral_gain: f64,
}

impl TopDrive {
    /// The gains that damp the first mode most (soft torque). With a string that swings as
    /// one inertia J₁ at the end of a spring, at ω₁ with the surface held, drive and string
    /// have two modes; the slower decays fastest where both are one:
    /// K_i = ω₁² J, K_p = 2 ω₁ √(J J₁), each then with the damping ratio ½ √(J₁/J).
    ///
    /// After J. D. Jansen and L. van den Steen, *Journal of Sound and Vibration* 179 (1995),
    /// 647–668; ω₁ and J₁ are those of the string's first mode ([`first_mode`]).
    pub fn soft_torque(string: &Drillstring, inertia: f64) -> Self {
        let FirstMode {
            frequency,
            inertia: of_string,
        } = first_mode(string);
        Self {
            inertia,
            proportional_gain: 2.0 * frequency * (inertia * of_string).sqrt(),
            integral_gain: frequency * frequency * inertia,
        }
    }

    /// The gain that lets waves out: K_p is the impedance J √(Gρ) of the uppermost tube, and
    /// the inertia is made up for. The integral gain keeps the mean speed; the smaller it is,
    /// the less comes back.
    pub fn impedance_matched(string: &Drillstring, integral_gain: f64) -> Self {
        let uppermost = &string.sections()[0].parts[0];
        Self {
            inertia: 0.0,
            proportional_gain: torsional_impedance(string, uppermost),
            integral_gain,
        }
    }

    /// Checks that there is such a drive.
    pub(crate) fn check(&self) -> Result<(), DrillstringError> {
        let numbers = [
            ("inertia", self.inertia),
            ("proportional gain", self.proportional_gain),
            ("integral gain", self.integral_gain),
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

    /// Torque per speed that it opposes at the Laplace variable s (rad/s): s J + K_p + K_i/s.
    pub fn impedance(&self, s: Complex64) -> Complex64 {
        s * self.inertia + self.proportional_gain + self.integral_gain / s
    }

    /// What comes back of a wave in the uppermost tube that meets it at s = iω: the ratio of
    /// speeds (Z − Z_d)/(Z + Z_d), −1 from a surface that turns as prescribed.
    pub fn reflection(&self, string: &Drillstring, angular_frequency: f64) -> Complex64 {
        let uppermost = &string.sections()[0].parts[0];
        let impedance = torsional_impedance(string, uppermost);
        let own = self.impedance(Complex64::new(0.0, angular_frequency));
        (impedance - own) / (impedance + own)
    }

    /// As the string meets it, from the acceleration, speed and rotation that belong to a unit
    /// of its motion.
    pub(crate) fn drive<T: Number>(&self, acceleration: T, speed: T, rotation: T) -> Drive<T> {
        let holds = speed * self.proportional_gain + rotation * self.integral_gain;
        Drive {
            holds,
            opposes: acceleration * self.inertia + holds,
        }
    }
}
