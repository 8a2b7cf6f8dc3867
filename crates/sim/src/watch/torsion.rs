//! The torsional regime of a case and the measures behind it (Section 5.2.1).
//!
//! What may begin in either regime, and lasts in both, is bistable:
//!
//! ```
//! use sim::{Label, TorsionRegime};
//!
//! let regime = TorsionRegime::from_two_starts(TorsionRegime::Smooth, TorsionRegime::StickSlip);
//! assert_eq!(regime, TorsionRegime::Bistable);
//! assert_eq!(Label::of_name("bistable"), Some(Label::Torsion(regime)));
//! assert_eq!(Label::Torsion(regime).is_sustained(), Some(true));
//! ```

use linear::budget::REAL;
use serde::{Deserialize, Serialize};

use super::rules::{AGREEING_CYCLES, Rules};
use crate::laws::torque::BitMotion;
use crate::sampling::Sampling;
use crate::words::with_words;

with_words! {
    /// How the bit turned.
    #[non_exhaustive]
    pub enum TorsionRegime {
        /// Never slipped in the time simulated: undetermined. Or, below a drive of limited torque,
        /// stood still through the closing window, as where the drive has stalled.
        Stuck = "stuck",
        /// Slipped and turned on, perhaps after a few recaptures.
        Smooth = "smooth",
        /// Recaptured again and again, in the closing window too: the ringing of
        /// the start may recapture the bit often before it dies away.
        StickSlip = "stick_slip",
        /// Either, as the motion began: recaptured again and again from one start, turning on
        /// from another; or, below a drive that stalls, stuck from one. No single simulation has it.
        Bistable = "bistable",
        /// Recaptured again and again, for ever shorter, as far as it is followed: undetermined. Or
        /// turning, below a drive of limited torque, ever slower or faster.
        Undetermined = "undetermined",
    }
}

impl TorsionRegime {
    /// That of a case simulated from two starts.
    pub fn from_two_starts(one: Self, other: Self) -> Self {
        match (one, other) {
            (Self::Stuck, _) | (_, Self::Stuck) => Self::Stuck,
            (Self::Undetermined, _) | (_, Self::Undetermined) => Self::Undetermined,
            _ if one == other => one,
            _ => Self::Bistable,
        }
    }
}

/// What a person would ask of the bit's motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct TorsionMeasures {
    /// The regime.
    pub regime: TorsionRegime,
    /// Time of the first slip of a case that begins at rest, s.
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
    /// Severity of stick-slip, (ω_max − ω_min)/(2 ω_mean), of the fastest and slowest in the
    /// closing window and of the bit's mean over whole cycles, which is the surface speed and, below
    /// a mud motor, the mean speed of its rotor against the housing: about 1 where the bit just stops,
    /// more where it stands still for long; none where that mean is zero.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub severity: Option<f64>,
    /// Part of the closing window in which the mud motor above the bit stalls: it passes on more than
    /// its stall torque, and the bit turns with the string; none without a motor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motor_stalled_fraction: Option<f64>,
    /// Whether it sticks for ever shorter: longer simulated, it may turn on. Or, below a drive of limited
    /// torque, turns ever slower or faster: longer simulated, it may stall.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub fades: bool,
    /// Whether it sticks for times so different from cycle to cycle that it may yet turn on.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub is_irregular: bool,
}

