//! A mud motor (positive displacement) between string and bit: mud that is pumped through it turns
//! its rotor against the housing, on which the string ends.
//!
//! The bit turns faster than the string above it, ω = ω_s + r(T), T the torque that the motor
//! passes on. By its chart, r falls from the speed without load by the slip per torque, up to the
//! stall torque; there mud leaks by, and the rotor stops, r = 0, at any torque beyond. Within a
//! step, the string leaves ω_s = ω_h − A T, and the rotor, with all below it, obeys
//! J ω̇ = T − T_b: each part of the chart is one more load line of the bit, and one of them is met.
//!
//! ```
//! use sim::{BitTorque, LoadLine, MudMotor, TorqueLaw};
//!
//! let motor = MudMotor { speed: 12.0, slip: 2e-4, stall_torque: 12e3, rotor_inertia: 3.0 };
//! assert_eq!(motor.relative_speed(0.0), 12.0);
//! assert!((motor.relative_speed(5e3) - 11.0).abs() < 1e-12);
//! assert_eq!(motor.relative_speed(13e3), 0.0);
//! ```

use super::torque::LoadLine;
use crate::ranges::{SceneError, not_negative, positive};

/// A mud motor by its chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MudMotor {
    /// Speed of the rotor against its housing without load, by the flow of mud, rad/s.
    pub speed: f64,
    /// By how much that falls with the torque up to the stall, rad/s per N m.
    pub slip: f64,
    /// The torque at which it stalls, N m.
    pub stall_torque: f64,
    /// Moment of inertia of the rotor and of what turns with it, bit included, kg m².
    pub rotor_inertia: f64,
}

/// A motor at work.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MotorMotion {
    motor: MudMotor,
    /// What the inertia opposes to a change of speed in a step, N m s/rad.
    inertia: f64,
    /// Of the rotor in the last step, rad/s.
    bit_speed: f64,
}

/// What the end of the string does in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StringEnd {
    /// Torque on it, positive with the rotation, N m.
    pub(crate) torque: f64,
    /// rad/s.
    pub(crate) speed: f64,
}

impl MudMotor {
    /// Checks that there is such a motor.
    ///
    /// # Errors
    /// Where a number is out of its range, or the motor would turn backwards before it stalls.
    pub fn check(&self) -> Result<(), SceneError> {
        positive("speed of the motor without load in rad/s", self.speed)?;
        not_negative("slip of the motor in rad/s per N m", self.slip)?;
        positive("stall torque of the motor in N m", self.stall_torque)?;
        positive("inertia of the motor's rotor in kg m²", self.rotor_inertia)?;
        not_negative(
            "speed of the motor at its stall torque in rad/s",
            self.speed_at_stall(),
        )
    }

    /// Speed of the rotor against its housing where it is about to stall, rad/s.
    pub fn speed_at_stall(&self) -> f64 {
        self.speed - self.slip * self.stall_torque
    }

    /// Speed of the rotor against its housing under a torque (N m), rad/s.
    pub fn relative_speed(&self, torque: f64) -> f64 {
        match torque < self.stall_torque {
            true => self.speed - self.slip * torque,
            false => 0.0,
        }
    }
}

/// As [`MotorMotion::meet`] below a motor; without one the string ends at the bit.
#[inline]
pub(crate) fn meet_below<A>(
    motor: Option<&MotorMotion>,
    string: LoadLine,
    act: impl Fn(LoadLine) -> A,
    read: impl Fn(&A) -> [f64; 2],
) -> (A, StringEnd) {
    match motor {
        Some(motor) => motor.meet(string, act, read),
        None => {
            let answer = act(string);
            let [torque, speed] = read(&answer);
            (answer, StringEnd { torque, speed })
        }
    }
}

impl MotorMotion {
    /// With a bit that turns at a speed (rad/s), in steps of a length, s.
    pub(crate) fn new(motor: MudMotor, step: f64, bit_speed: f64) -> Self {
        Self {
            motor,
            inertia: motor.rotor_inertia / step,
            bit_speed,
        }
    }

    /// How fast the bit turns, rad/s.
    pub(crate) fn bit_speed(&self) -> f64 {
        self.bit_speed
    }

    /// Ends a step of the bit at a speed, rad/s.
    pub(crate) fn end_step(&mut self, bit_speed: f64) {
        self.bit_speed = bit_speed;
    }

