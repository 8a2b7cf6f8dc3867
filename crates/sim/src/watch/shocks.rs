//! What tools in the string feel: accelerations at the sites that have walls or at other places, and
//! shocks.
//!
//! An acceleration between steps is the second difference of three: an impact that is shorter than these
//! is spread over them, so that its peak grows with the sampling frequency until the wall's own
//! softness rounds it. A sensor records it within its [band](super::band), in the directions that do
//! not turn with the string, and within that it does not depend on the steps.

use serde::{Deserialize, Serialize};

use super::band::{
    AccelerationSums, DifferenceOf, Filtered, InBand, LowPass, USUAL_BAND, steps_to_settle,
};

/// What a person would ask of the accelerations over the closing window, of the site or place where
/// the greatest sideways within its band is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ShockMeasures {
    /// The site or place, from the surface down.
    pub site: usize,
    /// Acceleration of the string's centre sideways; `None` in records of earlier versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sideways: Option<InBand>,
    /// Acceleration of the string's surface along it, by which its rotation changes; `None` there, too.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tangential: Option<InBand>,
    /// How often the acceleration sideways rises beyond the threshold, 1/s.
    pub shocks_per_second: f64,
    /// Greatest acceleration sideways between steps, m/s²: grows with the sampling frequency.
    #[serde(alias = "peak")]
    pub step_peak: f64,
    /// Its root mean square, m/s².
    #[serde(alias = "rms")]
    pub step_rms: f64,
    /// Greatest acceleration along the surface between steps, m/s².
    #[serde(alias = "tangential_peak")]
    pub tangential_step_peak: f64,
}

/// A place along a string, and how it moved in all steps of a closing window and those before that its
/// filter needs.
#[derive(Debug, Clone)]
pub struct ShakenPlace<'a> {
    /// Radius of the string there, m.
    pub radius: f64,
    /// The band of its sensor, Hz.
    pub band: f64,
    /// Position in each step along x and along y, m, from anywhere.
    pub positions: &'a [Vec<f64>; 2],
    /// How fast it turned in each step, rad/s.
    pub speeds: Vec<f64>,
}

impl ShockMeasures {
    /// Of places along a string, sampled at a frequency (Hz), with the acceleration sideways, m/s²,
    /// beyond which a shock is counted, in all steps from one on; `None` where there are no places, or no
    /// such steps.
    pub fn of(
        places: &[ShakenPlace],
        threshold: f64,
        (sampling_frequency, from): (f64, usize),
    ) -> Option<Self> {
        let sites = places.iter().map(|place| (place.radius, place.band));
        let mut watch = ShockWatch::new(threshold, sites, sampling_frequency, from);
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

    /// Steps before a window that the filters of some bands (Hz) have to see, for nothing of their
    /// start to be left in it.
    pub fn steps_before(bands: &[f64], sampling_frequency: f64) -> usize {
        let settling = bands
            .iter()
            .map(|band| steps_to_settle(*band, sampling_frequency));
        STEPS_BEFORE + settling.max().unwrap_or(0)
    }
}

/// Steps before there is a difference of three.
const STEPS_BEFORE: usize = 2;

/// One site.
#[derive(Debug, Clone)]
struct Site {
    /// Radius of the string, m.
    radius: f64,
    filter: LowPass,
    /// Positions in the last two steps, the latest first, m.
    positions: [[f64; 2]; 2],
    /// rad/s.
    speed: f64,
    /// x, y and along the surface.
    filtered: [Filtered; 3],
    /// Within the band, sideways and along the surface.
    in_band: [AccelerationSums; 2],
    /// The same between steps.
    in_steps: [AccelerationSums; 2],
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
    closing_from: usize,
    step: usize,
    sites: Vec<Site>,
}

impl ShockWatch {
    /// Sites by the radius of the string (m) and the band of the sensor (Hz).
    pub(crate) fn new(
        threshold: f64,
        sites: impl Iterator<Item = (f64, f64)>,
        sampling_frequency: f64,
        closing_from: usize,
    ) -> Self {
        let site = |(radius, band)| Site {
            radius,
            filter: LowPass::new(band, sampling_frequency),
            positions: [[0.0; 2]; 2],
            speed: 0.0,
            filtered: [Filtered::default(); 3],
            in_band: [AccelerationSums::default(); 2],
            in_steps: [AccelerationSums::default(); 2],
            is_above: false,
            shocks: 0,
        };
        Self {
            sampling_frequency,
            threshold,
            closing_from,
            step: 0,
            sites: sites.map(site).collect(),
        }
    }