impl TorsionMeasures {
    /// What may be no number, with its name.
    pub(crate) fn numbers(&self) -> [(&'static str, f64); 2] {
        [
            ("highest speed", self.peak_speed),
            ("mean speed in the closing window", self.closing_speed),
        ]
    }
}

/// From one slip to the next.
#[derive(Debug, Clone, Copy, Default)]
struct Cycle {
    /// Steps.
    period: usize,
    /// Steps of that in slipping.
    slipping: usize,
    /// Sum of the speeds of its steps, rad/s.
    travel: f64,
}

impl Cycle {
    /// Whether another is the same to a step.
    fn is_alike(&self, other: &Self) -> bool {
        self.period.abs_diff(other.period) <= 1 && self.slipping.abs_diff(other.slipping) <= 1
    }
}

/// Cycles that are the same to a step, one after the other.
#[derive(Debug, Clone, Default)]
struct Alike {
    first: Cycle,
    count: usize,
}

impl Alike {
    fn see(&mut self, cycle: Cycle) {
        if self.count == 0 || !self.first.is_alike(&cycle) {
            *self = Self {
                first: cycle,
                count: 0,
            };
        }
        self.count += 1;
    }
}

/// Times in which the bit was stuck, each shorter than all before, that make stick-slip fade. Of
/// stick-slip that lasts they scatter, and two such in a row are rare.
const EVER_SHORTER: usize = 2;

/// Ratio of the longest to the shortest of the last times stuck from which on stick-slip is irregular. Of seven
/// strings of 400 that turned on between the time of the rule and ten times that four were so and turned on within
/// three times of it. From 1.25 on it would be five, and a well of jointed pipe would take twice as long.
const IRREGULAR: f64 = 2.0;

/// Times in which the bit was stuck, from slip to slip, steps.
#[derive(Debug, Clone, Default)]
struct Stuck {
    least: Option<usize>,
    /// How often in a row it was stuck for a shorter time than ever before.
    ever_shorter: usize,
    /// The last times.
    last: [usize; 5],
}

impl Stuck {
    /// A time in steps; what differs by one is the same.
    fn see(&mut self, stuck: usize) {
        let is_shorter = self.least.is_none_or(|least| stuck + 1 < least);
        self.ever_shorter = if is_shorter { self.ever_shorter + 1 } else { 0 };
        self.least = Some(self.least.map_or(stuck, |least| least.min(stuck)));
        self.last.rotate_left(1);
        self.last[self.last.len() - 1] = stuck;
    }

    fn is_irregular(&self) -> bool {
        let times = || self.last.iter().filter(|stuck| **stuck > 0);
        let [least, most] = [times().min(), times().max()].map(|it| *it.unwrap_or(&0));
        most as f64 > IRREGULAR * least as f64 + 1.0
    }
}

/// Watches the bit step by step.
#[derive(Debug, Clone)]
pub(crate) struct BitWatch {
    rules: Rules,
    steps: usize,
    /// Steps: the closing window is no shorter than a cycle.
    longest_cycle: usize,
    cycles: [Cycle; AGREEING_CYCLES],
    alike: Alike,
    stuck: Stuck,
    /// Speeds since the last slip began, and of the cycle before.
    since_slip: Vec<f64>,
    last_cycle: Vec<f64>,
    recaptured_at: usize,
    sampling: Sampling,
    closing_from: usize,
    step: usize,
    /// A bit that was stuck slips once it turns faster than this, rad/s.
    creep: f64,
    motion: BitMotion,
    first_slip: Option<usize>,
    last_slip: usize,
    slips: usize,
    last_recaptured: Option<usize>,
    sticks: usize,
    slipping_steps: usize,
    peak_speed: f64,
    closing: Closing,
    /// Whether what turns the string may stall.
    may_stall: bool,
}

/// Speeds in the closing window, rad/s.
#[derive(Debug, Clone)]
struct Closing {
    sum: f64,
    /// Sum over its second half.
    late: f64,
    least: f64,
    most: f64,
}

impl Closing {
    /// Whether the bit has stood still through it.
    fn stands_still(&self) -> bool {
        self.least == 0.0 && self.most == 0.0
    }

    fn see(&mut self, speed: f64, steps: usize) {
        if steps == 0 {
            return;
        }
        self.sum += steps as f64 * speed;
        self.least = self.least.min(speed);
        self.most = self.most.max(speed);
    }
}

impl BitWatch {
    /// Bytes of a case of a number of steps: speeds of two cycles.
    pub(crate) fn bytes(steps: f64) -> f64 {
        2.0 * REAL * steps
    }

    pub(crate) fn new(rules: Rules, sampling: Sampling, steps: usize, closing_window: f64) -> Self {
        // What is asked of more steps than there are is asked of all.
        let window = ((closing_window * sampling.frequency).round() as usize).min(steps);
        Self {
            rules,
            steps,
            longest_cycle: window + 1,
            cycles: Default::default(),
            alike: Alike::default(),
            stuck: Stuck::default(),
            since_slip: Vec::new(),
            last_cycle: Vec::new(),
            recaptured_at: 0,
            sampling,
            closing_from: steps.saturating_sub(window.max(1)),
            step: 0,
            creep: 0.0,
            motion: BitMotion::Stuck,
            first_slip: None,
            last_slip: 0,
            slips: 0,
            last_recaptured: None,
            sticks: 0,
            slipping_steps: 0,
            peak_speed: 0.0,
            closing: Closing {
                sum: 0.0,
                late: 0.0,
                least: f64::INFINITY,
                most: f64::NEG_INFINITY,
            },
            may_stall: false,
        }
    }