    /// What acts on the bit, which answers to its load line with its torque (N m, positive with the
    /// rotation) and its speed (rad/s): where string, motor and bit agree. Where they do at more
    /// than one speed, the bit keeps the greatest.
    #[inline]
    pub(crate) fn meet<A>(
        &self,
        string: LoadLine,
        act: impl Fn(LoadLine) -> A,
        read: impl Fn(&A) -> [f64; 2],
    ) -> (A, StringEnd) {
        let MudMotor {
            speed,
            slip,
            stall_torque,
            ..
        } = self.motor;
        let driven = self.turning(string.free_speed + speed, string.compliance + slip, string);
        let answer = act(driven);
        let passed = self.passed_on(read(&answer));
        if passed <= stall_torque {
            return (answer, end(string, passed));
        }
        let answer = act(self.turning(string.free_speed, string.compliance, string));
        let passed = self.passed_on(read(&answer));
        if passed >= stall_torque {
            return (answer, end(string, passed));
        }
        // It slows down, or speeds up, under all the torque that it can pass on.
        let answer = act(LoadLine {
            free_speed: self.bit_speed + stall_torque / self.inertia,
            compliance: self.inertia.recip(),
            ..string
        });
        (answer, end(string, stall_torque))
    }

    /// The bit's load line where the rotor turns at `free_speed` less `compliance` per torque.
    fn turning(&self, free_speed: f64, compliance: f64, string: LoadLine) -> LoadLine {
        let heavier = 1.0 + compliance * self.inertia;
        LoadLine {
            free_speed: (free_speed + compliance * self.inertia * self.bit_speed) / heavier,
            compliance: compliance / heavier,
            ..string
        }
    }

    /// What the motor passes on to a bit on which a torque acts and that turns at a speed, N m.
    fn passed_on(&self, [torque, speed]: [f64; 2]) -> f64 {
        self.inertia * (speed - self.bit_speed) - torque
    }
}

fn end(string: LoadLine, passed: f64) -> StringEnd {
    StringEnd {
        torque: -passed,
        speed: string.speed_under(-passed),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::bit::BitTorque;
    use crate::laws::torque::{BitMotion, TorqueLaw};

    proptest! {
        /// String, rotor, chart and rock hold together in every step, whichever part is met.
        #[test]
        fn every_line_holds(
            free_speed in -20.0..20.0f64,
            compliance in 1e-4..1e-2f64,
            speed in 1.0..30.0f64,
            part in 0.0..1.0f64,
            stall_torque in 1e3..2e4f64,
            rotor_inertia in 0.1..20.0f64,
            bit_speed in -5.0..40.0f64,
            torque_static in 0.0..4e4f64,
            ratio in 0.3..1.0f64,
        ) {
            let motor = MudMotor { speed, slip: part * speed / stall_torque, stall_torque, rotor_inertia };
            prop_assert!(motor.check().is_ok());
            let step = 1.0 / 640.0;
            let motion = MotorMotion::new(motor, step, bit_speed);
            let law = BitTorque { torque_static, torque_dynamic: ratio * torque_static, decay_speed: 0.0 };
            let before = BitMotion::of(bit_speed);
            let line = LoadLine { time: 0.0, free_speed, compliance };
            let (bit, string) = motion.meet(line, |line| law.meet(&before, line), |it| [it.torque, it.speed]);
            let size = 1e-9 * (free_speed.abs() + speed + bit_speed.abs() + compliance * (stall_torque + torque_static));
            prop_assert!((string.speed - free_speed - compliance * string.torque).abs() <= size);
            let changed = rotor_inertia * (bit.speed - bit_speed) / step;
            let all = stall_torque + torque_static + changed.abs() + string.torque.abs();
            prop_assert!((changed - (bit.torque - string.torque)).abs() <= 1e-9 * all);
            let (relative, passed) = (bit.speed - string.speed, -string.torque);
            if passed < stall_torque * (1.0 - 1e-9) {
                prop_assert!((relative - motor.relative_speed(passed)).abs() <= size, "{relative}");
            } else if passed > stall_torque * (1.0 + 1e-9) {
                prop_assert!(relative.abs() <= size, "{relative}");
            } else {
                let most = speed - motor.slip * stall_torque;
                prop_assert!(relative >= -size && relative <= most + size, "{relative}");
            }
            match bit.speed {
                0.0 => prop_assert!(bit.torque.abs() <= torque_static * (1.0 + 1e-12)),
                turning => prop_assert!((bit.torque + turning.signum() * law.torque_dynamic).abs() <= 1e-9),
            }
        }
    }

    #[test]
    fn impossible_motors_are_refused() {
        let motor = MudMotor {
            speed: 12.0,
            slip: 1e-4,
            stall_torque: 12e3,
            rotor_inertia: 3.0,
        };
        assert!(motor.check().is_ok());
        for wrong in [
            MudMotor {
                speed: 0.0,
                ..motor
            },
            MudMotor {
                slip: -1e-4,
                ..motor
            },
            MudMotor {
                slip: 2e-3,
                ..motor
            },
            MudMotor {
                stall_torque: f64::NAN,
                ..motor
            },
            MudMotor {
                rotor_inertia: 0.0,
                ..motor
            },
        ] {
            assert!(wrong.check().is_err(), "{wrong:?}");
        }
    }
}
