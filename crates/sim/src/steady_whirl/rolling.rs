//! All steady rolling whirls of a site at one surface speed: the roots of its balance.
//!
//! The range of rates is halved until the bounds on the variation of K show that a
//! part has no root, or no more than one. So none is missed, wherever the
//! resonances lie.

use super::{Balance, Sample, SteadyWhirl, WhirlingSite};

/// A part of the range of rates as narrow as this fraction of it, in which nothing
/// is certain yet, has two roots that all but coincide, or none.
const NARROWEST: f64 = 1e-9;

/// A rate is found to this fraction of itself.
const TOLERANCE: f64 = 1e-13;

impl<K: Fn(f64) -> [f64; 2]> WhirlingSite<K> {
    /// Every steady whirl of a string that turns at `surface_speed` (rad/s) and rolls
    /// along the wall, from the slowest precession to the fastest, up to a radius of a
    /// thousand clearances; none where the string presses outwards nowhere.
    pub fn rolling_at(&self, surface_speed: f64) -> Vec<SteadyWhirl> {
        let Some([slowest, fastest]) = self.rates(surface_speed) else {
            return Vec::new();
        };
        let ends = [slowest, fastest].map(|rate| self.sample(rate));
        if self.wall.stiffness.is_infinite() {
            let presses = ends[1].real < 0.0;
            return presses.then(|| self.whirl(&ends[1])).into_iter().collect();
        }
        let mut search = Search {
            site: self,
            balance: Balance::new(&self.wall, surface_speed),
            narrowest: NARROWEST * fastest,
            found: Vec::new(),
        };
        search.between([&ends[0], &ends[1]]);
        search.found
    }
}

struct Search<'a, K> {
    site: &'a WhirlingSite<K>,
    balance: Balance,
    narrowest: f64,
    found: Vec<SteadyWhirl>,
}

impl<K: Fn(f64) -> [f64; 2]> Search<'_, K> {
    fn excess(&self, sample: &Sample) -> f64 {
        sample.real + self.balance.inward(sample.rate)
    }

    /// Looks for the roots between two rates.
    fn between(&mut self, samples: [&Sample; 2]) {
        if self.has_none(samples) {
            return;
        }
        let [low, high] = samples;
        let signs = samples.map(|sample| self.excess(sample) > 0.0);
        let is_narrow = high.rate - low.rate <= self.narrowest;
        if is_narrow || self.is_monotonic(samples) {
            if signs[0] != signs[1] {
                self.close_in(low.rate, high.rate, signs[0]);
            }
            return;
        }
        let middle = self.site.sample(0.5 * (low.rate + high.rate));
        self.between([low, &middle]);
        self.between([&middle, high]);
    }

    fn has_none(&self, [low, high]: [&Sample; 2]) -> bool {
        let real = self.site.variation_above(low.rate).real_range([low, high]);
        let rates = [low.rate, high.rate];
        self.balance.is_positive(real, rates) || self.balance.is_negative(real, rates)
    }

    /// Whether the slope keeps the sign of its mean.
    fn is_monotonic(&self, [low, high]: [&Sample; 2]) -> bool {
        let width = high.rate - low.rate;
        let mean = (self.excess(high) - self.excess(low)) / width;
        let by_wall = self.balance.inward_slope(high.rate) - self.balance.inward_slope(low.rate);
        let by_string = width * self.site.variation_above(low.rate).curvature([low, high]);
        mean.abs() > by_wall + by_string
    }

    /// The root between two rates, by bisection.
    fn close_in(&mut self, mut low: f64, mut high: f64, positive_below: bool) {
        while high - low > TOLERANCE * high {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            let is_positive = self.excess(&self.site.sample(middle)) > 0.0;
            if is_positive == positive_below {
                low = middle;
            } else {
                high = middle;
            }
        }
        let sample = self.site.sample(low);
        self.found.push(self.site.whirl(&sample));
    }
}
