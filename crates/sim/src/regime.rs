//! The torsional regime of a case and the measures behind it (Section 5.2.1).

use serde::{Deserialize, Serialize};

use crate::laws::bit::BitMotion;

/// Recaptures that make stick-slip: near the limit one may be the echo of the
/// first slip and a second its consequence; a third repeats.
pub const REPEATED: usize = 3;

/// How the bit turned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TorsionRegime {
    /// Never slipped in the time simulated: undetermined.
    Stuck,
    /// Slipped and turned on, perhaps after a few recaptures.
    Smooth,
    /// Recaptured again and again, in the closing window too: the ringing of
    /// the start may recapture the bit often before it dies away.
    StickSlip,
}

impl TorsionRegime {
    /// The label in result files.
    pub fn name(self) -> &'static str {
        match self {
            TorsionRegime::Stuck => "stuck",
            TorsionRegime::Smooth => "smooth",
            TorsionRegime::StickSlip => "stick_slip",
        }
    }
}

/// What a person would ask of the bit's motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionMeasures {
    /// The regime.
    pub regime: TorsionRegime,
    /// Time of the first slip, s.
    pub first_slip: Option<f64>,
    /// Mean time from slip to slip, s.
    pub period: Option<f64>,
    /// Mean time slipping between slip and recapture, s.
    pub slip_time: Option<f64>,
    /// How often the turning bit was recaptured.
    pub sticks: usize,
    /// Highest speed of the bit, rad/s.
    pub peak_speed: f64,
    /// Mean speed of the bit over the closing window, rad/s.
    pub closing_speed: f64,
}

/// Watches the bit step by step.
#[derive(Debug, Clone)]
pub(crate) struct BitWatch {
    step_length: f64,
    closing_from: usize,
    step: usize,
    motion: BitMotion,
    first_slip: Option<usize>,
    last_slip: usize,
    slips: usize,
    last_recaptured: Option<usize>,
    sticks: usize,
    slipping_steps: usize,
    peak_speed: f64,
    closing_sum: f64,
}

impl BitWatch {
    pub(crate) fn new(step_length: f64, steps: usize, closing_window: f64) -> Self {
        let window = (closing_window / step_length).round() as usize;
        Self {
            step_length,
            closing_from: steps.saturating_sub(window.max(1)),
            step: 0,
            motion: BitMotion::Stuck,
            first_slip: None,
            last_slip: 0,
            slips: 0,
            last_recaptured: None,
            sticks: 0,
            slipping_steps: 0,
            peak_speed: 0.0,
            closing_sum: 0.0,
        }
    }

    /// The first steps, in which the bit does not move.
    pub(crate) fn skip_stuck(&mut self, steps: usize) {
        self.step += steps;
    }

    pub(crate) fn see(&mut self, motion: BitMotion, speed: f64) {
        match (self.motion, motion) {
            (BitMotion::Stuck, BitMotion::Stuck) => {}
            (BitMotion::Stuck, _) => {
                self.first_slip.get_or_insert(self.step);
                self.last_slip = self.step;
                self.slips += 1;
            }
            (_, BitMotion::Stuck) => {
                self.sticks += 1;
                self.slipping_steps += self.step - self.last_slip;
            }
            _ => {}
        }
        if motion == BitMotion::Stuck && self.sticks > 0 {
            self.last_recaptured = Some(self.step);
        }
        self.motion = motion;
        self.peak_speed = self.peak_speed.max(speed);
        if self.step >= self.closing_from {
            self.closing_sum += speed;
        }
        self.step += 1;
    }

    fn is_sustained(&self) -> bool {
        let lately = self
            .last_recaptured
            .is_some_and(|step| step >= self.closing_from);
        lately && self.sticks >= REPEATED
    }

    pub(crate) fn measures(&self) -> TorsionMeasures {
        let time = |steps: usize| steps as f64 * self.step_length;
        let regime = match self.first_slip {
            None => TorsionRegime::Stuck,
            Some(_) if self.is_sustained() => TorsionRegime::StickSlip,
            Some(_) => TorsionRegime::Smooth,
        };
        let between_slips = self
            .first_slip
            .filter(|_| self.slips > 1)
            .map(|first| time(self.last_slip - first) / (self.slips - 1) as f64);
        let closing_steps = self.step.saturating_sub(self.closing_from).max(1);
        TorsionMeasures {
            regime,
            first_slip: self.first_slip.map(time),
            period: between_slips,
            slip_time: (self.sticks > 0).then(|| time(self.slipping_steps) / self.sticks as f64),
            sticks: self.sticks,
            peak_speed: self.peak_speed,
            closing_speed: self.closing_sum / closing_steps as f64,
        }
    }
}
