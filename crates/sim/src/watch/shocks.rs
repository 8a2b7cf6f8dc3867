//! What tools in the string feel: accelerations at the sites that have walls or at other places, and
//! shocks.
//!
//! An acceleration is the second difference of three steps: an impact that is shorter than these is
//! spread over them, so that its peak grows with the sampling frequency until the wall's own
//! softness rounds it.

use serde::{Deserialize, Serialize};

/// What a person would ask of the accelerations over the closing window, of the site or place where
/// the greatest sideways is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ShockMeasures {
    /// The site or place, from the surface down.
    pub site: usize,
    /// Greatest acceleration of the string's centre sideways, m/s².
    pub peak: f64,
    /// Its root mean square, m/s².
    pub rms: f64,
    /// Greatest acceleration of the string's surface along it, by which its rotation changes, m/s².
    pub tangential_peak: f64,
    /// How often the acceleration sideways rises beyond the threshold, 1/s.
    pub shocks_per_second: f64,
}

/// A place along a string, and how it moved in all steps of a closing window and the two before.
#[derive(Debug, Clone)]
pub struct ShakenPlace<'a> {
    /// Radius of the string there, m.
    pub radius: f64,
    /// Position in each step along x and along y, m, from anywhere.
    pub positions: &'a [Vec<f64>; 2],
    /// How fast it turned in each step, rad/s.
    pub speeds: Vec<f64>,
}

impl ShockMeasures {
    /// Of places along a string, sampled at a frequency (Hz), with the acceleration sideways, m/s²,
    /// beyond which a shock is counted; `None` where there are none, or no more steps than two.
    pub fn of(places: &[ShakenPlace], threshold: f64, sampling_frequency: f64) -> Option<Self> {
        let radii = places.iter().map(|place| place.radius).collect();
        let mut watch = ShockWatch::new(threshold, radii, sampling_frequency, STEPS_BEFORE);
        let steps = places.first()?.speeds.len();
        for step in 0..steps {
            let positions = places.iter().map(|place| {
                let [x, y] = place.positions;
                [x[step], y[step]]
            });
            watch.see(positions, places.iter().map(|place| place.speeds[step]));
        }
        watch.measures()
    }
}

/// Steps before there is a difference of three.
const STEPS_BEFORE: usize = 2;

/// One site.
#[derive(Debug, Clone, Copy, Default)]
struct Site {
    /// Positions in the last two steps, the latest first, m.
    positions: [[f64; 2]; 2],
    /// rad/s.
    speed: f64,
    peak_square: f64,
    sum_of_squares: f64,
    tangential_peak: f64,
    is_above: bool,
    shocks: usize,
}

/// Watches the accelerations of all sites.
#[derive(Debug, Clone)]
pub(crate) struct ShockWatch {
    /// Hz.
    sampling_frequency: f64,
    /// m/s².
    threshold: f64,
    /// Radius of the string at each site, m.
    radii: Vec<f64>,
    closing_from: usize,
    step: usize,
    sites: Vec<Site>,
}

impl ShockWatch {
    pub(crate) fn new(
        threshold: f64,
        radii: Vec<f64>,
        sampling_frequency: f64,
        closing_from: usize,
    ) -> Self {
        Self {
            sampling_frequency,
            threshold,
            sites: vec![Site::default(); radii.len()],
            radii,
            closing_from,
            step: 0,
        }
    }

    /// Where all sites were in a step, m, and how fast they turned, rad/s.
    pub(crate) fn see(
        &mut self,
        positions: impl Iterator<Item = [f64; 2]>,
        speeds: impl Iterator<Item = f64>,
    ) {
        let rate = self.sampling_frequency;
        let counts = self.step >= self.closing_from.max(STEPS_BEFORE);
        let sites = self.sites.iter_mut().zip(&self.radii);
        for ((site, radius), (position, speed)) in sites.zip(positions.zip(speeds)) {
            if counts {
                let [before, first] = site.positions;
                let square: f64 = [0, 1]
                    .map(|axis| {
                        let bend = position[axis] - 2.0 * before[axis] + first[axis];
                        (bend * rate * rate).powi(2)
                    })
                    .iter()
                    .sum();
                let tangential = radius * (speed - site.speed).abs() * rate;
                site.see(square, tangential, self.threshold * self.threshold);
            }
            site.positions = [position, site.positions[0]];
            site.speed = speed;
        }
        self.step += 1;
    }

    pub(crate) fn measures(&self) -> Option<ShockMeasures> {
        let steps = self
            .step
            .saturating_sub(self.closing_from.max(STEPS_BEFORE));
        if steps == 0 {
            return None;
        }
        let by_peak = |(_, one): &(usize, &Site), (_, other): &(usize, &Site)| {
            one.peak_square.total_cmp(&other.peak_square)
        };
        let (site, found) = self.sites.iter().enumerate().max_by(by_peak)?;
        Some(ShockMeasures {
            site,
            peak: found.peak_square.sqrt(),
            rms: (found.sum_of_squares / steps as f64).sqrt(),
            tangential_peak: found.tangential_peak,
            shocks_per_second: found.shocks as f64 * self.sampling_frequency / steps as f64,
        })
    }
}

impl Site {
    fn see(&mut self, square: f64, tangential: f64, threshold_square: f64) {
        self.peak_square = self.peak_square.max(square);
        self.sum_of_squares += square;
        self.tangential_peak = self.tangential_peak.max(tangential);
        let is_above = square > threshold_square;
        self.shocks += usize::from(is_above && !self.is_above);
        self.is_above = is_above;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Round a circle at a rate ω, r ω² sideways; a wobble of the rotation; and impacts.
    #[test]
    fn what_is_measured_is_what_was_made() {
        let (frequency, radius, rate) = (2000.0, 0.02, 30.0);
        let mut watch = ShockWatch::new(25.0, vec![0.1; 2], frequency, 2000);
        let impact = |step: usize| match step % 500 {
            0 => 1e-5,
            _ => 0.0,
        };
        for step in 0..6000 {
            let time = step as f64 / frequency;
            let (sin, cos) = (rate * time).sin_cos();
            let wobble = 8.0 + 0.5 * (100.0 * time).sin();
            let positions = [[radius * cos, radius * sin], [impact(step), 0.0]];
            watch.see(positions.into_iter(), [8.0, wobble].into_iter());
        }
        let found = watch.measures().unwrap();
        // 1e-5 m to one side and back within two steps; eight impacts in two seconds, three jerks each,
        // of which all are beyond the threshold.
        assert_eq!(found.site, 1);
        assert!((found.peak / (2e-5 * frequency * frequency) - 1.0).abs() < 1e-9);
        assert!((found.shocks_per_second - 4.0).abs() < 1e-9, "{found:?}");
        assert!((found.tangential_peak / (0.1 * 0.5 * 100.0) - 1.0).abs() < 1e-3);
        let round = watch.sites[0];
        assert!((round.peak_square.sqrt() / (radius * rate * rate) - 1.0).abs() < 1e-3);
        assert_eq!(round.shocks, 0);
        let mean = (round.sum_of_squares / 4000.0).sqrt();
        assert!((mean / (radius * rate * rate) - 1.0).abs() < 1e-3);
    }
}