    /// The same of a bit that creeps at a speed of the surface (rad/s), as one that cuts does.
    pub(crate) fn creeping(self, surface_speed: f64) -> Self {
        Self {
            creep: self.rules.creeping * surface_speed.abs(),
            ..self
        }
    }

    /// The same of a string whose drive may stall: a bit that stands still through the closing
    /// window is then stuck for good, however often it slipped before.
    pub(crate) fn that_may_stall(self, may_stall: bool) -> Self {
        Self { may_stall, ..self }
    }

    /// The first steps, in which the bit does not move.
    pub(crate) fn skip_stuck(&mut self, steps: usize) {
        self.step += steps;
    }

    pub(crate) fn see(&mut self, motion: BitMotion, speed: f64) {
        let creeps = self.motion == BitMotion::Stuck && speed.abs() < self.creep;
        let motion = if creeps { BitMotion::Stuck } else { motion };
        match (self.motion, motion) {
            (BitMotion::Stuck, BitMotion::Stuck) => {}
            (BitMotion::Stuck, _) => {
                if self.first_slip.is_some() {
                    self.end_cycle();
                }
                self.since_slip.clear();
                self.first_slip.get_or_insert(self.step);
                self.last_slip = self.step;
                self.slips += 1;
            }
            (_, BitMotion::Stuck) => {
                self.recaptured_at = self.step;
                self.sticks += 1;
                self.slipping_steps += self.step - self.last_slip;
            }
            _ => {}
        }
        if motion == BitMotion::Stuck && self.sticks > 0 {
            self.last_recaptured = Some(self.step);
        }
        self.motion = motion;
        // A bit that turns on needs no more than a cycle.
        if self.first_slip.is_some() && self.since_slip.len() < self.longest_cycle {
            self.since_slip.push(speed);
        }
        self.peak_speed = self.peak_speed.max(speed);
        if self.step >= self.closing_from {
            self.closing.see(speed, 1);
            if 2 * (self.step - self.closing_from) >= self.steps - self.closing_from {
                self.closing.late += speed;
            }
        }
        self.step += 1;
    }

    fn end_cycle(&mut self) {
        self.cycles.rotate_left(1);
        let cycle = Cycle {
            period: self.step - self.last_slip,
            slipping: self.recaptured_at - self.last_slip,
            travel: self.since_slip.iter().sum(),
        };
        self.cycles[AGREEING_CYCLES - 1] = cycle;
        self.alike.see(cycle);
        self.stuck.see(self.step - self.recaptured_at);
        std::mem::swap(&mut self.last_cycle, &mut self.since_slip);
    }

    /// Steps for which the bit has been turning without a stop.
    pub(crate) fn turning_for(&self) -> usize {
        match self.motion {
            BitMotion::Stuck => 0,
            _ => self.step - self.last_slip,
        }
    }

    /// Whether a slip has just begun.
    pub(crate) fn has_just_slipped(&self) -> bool {
        self.since_slip.len() == 1
    }

    /// How long the last cycles took together that have to agree, steps.
    pub(crate) fn agreeing_steps(&self) -> usize {
        self.cycles.iter().map(|cycle| cycle.period).sum()
    }

    /// Whether a slip has just begun that repeats the last ones, and, at their latest rate of
    /// change, will do so until the end of the time.
    pub(crate) fn is_settled(&self) -> bool {
        let [first, second, last] = self.cycles;
        let is_whole = self.last_cycle.len() == last.period;
        if !is_whole
            || !self.has_just_slipped()
            || first.period == 0
            || self.sticks < self.rules.repeated
        {
            return false;
        }
        let cycles_left = (self.steps - self.step) as f64 / last.period as f64;
        // Steps by which a period may change until the end, as it may have in all cycles that are
        // alike, for a step is not seen.
        let unseen = cycles_left / self.alike.count as f64;
        if unseen > self.rules.settling_tolerance * last.period as f64 {
            return false;
        }
        let steady = |one: f64, other: f64, rounding: f64| {
            let change = ((one - other).abs() - rounding).max(0.0);
            change * cycles_left.max(1.0) <= self.rules.settling_tolerance * other
        };
        [(first, second), (second, last)]
            .iter()
            .all(|(one, other)| {
                steady(one.period as f64, other.period as f64, 1.0)
                    && one.slipping.abs_diff(other.slipping) <= 1
                    && steady(
                        one.travel,
                        other.travel,
                        other.travel / other.slipping as f64,
                    )
            })
    }