    /// Sites of a string of these radii (m), each with a sensor of the usual band.
    pub(crate) fn at_sites(
        threshold: f64,
        radii: impl Iterator<Item = f64>,
        sampling_frequency: f64,
        closing_from: usize,
    ) -> Self {
        let sites = radii.map(|radius| (radius, USUAL_BAND));
        Self::new(threshold, sites, sampling_frequency, closing_from)
    }

    /// Where all sites were in a step, m, and how fast they turned, rad/s.
    pub(crate) fn see(
        &mut self,
        positions: impl Iterator<Item = [f64; 2]>,
        speeds: impl Iterator<Item = f64>,
    ) {
        let counts = self.step >= self.closing_from;
        let motions = positions.zip(speeds);
        for (site, (position, speed)) in self.sites.iter_mut().zip(motions) {
            if self.step >= STEPS_BEFORE {
                let threshold = counts.then_some(self.threshold);
                site.see((position, speed), self.sampling_frequency, threshold);
            }
            site.positions = [position, site.positions[0]];
            site.speed = speed;
        }
        self.step += 1;
    }

    pub(crate) fn measures(&self) -> Option<ShockMeasures> {
        let by_peak = |(_, one): &(usize, &Site), (_, other): &(usize, &Site)| {
            let [one, other] = [one, other].map(|site| site.in_band[0].peak_square);
            one.total_cmp(&other)
        };
        let (index, site) = self.sites.iter().enumerate().max_by(by_peak)?;
        let steps = self
            .step
            .saturating_sub(self.closing_from.max(STEPS_BEFORE));
        let [sideways, tangential] = site.in_band.map(|sums| sums.within(&site.filter));
        let [[step_peak, step_rms], [tangential_step_peak, _]] =
            [site.in_steps[0].measures()?, site.in_steps[1].measures()?];
        Some(ShockMeasures {
            site: index,
            sideways,
            tangential,
            shocks_per_second: site.shocks as f64 * self.sampling_frequency / steps as f64,
            step_peak,
            step_rms,
            tangential_step_peak,
        })
    }
}

impl Site {
    /// The next step of a motion; what it measures counts where a threshold is given.
    fn see(&mut self, (position, speed): ([f64; 2], f64), rate: f64, threshold: Option<f64>) {
        let [before, first] = self.positions;
        let bent = |axis: usize| {
            let bend = position[axis] - 2.0 * before[axis] + first[axis];
            bend * rate * rate
        };
        let along = self.radius * (speed - self.speed) * rate;
        let steps = [bent(0), bent(1), along];
        let filter = self.filter;
        let [x, y, tangential] = &mut self.filtered;
        let in_band = [
            filter.pass(x, steps[0], DifferenceOf::Positions),
            filter.pass(y, steps[1], DifferenceOf::Positions),
            filter.pass(tangential, steps[2], DifferenceOf::Speeds),
        ];
        let Some(threshold) = threshold else {
            return;
        };
        let squares = |[x, y, along]: [f64; 3]| [x * x + y * y, along * along];
        for (sums, square) in self.in_band.iter_mut().zip(squares(in_band)) {
            sums.add_in_band(square);
        }
        for (sums, square) in self.in_steps.iter_mut().zip(squares(steps)) {
            sums.add(square);
        }
        let is_above = in_band[0].hypot(in_band[1]) > threshold;
        self.shocks += usize::from(is_above && !self.is_above);
        self.is_above = is_above;
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    const BAND: f64 = 100.0;

    /// |H| of the filter at a frequency, Hz: 15/|s³ + 6 s² + 15 s + 15|.
    fn left_at(frequency: f64) -> f64 {
        let s = 1.755_672_368_681_21 * frequency / BAND;
        15.0 / (15.0 - 6.0 * s * s).hypot(15.0 * s - s.powi(3))
    }

    fn measured(
        frequency: f64,
        motion: impl Fn(f64) -> ([f64; 2], f64),
        threshold: f64,
    ) -> ShockMeasures {
        let mut watch = ShockWatch::at_sites(
            threshold,
            std::iter::once(0.1),
            frequency,
            (2.0 * frequency) as usize,
        );
        for step in 0..(4.0 * frequency) as usize {
            let (position, speed) = motion(step as f64 / frequency);
            watch.see([position].into_iter(), [speed].into_iter());
        }
        watch.measures().unwrap()
    }

    /// Rolling round a circle at a rate ω: r ω² of what the band leaves at ω, at any sampling frequency,
    /// and as much in its root mean square; a wobble of the rotation with as much along the surface.
    #[test]
    fn what_goes_round_has_the_acceleration_of_its_circle_at_any_frequency() {
        for turns in [5.0, 18.5, 44.0, 75.0] {
            let (radius, rate) = (0.005, TAU * turns);
            let motion = |time: f64| {
                let (sin, cos) = (rate * time).sin_cos();
                ([radius * cos, radius * sin], 8.0 + 0.5 * sin)
            };
            let sideways = left_at(turns) * radius * rate * rate;
            let along = left_at(turns) * 0.1 * 0.5 * rate;
            for (frequency, within) in [
                (640.0, 0.02),
                (1280.0, 2e-3),
                (2560.0, 5e-4),
                (5120.0, 2e-4),
            ] {
                let found = measured(frequency, motion, 1e9);
                let (in_band, tangential) = (found.sideways.unwrap(), found.tangential.unwrap());
                for (measured, expected) in [
                    (in_band.peak, sideways),
                    (in_band.rms, sideways),
                    (tangential.rms, along / 2f64.sqrt()),
                ] {
                    assert!(
                        (measured / expected - 1.0).abs() < within,
                        "{turns} /s at {frequency} Hz: {measured} {expected}"
                    );
                }
                assert_eq!((in_band.band, found.shocks_per_second), (BAND, 0.0));
            }
        }
    }

    /// An impact of a velocity within a step: between steps its acceleration grows with the sampling
    /// frequency, within the band it does not, and is one shock.
    #[test]
    fn an_impact_has_the_same_peak_in_its_band_at_any_frequency() {
        // To one side and back, four times in two seconds: jumps of 0.2 m/s.
        let motion = |time: f64| {
            let phase = (2.0 * time + 0.013).fract();
            ([0.1 * (phase - 0.5).abs(), 0.0], 0.0)
        };
        let all =
            [640.0, 1280.0, 2560.0, 5120.0].map(|frequency| measured(frequency, motion, 25.0));
        let [coarse, .., fine] = all;
        assert!(fine.step_peak > 5.0 * coarse.step_peak, "{all:?}");
        let peaks = all.map(|found| found.sideways.unwrap().peak);
        let rms = all.map(|found| found.sideways.unwrap().rms);
        for ((peak, rms_here), within) in peaks.iter().zip(rms).zip([0.05, 0.03, 0.01, 0.0]) {
            assert!((peak / peaks[3] - 1.0).abs() <= within, "{peaks:?}");
            assert!((rms_here / rms[3] - 1.0).abs() <= within, "{rms:?}");
        }
        assert!(
            all.iter()
                .all(|found| (found.shocks_per_second - 4.0).abs() < 0.51)
        );
    }
}
