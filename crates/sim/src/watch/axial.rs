//! The axial regime of a bit that cuts, and the measures behind it.
//!
//! ```
//! use sim::{AxialRegime, Label, Motion};
//!
//! assert_eq!(Label::of_name("bit_bounce"), Some(Label::Axial(AxialRegime::BitBounce)));
//! assert_eq!(Label::Axial(AxialRegime::Steady).motion(), Motion::Axial);
//! assert_eq!(Label::Axial(AxialRegime::AxialChatter).is_sustained(), Some(true));
//! ```

use serde::{Deserialize, Serialize};

use super::band::{AccelerationSums, DifferenceOf, Filtered, InBand, LowPass, USUAL_BAND};
use super::rules::Rules;
use crate::laws::cutting::CutStep;
use crate::sampling::Sampling;
use crate::words::with_words;

with_words! {
    /// How the bit moved along its axis in the closing window.
    #[non_exhaustive]
    pub enum AxialRegime {
        /// It went down all the time while it turned, or rested on its wear flats.
        Steady = "steady",
        /// It stopped or rose while it turned, and went down again, more than once.
        AxialChatter = "axial_chatter",
        /// It left the rock.
        BitBounce = "bit_bounce",
    }
}

/// What a person would ask of a bit that cuts, over the closing window.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct AxialMeasures {
    /// The regime.
    pub regime: AxialRegime,
    /// Mean rate of penetration, m/s.
    pub rate_of_penetration: f64,
    /// The same over that of steady drilling under the mean weight at the mean speed; none where that
    /// would not cut.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part_of_steady: Option<f64>,
    /// Part of the time off bottom.
    pub off_bottom: f64,
    /// Part of the time in which the bit turned and rested on its flats, going neither down nor up.
    pub at_rest: f64,
    /// Part of the time in which it turned back.
    pub turns_back: f64,
    /// Mean weight on bit, N.
    pub mean_weight: f64,
    /// Greatest weight on bit, N.
    pub peak_weight: f64,
    /// Greatest depth of cut of a blade, m.
    pub peak_depth_of_cut: f64,
    /// What the bit feels along its axis; none in a window of a single step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<AxialAcceleration>,
}

/// Acceleration of a bit along its axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct AxialAcceleration {
    /// Acceleration within the band of a sensor; `None` in records of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub in_band: Option<InBand>,
    /// The greatest by the difference of its rates in two steps, m/s²: where it lands or stops within a
    /// step, it grows with the sampling frequency.
    #[serde(alias = "peak")]
    pub step_peak: f64,
    /// Its root mean square, m/s².
    #[serde(alias = "rms")]
    pub step_rms: f64,
}

/// Watches the acceleration along the axis by rates, step by step.
#[derive(Debug, Clone)]
pub(crate) struct AxialShocks {
    /// Hz.
    sampling_frequency: f64,
    filter: LowPass,
    filtered: Filtered,
    last_rate: Option<f64>,
    in_band: AccelerationSums,
    in_steps: AccelerationSums,
}

impl AxialShocks {
    /// Of a sensor of a band, Hz.
    pub(crate) fn new(band: f64, sampling_frequency: f64) -> Self {
        Self {
            sampling_frequency,
            filter: LowPass::new(band, sampling_frequency),
            filtered: Filtered::default(),
            last_rate: None,
            in_band: AccelerationSums::default(),
            in_steps: AccelerationSums::default(),
        }
    }

    /// The rate in the next step, m/s, which counts or not.
    pub(crate) fn see(&mut self, rate: f64, counts: bool) {
        // The first step of a case is the end of none.
        let Some(last) = self.last_rate.replace(rate) else {
            return;
        };
        let acceleration = (rate - last) * self.sampling_frequency;
        let within = (self.filter).pass(&mut self.filtered, acceleration, DifferenceOf::Speeds);
        if counts {
            self.in_band.add_in_band(within * within);
            self.in_steps.add(acceleration * acceleration);
        }
    }

    pub(crate) fn measures(&self) -> Option<AxialAcceleration> {
        let in_band = self.in_band.within(&self.filter);
        (self.in_steps.measures()).map(|[step_peak, step_rms]| AxialAcceleration {
            in_band,
            step_peak,
            step_rms,
        })
    }
}

impl AxialMeasures {
    /// What may be no number, with its name.
    pub(crate) fn numbers(&self) -> [(&'static str, f64); 3] {
        [
            ("rate of penetration", self.rate_of_penetration),
            ("greatest weight on bit", self.peak_weight),
            ("greatest depth of cut", self.peak_depth_of_cut),
        ]
    }
}

/// Watches a bit that cuts, step by step.
#[derive(Debug, Clone)]
pub(crate) struct CutWatch {
    rules: Rules,
    closing_from: usize,
    step: usize,
    /// How fast it went down in the last step, m/s.
    last_rate: f64,
    /// Times that it stopped going down while it turned.
    stops: usize,
    off_bottom: usize,
    at_rest: usize,
    turns_back: usize,
    advance: f64,
    turned: f64,
    weight: f64,
    peak_weight: f64,
    peak_depth_of_cut: f64,
    shocks: AxialShocks,
}

impl CutWatch {
    pub(crate) fn new(rules: Rules, sampling: Sampling, steps: usize, closing_window: f64) -> Self {
        let window = ((closing_window * sampling.frequency).round() as usize).min(steps);
        Self {
            rules,
            closing_from: steps.saturating_sub(window.max(1)),
            step: 0,
            last_rate: 0.0,
            stops: 0,
            off_bottom: 0,
            at_rest: 0,
            turns_back: 0,
            advance: 0.0,
            turned: 0.0,
            weight: 0.0,
            peak_weight: 0.0,
            peak_depth_of_cut: 0.0,
            shocks: AxialShocks::new(USUAL_BAND, sampling.frequency),
        }
    }