    /// The rest of the time as repetitions of the last cycle.
    pub(crate) fn repeat_last_cycle(&mut self) {
        let cycle = std::mem::take(&mut self.last_cycle);
        let period = cycle.len();
        let last = self.cycles[AGREEING_CYCLES - 1];
        // The present slip is one step old.
        let begun = self.step - 1;
        for step in self.step..self.steps {
            let phase = (step - begun) % period;
            let closing = step >= self.closing_from;
            if closing {
                self.closing.see(cycle[phase], 1);
            }
            if phase == last.slipping {
                self.sticks += 1;
                self.slipping_steps += last.slipping;
            }
            if phase == 0 {
                self.slips += 1;
                self.last_slip = step;
            }
            if phase >= last.slipping {
                self.last_recaptured = Some(step);
            }
        }
        self.step = self.steps;
    }

    /// The rest of the time without a stop, at speeds of which the last stays.
    pub(crate) fn turn_on(&mut self, speeds: &[f64]) {
        let motion = self.motion;
        for &speed in speeds.iter().take(self.steps - self.step) {
            self.see(motion, speed);
        }
        let last = speeds.last().copied().unwrap_or(0.0);
        let closing = self.steps - self.closing_from.max(self.step).min(self.steps);
        self.closing.see(last, closing);
        self.step = self.steps;
    }

    fn is_sustained(&self) -> bool {
        let lately = self
            .last_recaptured
            .is_some_and(|step| step >= self.closing_from);
        lately && self.sticks >= self.rules.repeated
    }

