//! A top drive at the upper end of a waveguide: J dω/dt = K_p e + K_i ∫ e dt − T with
//! e = Ω − ω, by the trapezoidal rule. T is what the string takes: Z (ω − 2u) and what the
//! damping of half a row takes, u the wave in speed that arrives from below. One of limited torque gives
//! no more than that, and its integral stands still meanwhile, unless the error takes it back.

use linear::TopDrive;

use super::wound::Wound;

/// A motor under proportional and integral control, at rest at first.
#[derive(Debug, Clone)]
pub struct Motor {
    proportional_gain: f64,
    integral_gain: f64,
    /// Z and the damping, N m s/rad.
    impedance: f64,
    damping: f64,
    /// s.
    step: f64,
    /// 2J over the step, N m s/rad.
    inertia_per_step: f64,
    /// ω, rad/s.
    speed: f64,
    /// ∫ e dt, rad.
    behind: f64,
    /// Torque that speeded it up in the last step, N m.
    torque: f64,
    /// The most that it gives, N m.
    limit: f64,
}

impl Motor {
    /// A drive above a tube of an impedance and with damping at its end (N m s/rad), in steps of a
    /// length in s.
    pub fn new(drive: &TopDrive, impedance: f64, damping: f64, step: f64) -> Self {
        Self {
            proportional_gain: drive.proportional_gain,
            integral_gain: drive.integral_gain,
            impedance,
            damping,
            step,
            inertia_per_step: 2.0 * drive.inertia / step,
            speed: 0.0,
            behind: 0.0,
            torque: 0.0,
            limit: f64::INFINITY,
        }
    }

    /// The same, which gives no more than a torque, N m.
    pub fn limited(self, limit: f64) -> Self {
        Self { limit, ..self }
    }

    /// K_i, N m/rad.
    pub fn integral_gain(&self) -> f64 {
        self.integral_gain
    }

    /// Turns as in a steady winding, a step before the first: the error of its speed is constant.
    pub fn turn(&mut self, set: f64, wound: &Wound) {
        let error = set - wound.surface_speed;
        let torque = wound.surface_torque - wound.torque_per_step;
        self.speed = wound.surface_speed;
        self.behind = (torque - self.proportional_gain * error) / self.integral_gain;
        self.torque = 0.0;
    }

    /// Its speed, rad/s, after a step in which a wave `up` arrived and `set` was asked for.
    pub fn advance(&mut self, set: f64, up: f64) -> f64 {
        let half = 0.5 * self.step;
        // Without its own speed at the end of the step.
        let behind = self.behind + half * (2.0 * set - self.speed);
        let from_string = 2.0 * self.impedance * up;
        let of_string = self.impedance + self.damping;
        let before = self.inertia_per_step * self.speed + self.torque;
        let speed_under = |pull: f64, held_back: f64| {
            (before + pull + from_string) / (self.inertia_per_step + held_back + of_string)
        };
        let mut pull = self.proportional_gain * set + self.integral_gain * behind;
        let mut held_back = self.proportional_gain + self.integral_gain * half;
        let mut speed = speed_under(pull, held_back);
        let asked = pull - held_back * speed;
        let is_limited = asked.abs() > self.limit;
        if is_limited {
            (pull, held_back) = (self.limit.copysign(asked), 0.0);
            speed = speed_under(pull, held_back);
        }
        if !is_limited || (set - speed) * asked < 0.0 {
            self.behind = behind - half * speed;
        }
        // One without inertia takes no torque.
        self.torque = if self.inertia_per_step > 0.0 {
            pull + from_string - (held_back + of_string) * speed
        } else {
            0.0
        };
        self.speed = speed;
        speed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Above nothing, ω/Ω = 1 − e^(−ζνt)(cos ν_d t − ζν/ν_d sin ν_d t) after the set speed jumps,
    /// with ν² = K_i/J and 2ζν = K_p/J.
    #[test]
    fn a_motor_without_a_string_answers_as_an_oscillator() {
        let drive = TopDrive {
            inertia: 2000.0,
            proportional_gain: 800.0,
            integral_gain: 1000.0,
            delay: 0.0,
            late_inertia: 0.0,
        };
        let (step, set) = (1e-3, 3.0);
        let mut motor = Motor::new(&drive, 0.0, 0.0, step);
        let (decay, square): (f64, f64) = (0.2, 0.5);
        let damped = (square - decay * decay).sqrt();
        for index in 1..=8000 {
            let speed = motor.advance(set, 0.0);
            // The torque that sets in is met half way through the first step.
            let time = (f64::from(index) - 0.5) * step;
            let (sin, cos) = (damped * time).sin_cos();
            let exact = set * (1.0 - (-decay * time).exp() * (cos - decay / damped * sin));
            assert!(
                (speed - exact).abs() < 1e-3 * set,
                "{index}: {speed} {exact}"
            );
        }
    }

    /// Brought up by its limit L alone, ω = Lt/J until K_p e is L, as its integral stands still.
    #[test]
    fn a_motor_of_limited_torque_gives_no_more() {
        let drive = TopDrive {
            inertia: 2000.0,
            proportional_gain: 800.0,
            integral_gain: 1000.0,
            delay: 0.0,
            late_inertia: 0.0,
        };
        let (step, set, limit) = (1e-3, 3.0, 600.0);
        let mut motor = Motor::new(&drive, 0.0, 0.0, step).limited(limit);
        let speeds: Vec<f64> = (0..7000).map(|_| motor.advance(set, 0.0)).collect();
        // The torque that sets in is met half way through the first step.
        let exact = limit * 6.9995 / drive.inertia;
        assert!(
            (speeds[6999] - exact).abs() < 1e-9,
            "{} {exact}",
            speeds[6999]
        );
        assert_eq!(motor.behind, 0.0);
    }
}
