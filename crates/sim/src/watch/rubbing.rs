//! Whether the motion of a string that rubs along its well will continue unchanged, so that a
//! simulation may end before its time.

use super::rules::{AGREEING_CYCLES, Rules};
use super::torsion::{BitWatch, TorsionRegime};

/// Watches all ports of a string that rubs.
#[derive(Debug, Clone)]
pub(crate) struct RubbingWatch {
    rules: Rules,
    surface_speed: f64,
    /// The surface no longer changes its speed from this step on.
    steady_from: usize,
    /// Steps of half a closing window.
    half: usize,
    step: usize,
    /// How far a port was from the speed of the surface at most, rad/s, in this half of a window and
    /// in the one before; infinite where one was stuck.
    off: [f64; 2],
    /// Speeds of all ports when the bit last began to slip, rad/s, and how often in a row they
    /// were the same.
    at_slip: Vec<f64>,
    same: usize,
}

impl RubbingWatch {
    pub(crate) fn new(rules: Rules, surface_speed: f64, steady_from: usize, window: usize) -> Self {
        Self {
            rules,
            surface_speed,
            steady_from,
            half: (window / 2).max(1),
            step: 0,
            off: [0.0, f64::INFINITY],
            at_slip: Vec::new(),
            same: 0,
        }
    }

    /// One step: the speeds of all ports, whether any of them is stuck, and what a watch of the
    /// bit has seen.
    pub(crate) fn see(&mut self, speeds: &[f64], is_any_stuck: bool, bit: &BitWatch) {
        if self.step > 0 && self.step % self.half == 0 {
            self.off = [0.0, self.off[0]];
        }
        self.step += 1;
        let off = |speed: &f64| (speed - self.surface_speed).abs();
        let most = speeds.iter().map(off).fold(0.0, f64::max);
        let now = match is_any_stuck {
            true => f64::INFINITY,
            false => most,
        };
        self.off[0] = self.off[0].max(now);
        if bit.has_just_slipped() {
            let change = |(one, other): (&f64, &f64)| (one - other).abs();
            let changed = speeds.iter().zip(&self.at_slip).map(change);
            let is_same = self.at_slip.len() == speeds.len()
                && changed.fold(0.0, f64::max) <= self.tolerance();
            self.same = if is_same { self.same + 1 } else { 0 };
            self.at_slip.clear();
            self.at_slip.extend_from_slice(speeds);
        }
    }

    /// The regime that lasts, if one does: all of the string has turned as the surface does for a
    /// closing window, ever more evenly; or all of it repeats its last cycles.
    pub(crate) fn settled(&self, bit: &BitWatch) -> Option<TorsionRegime> {
        if self.step < self.steady_from + 2 * self.half {
            return None;
        }
        let [last, before] = self.off;
        let ends = self.step % self.half == 0;
        if ends && last <= before && before <= self.tolerance() {
            return Some(TorsionRegime::Smooth);
        }
        let repeats = self.same >= AGREEING_CYCLES
            && bit.agreeing_steps() >= 2 * self.half
            && bit.is_settled();
        repeats.then_some(TorsionRegime::StickSlip)
    }

    /// rad/s.
    fn tolerance(&self) -> f64 {
        self.rules.settling_tolerance * self.surface_speed.abs()
    }
}