    /// Regime and measures of a bit that turns at a mean speed over whole cycles, rad/s.
    pub(crate) fn measures(&self, mean_speed: f64) -> TorsionMeasures {
        let time = |steps: usize| self.sampling.start_of(steps);
        let regime = match self.first_slip {
            None => TorsionRegime::Stuck,
            Some(_) if self.may_stall && self.closing.stands_still() => TorsionRegime::Stuck,
            Some(_) if self.is_sustained() => TorsionRegime::StickSlip,
            Some(_) => TorsionRegime::Smooth,
        };
        let between_slips = self
            .first_slip
            .filter(|_| self.slips > 1)
            .map(|first| time(self.last_slip - first) / (self.slips - 1) as f64);
        let closing_steps = self.step.saturating_sub(self.closing_from).max(1);
        let swing = self.closing.most - self.closing.least;
        let early = self.closing.sum - self.closing.late;
        let changes = (self.closing.late - early).abs()
            > 0.5 * self.rules.settling_tolerance * self.closing.sum.abs();
        let fades = match regime {
            TorsionRegime::StickSlip => self.stuck.ever_shorter >= EVER_SHORTER,
            TorsionRegime::Smooth => self.may_stall && changes,
            _ => false,
        };
        TorsionMeasures {
            regime,
            first_slip: self.first_slip.map(|step| self.sampling.time_of(step)),
            period: between_slips,
            slip_time: (self.sticks > 0).then(|| time(self.slipping_steps) / self.sticks as f64),
            sticks: self.sticks,
            peak_speed: self.peak_speed,
            closing_speed: self.closing.sum / closing_steps as f64,
            severity: Some(0.5 * swing / mean_speed.abs()).filter(|severity| severity.is_finite()),
            motor_stalled_fraction: None,
            fades,
            is_irregular: regime == TorsionRegime::StickSlip && self.stuck.is_irregular(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The last 40 of 100 steps count, whether they are seen, repeated or certain.
    fn watched(speeds: impl Iterator<Item = f64>) -> BitWatch {
        let mut watch = BitWatch::new(Rules::USUAL, Sampling::new(1.0, 0.0), 100, 40.0);
        for speed in speeds {
            let motion = match speed {
                0.0 => BitMotion::Stuck,
                _ => BitMotion::Forward,
            };
            watch.see(motion, speed);
        }
        watch
    }

    /// A speed of 2 ± ½, after a start that does not count.
    fn swinging(step: usize) -> f64 {
        match step {
            0..60 => 9.0,
            _ if step % 2 == 0 => 1.5,
            _ => 2.5,
        }
    }

    /// A stick in which the bit creeps and stops is one, where creeping does not count as slipping.
    #[test]
    fn what_creeps_has_not_slipped() {
        let sticks = |creeps: bool| {
            let mut watch = BitWatch::new(Rules::USUAL, Sampling::new(1.0, 0.0), 400, 40.0);
            if creeps {
                watch = watch.creeping(1.0);
            }
            for step in 0..400 {
                // Of forty steps thirty at the speed of the surface; then creep and standstill.
                let (motion, speed) = match (step % 40, step % 2) {
                    (0..30, _) => (BitMotion::Forward, 1.0),
                    (_, 0) => (BitMotion::Forward, 0.005),
                    _ => (BitMotion::Stuck, 0.0),
                };
                watch.see(motion, speed);
            }
            watch.measures(1.0).sticks
        };
        assert_eq!((sticks(true), sticks(false)), (10, 50));
    }

    #[test]
    fn severity_is_the_swing_of_the_closing_window_by_the_surface_speed() {
        let measures = watched((0..100).map(swinging)).measures(2.0);
        assert_eq!(
            (measures.closing_speed, measures.severity),
            (2.0, Some(0.25))
        );
        // Turning on at speeds that are known, the last of which stays.
        let mut certain = watched((0..50).map(swinging));
        let ahead: Vec<f64> = (50..80).map(swinging).chain([3.0]).collect();
        certain.turn_on(&ahead);
        let measures = certain.measures(3.0);
        assert!((measures.closing_speed - 2.5).abs() < 0.05);
        assert_eq!(measures.severity, Some(0.25));
        // A bit at 2 for half of the time: as a sine wave that just stops.
        let sticking = watched((0..100).map(|step| if step % 20 < 10 { 0.0 } else { 2.0 }));
        assert_eq!(sticking.measures(1.0).severity, Some(1.0));
        assert_eq!(sticking.measures(0.0).severity, None);
    }

    /// Measures of a bit that is stuck for these steps, one after the other.
    fn stuck_for(stuck: &[usize]) -> TorsionMeasures {
        let steps = stuck.iter().map(|stuck| stuck + 10).sum();
        let mut watch = BitWatch::new(Rules::USUAL, Sampling::new(1.0, 0.0), steps, 40.0);
        for &stuck in stuck {
            (0..10).for_each(|_| watch.see(BitMotion::Forward, 2.0));
            (0..stuck).for_each(|_| watch.see(BitMotion::Stuck, 0.0));
        }
        watch.measures(1.0)
    }

    #[test]
    fn stick_slip_is_irregular_whose_times_stuck_differ_twice() {
        let is_irregular = |stuck: &[usize]| stuck_for(stuck).is_irregular;
        // The last of each is not over.
        assert!(!is_irregular(&[90, 20, 20, 20, 21, 30, 20]));
        assert!(is_irregular(&[20, 42, 20, 20, 20, 20]));
        assert!(!is_irregular(&[2, 1, 2, 1, 2, 2]));
    }

    #[test]
    fn stick_slip_fades_that_sticks_for_ever_shorter() {
        let fades = |stuck: &[usize]| stuck_for(stuck).fades;
        // The last of each is not over.
        assert!(fades(&[20, 15, 12, 9, 9]));
        assert!(fades(&[20, 15, 9]));
        assert!(!fades(&[20, 15, 15, 14, 9]));
        assert!(!fades(&[20, 10, 17, 14, 12, 9]));
        assert!(!fades(&[9, 12, 15, 20, 20]));
    }

    /// After how many of a hundred cycles of a number of steps, half of each in slipping, these have
    /// settled.
    fn settles_after(period: usize) -> usize {
        let sampling = Sampling::new(1.0, 0.0);
        let steps = 100 * period;
        let mut watch = BitWatch::new(Rules::USUAL, sampling, steps, period as f64);
        let settled = (0..steps).find(|step| {
            let motion = match step % period < period / 2 {
                true => BitMotion::Forward,
                false => BitMotion::Stuck,
            };
            watch.see(motion, f64::from(motion == BitMotion::Forward));
            watch.is_settled()
        });
        settled.expect("what repeats settles") / period
    }

    /// A change of a step in all the cycles seen is not seen; until the end it may grow to more than
    /// what settled motion may change by.
    #[test]
    fn short_cycles_settle_once_a_change_of_a_step_would_have_been_seen() {
        assert_eq!(settles_after(20_000), 3);
        // (100 - n)/n = 0.01 · 20
        assert!((83..=86).contains(&settles_after(20)));
    }
}
