//! How a string that lies in its hole climbs its wall and swings there.
//!
//! The angle of a site is counted from the low side, positive where it climbs: against the
//! rotation, as friction takes it.

use std::f64::consts::TAU;

use super::turning::Turning;
use crate::laws::contact::Contact;
use crate::lying::Lying;

/// Angles kept of the closing window at each site, at most: a swing is far slower.
const KEPT: usize = 4096;

/// How one site swung over the closing window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Swing {
    /// Mean angle, rad, within half a turn of the low side.
    pub(crate) climb: f64,
    /// Half of what lies between the least and the greatest angle, rad.
    pub(crate) amplitude: f64,
    /// Hz; zero where it does not swing through its mean angle and back.
    pub(crate) frequency: f64,
    /// Turns round the hole, positive where it climbs on.
    pub(crate) turns: f64,
    /// Whether it swings less than in any window of that length before, and ever less in this one.
    pub(crate) falls: bool,
}

/// Windows as long as the closing one, one after the other.
#[derive(Debug, Clone)]
struct Windows {
    /// Steps, least and greatest angle of the present one, rad.
    steps: usize,
    least: f64,
    greatest: f64,
    /// The least amplitude in one of them, rad.
    narrowest: f64,
}

impl Default for Windows {
    fn default() -> Self {
        Self {
            steps: 0,
            least: f64::INFINITY,
            greatest: f64::NEG_INFINITY,
            narrowest: f64::INFINITY,
        }
    }
}

impl Windows {
    /// An angle, a number of steps before the closing window, which has `window` steps.
    fn see(&mut self, angle: f64, before: usize, window: usize) {
        self.steps += 1;
        self.least = self.least.min(angle);
        self.greatest = self.greatest.max(angle);
        if before % window != 0 {
            return;
        }
        // The first may not be whole.
        let is_whole = self.steps == window;
        let amplitude = 0.5 * (self.greatest - self.least);
        *self = Self {
            narrowest: match is_whole {
                true => self.narrowest.min(amplitude),
                false => self.narrowest,
            },
            ..Self::default()
        };
    }
}

/// The angles of all sites.
#[derive(Debug, Clone)]
pub(crate) struct SwingWatch {
    /// 1 where climbing turns the centre with the clock, else −1.
    climbs: f64,
    /// Angle at which each site was first, and how it has turned since.
    sites: Vec<(f64, Turning)>,
    /// Greatest angle away from the low side so far, rad.
    furthest: Vec<f64>,
    closing_from: usize,
    /// Steps of the closing window.
    window: usize,
    /// Windows of that length before it.
    before: Vec<Windows>,
    stride: usize,
    /// Of the closing window, at every `stride`th step, site by site.
    angles: Vec<Vec<f64>>,
}

impl SwingWatch {
    /// Of a string whose surface turns so, over a number of steps of which the closing window are
    /// the last.
    pub(crate) fn new(
        lying: &Lying,
        surface_speed: f64,
        steps: usize,
        closing_from: usize,
    ) -> Self {
        let climbs = if surface_speed < 0.0 { -1.0 } else { 1.0 };
        let begins = |(&[x, y], low): (&[f64; 2], &f64)| {
            let angle = climbs * within_half_a_turn(low - y.atan2(x));
            (angle, Turning::at([x, y]))
        };
        let sites: Vec<_> = (lying.positions.iter().zip(&lying.low_side))
            .map(begins)
            .collect();
        let window = steps.saturating_sub(closing_from);
        Self {
            climbs,
            furthest: sites.iter().map(|(angle, _)| angle.abs()).collect(),
            closing_from,
            window,
            before: vec![Windows::default(); sites.len()],
            stride: window.div_ceil(KEPT).max(1),
            angles: vec![Vec::with_capacity(window.min(KEPT)); sites.len()],
            sites,
        }
    }

    /// Bytes of a number of sites.
    pub(crate) fn bytes(sites: usize) -> f64 {
        (sites * KEPT * size_of::<f64>()) as f64
    }

    /// What a site did in a step; the square of its largest radius so far is given, m².
    pub(crate) fn see(&mut self, step: usize, site: usize, contact: &Contact, square: f64) {
        let (first, turning) = &mut self.sites[site];
        turning.go(contact.position, square);
        let angle = *first - self.climbs * turning.angle();
        self.furthest[site] = self.furthest[site].max(angle.abs());
        if step < self.closing_from {
            self.before[site].see(angle, self.closing_from - 1 - step, self.window);
        } else if (step - self.closing_from) % self.stride == 0 {
            self.angles[site].push(angle);
        }
    }

    /// Greatest angle away from the low side so far, rad.
    pub(crate) fn furthest(&self, site: usize) -> f64 {
        self.furthest[site]
    }

