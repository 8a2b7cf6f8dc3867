//! A mud motor in the closing window: for how much of it the motor stalls, and how much faster than
//! the string the bit turns below it.

use crate::laws::motor::MudMotor;

/// Sums over the closing window of a case below a mud motor.
#[derive(Debug, Clone)]
pub(crate) struct MotorWatch {
    stall_torque: f64,
    closing_from: usize,
    steps: usize,
    stalled: usize,
    /// Sum of the speeds of the rotor against its housing, rad/s.
    relative: f64,
}

impl MotorWatch {
    /// Watch of a motor from a step on.
    pub(crate) fn new(motor: MudMotor, closing_from: usize) -> Self {
        Self {
            stall_torque: motor.stall_torque,
            closing_from,
            steps: 0,
            stalled: 0,
            relative: 0.0,
        }
    }

    /// Adds a step in which the motor passes on a torque (N m) and its rotor turns at a speed against
    /// the housing, rad/s.
    pub(crate) fn see(&mut self, step: usize, passed: f64, relative: f64) {
        if step < self.closing_from {
            return;
        }
        self.steps += 1;
        self.stalled += usize::from(passed > self.stall_torque);
        self.relative += relative;
    }

    /// Part of the closing window in which it passes on more than its stall torque: there its rotor
    /// stands in the housing.
    pub(crate) fn stalled_fraction(&self) -> f64 {
        self.stalled as f64 / self.steps.max(1) as f64
    }

    /// Mean speed of the rotor against its housing, rad/s.
    pub(crate) fn mean_relative_speed(&self) -> f64 {
        self.relative / self.steps.max(1) as f64
    }
}