    pub(crate) fn see(&mut self, cut: &CutStep) {
        let goes_down = cut.rate > 0.0;
        if self.step >= self.closing_from {
            let stops = self.last_rate > 0.0 && !goes_down && cut.speed > 0.0;
            self.stops += usize::from(stops);
            self.off_bottom += usize::from(!cut.touches);
            let rests = cut.touches && cut.rate == 0.0 && cut.speed > 0.0;
            self.at_rest += usize::from(rests);
            self.turns_back += usize::from(cut.speed < 0.0);
            self.advance += cut.rate;
            self.turned += cut.speed;
            self.weight += cut.weight;
            self.peak_weight = self.peak_weight.max(cut.weight);
            self.peak_depth_of_cut = self.peak_depth_of_cut.max(cut.deepest_cut);
        }
        self.shocks.see(cut.rate, self.step >= self.closing_from);
        self.last_rate = cut.rate;
        self.step += 1;
    }

    /// What came out; `steady_rate` is that of steady drilling under a weight (N) at a speed (rad/s).
    pub(crate) fn measures(&self, steady_rate: impl Fn(f64, f64) -> f64) -> AxialMeasures {
        let steps = self.step.saturating_sub(self.closing_from).max(1) as f64;
        let part = |count: usize| count as f64 / steps;
        let [rate, speed, weight] = [self.advance, self.turned, self.weight].map(|sum| sum / steps);
        let off_bottom = part(self.off_bottom);
        let regime = if off_bottom > self.rules.off_bottom {
            AxialRegime::BitBounce
        } else if self.stops >= self.rules.repeated {
            AxialRegime::AxialChatter
        } else {
            AxialRegime::Steady
        };
        let steady = steady_rate(weight, speed);
        AxialMeasures {
            regime,
            rate_of_penetration: rate,
            part_of_steady: (steady > 0.0).then(|| rate / steady),
            off_bottom,
            at_rest: part(self.at_rest),
            turns_back: part(self.turns_back),
            mean_weight: weight,
            peak_weight: self.peak_weight,
            peak_depth_of_cut: self.peak_depth_of_cut,
            acceleration: self.shocks.measures(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The last 40 of 100 steps count.
    fn regime(step_of: impl Fn(usize) -> CutStep) -> AxialMeasures {
        let mut watch = CutWatch::new(Rules::USUAL, Sampling::new(1.0, 0.5), 100, 40.0);
        (0..100).for_each(|step| watch.see(&step_of(step)));
        watch.measures(|weight, speed| 1e-6 * weight * speed)
    }

    fn cutting(rate: f64) -> CutStep {
        CutStep {
            speed: 10.0,
            rate,
            weight: 1000.0,
            touches: true,
            ..CutStep::default()
        }
    }

    #[test]
    fn what_goes_down_all_the_time_is_steady() {
        let found = regime(|_| cutting(0.005));
        assert_eq!(found.regime, AxialRegime::Steady);
        assert!((found.rate_of_penetration - 0.005).abs() < 1e-12);
        assert!((found.part_of_steady.unwrap() - 0.5).abs() < 1e-12);
        assert_eq!((found.off_bottom, found.at_rest), (0.0, 0.0));
        // As is what rests on its flats, or stops but once.
        assert_eq!(regime(|_| cutting(0.0)).regime, AxialRegime::Steady);
        let once = regime(|step| cutting(if step == 70 { 0.0 } else { 0.01 }));
        assert_eq!(once.regime, AxialRegime::Steady);
    }

    /// A rate that swings by A at ω: Aω, and that over √2.
    #[test]
    fn what_a_bit_feels_is_how_its_rate_changes() {
        let (swing, turns) = (0.01, 0.05);
        let found = regime(|step| cutting(0.02 + swing * (turns * step as f64).sin()));
        let acceleration = found.acceleration.unwrap();
        let expected = swing * turns;
        assert!(
            (acceleration.step_peak / expected - 1.0).abs() < 1e-3,
            "{acceleration:?}"
        );
        let whole_turn: f64 = (60..100)
            .map(|step| (turns * (f64::from(step) - 0.5)).cos().powi(2))
            .sum();
        let rms = expected * (whole_turn / 40.0).sqrt();
        assert!(
            (acceleration.step_rms / rms - 1.0).abs() < 1e-3,
            "{acceleration:?} {rms}"
        );
    }

    #[test]
    fn what_stops_while_it_turns_chatters() {
        let found = regime(|step| cutting(if step % 4 == 0 { 0.0 } else { 0.01 }));
        assert_eq!(found.regime, AxialRegime::AxialChatter);
        assert_eq!(found.at_rest, 0.25);
        // What rises or flies does not rest; the deepest blade tells how deep one cuts.
        let rises = regime(|step| CutStep {
            touches: step % 8 != 0,
            deepest_cut: 2e-3,
            ..cutting(if step % 4 == 0 { -0.01 } else { 0.01 })
        });
        assert_eq!((rises.at_rest, rises.peak_depth_of_cut), (0.0, 2e-3));
        // What stops because the bit sticks does not.
        let sticks = regime(|step| CutStep {
            speed: if step % 4 == 0 { 0.0 } else { 10.0 },
            ..cutting(if step % 4 == 0 { 0.0 } else { 0.01 })
        });
        assert_eq!(sticks.regime, AxialRegime::Steady);
    }

    #[test]
    fn what_leaves_the_rock_bounces() {
        let found = regime(|step| CutStep {
            touches: step % 10 != 0,
            ..cutting(0.01)
        });
        assert_eq!(found.regime, AxialRegime::BitBounce);
        assert_eq!(found.off_bottom, 0.1);
    }
}