    /// How a site swung over the closing window, seen at this frequency, Hz; what falls does so by more than
    /// this part.
    pub(crate) fn of_site(&self, site: usize, sampling_frequency: f64, tolerance: f64) -> Swing {
        let angles = &self.angles[site];
        let (Some(begins), Some(ends)) = (angles.first(), angles.last()) else {
            return Swing {
                climb: 0.0,
                amplitude: 0.0,
                frequency: 0.0,
                turns: 0.0,
                falls: false,
            };
        };
        let mean = angles.iter().sum::<f64>() / angles.len() as f64;
        let amplitude = half_range(angles);
        let (first, second) = angles.split_at(angles.len() / 2);
        let is_less = |one: f64, other: f64| one < (1.0 - tolerance) * other;
        Swing {
            climb: within_half_a_turn(mean),
            amplitude,
            frequency: crossings_per_sample(angles, mean, amplitude) * sampling_frequency
                / self.stride as f64,
            turns: (ends - begins) / TAU,
            falls: is_less(amplitude, self.before[site].narrowest)
                && is_less(half_range(second), half_range(first)),
        }
    }
}

/// Half of what lies between the least and the greatest of some angles.
fn half_range(angles: &[f64]) -> f64 {
    let least = angles.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = angles.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    0.5 * (greatest - least)
}

/// How often a series passes its mean upwards, per sample: between the first and the last time.
/// Only what comes from a twentieth of the amplitude below counts, so that ripples do not.
fn crossings_per_sample(angles: &[f64], mean: f64, amplitude: f64) -> f64 {
    let mut was_below = false;
    let (mut first, mut last, mut count) = (0.0, 0.0, 0);
    for (index, pair) in angles.windows(2).enumerate() {
        let [before, now] = [pair[0] - mean, pair[1] - mean];
        was_below |= before < -0.05 * amplitude;
        if !was_below || before >= 0.0 || now < 0.0 {
            continue;
        }
        let at = index as f64 + before / (before - now);
        if count == 0 {
            first = at;
        }
        (last, count, was_below) = (at, count + 1, false);
    }
    if count < 2 {
        return 0.0;
    }
    f64::from(count - 1) / (last - first)
}

/// The same direction, within half a turn, rad.
fn within_half_a_turn(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// A site that is at these angles from the low side, which is at an angle, for 20 s, of which
    /// the last 5 are the closing window, seen 500 times a second.
    fn seen(low: f64, speed: f64, angle: impl Fn(f64) -> f64) -> (Swing, f64) {
        let place = |time: f64| {
            let (sin, cos) = (low - speed.signum() * angle(time)).sin_cos();
            [0.02 * cos, 0.02 * sin]
        };
        let lying = Lying {
            positions: vec![place(0.0)],
            forces: vec![[0.0; 2]],
            torques: vec![0.0],
            low_side: vec![low],
        };
        let (steps, closing_from) = (10_000, 7500);
        let mut watch = SwingWatch::new(&lying, speed, steps, closing_from);
        for step in 0..steps {
            let contact = Contact {
                position: place(step as f64 / 500.0),
                ..Contact::NONE
            };
            watch.see(step, 0, &contact, 4e-4);
        }
        (watch.of_site(0, 500.0, 0.01), watch.furthest(0))
    }

    #[test]
    fn a_swing_is_found_about_any_low_side_either_way_round() {
        for (low, speed) in [(PI, 6.0), (PI, -6.0), (0.3, 6.0), (-3.0, -6.0)] {
            let (swing, furthest) = seen(low, speed, |time| {
                0.3 + 0.05 * (TAU * 1.53 * time).sin() + 0.001 * (TAU * 40.0 * time).cos()
            });
            assert!((swing.climb - 0.3).abs() < 2e-3, "{swing:?}");
            assert!((swing.amplitude - 0.0505).abs() < 6e-4, "{swing:?}");
            assert!((swing.frequency - 1.53).abs() < 2e-3, "{swing:?}");
            assert!(swing.turns.abs() < 0.05, "{swing:?}");
            assert!((furthest - 0.351).abs() < 1e-3);
        }
    }

    /// A swing of which the closing window has the end of a beat is no narrower than the beat before.
    #[test]
    fn a_swing_falls_that_is_less_than_ever() {
        let falls = |amplitude: fn(f64) -> f64| {
            let angle = |time: f64| 0.3 + amplitude(time) * (TAU * 1.53 * time).sin();
            seen(PI, 6.0, angle).0.falls
        };
        assert!(falls(|time| 0.3 * (-0.1 * time).exp()));
        assert!(!falls(|_| 0.3));
        assert!(!falls(|time| 0.01 * (0.1 * time).exp()));
        assert!(!falls(|time| 0.3 * (TAU * 0.05 * (time - 5.0)).cos()));
    }

    #[test]
    fn what_goes_round_has_turns_and_what_lies_still_has_no_frequency() {
        let (round, _) = seen(PI, 6.0, |time| TAU * 3.6 * time);
        assert!((round.turns - 18.0).abs() < 0.02, "{round:?}");
        let (forward, _) = seen(PI, 6.0, |time| -TAU * 1.0 * time);
        assert!((forward.turns + 5.0).abs() < 0.02, "{forward:?}");
        let (still, furthest) = seen(PI, 6.0, |_| 0.2);
        assert_eq!((still.frequency, still.amplitude < 1e-12), (0.0, true));
        assert!((furthest - 0.2).abs() < 1e-12);
    }
}
