//! The steady whirls of a site as curves over the rate of whirl, one for each
//! range of rates in which the string presses outwards; and the whirl on them that
//! needs the least friction.
//!
//! The rates are halved until the bounds on the variation of the stiffness show
//! that nothing wanted lies between two points, or until they are close and what
//! lies midway is on their chord.

use super::{Balance, Sample, SteadyWhirl, WhirlingSite};

/// No wall has more friction: where whirl needs that, a branch ends.
pub const MOST_FRICTION: f64 = 10.0;

/// Neighbouring points are no further apart than this in the hyperbolic distance, over
/// which a resonance as sharp as damping lets it be shows no more than its curvature …
const FURTHEST: f64 = 0.5;

/// … unless less friction than this is enough between them, and any wall has it.
const LITTLE_FRICTION: f64 = 0.02;

/// What is uncertain at this distance is left as it looks.
const NEAREST: f64 = 0.02;

/// What lies midway may be off the chord by this part of the surface speed, and by
/// this in asinh(1/μ₀).
const OFF_CHORD: f64 = 1e-2;

impl<K: Fn(f64) -> [f64; 2]> WhirlingSite<K> {
    /// The steady whirls that roll at surface speeds (rad/s) in a range: a curve for
    /// each range of rates in which the string presses outwards and friction of less
    /// than [`MOST_FRICTION`] sustains whirl, from the slowest precession to the
    /// fastest. Chords between neighbouring points are within 1 % of the curve; it may
    /// end outside the range.
    pub fn branches(&self, surface_speeds: [f64; 2]) -> Vec<Vec<SteadyWhirl>> {
        let mut branches = self.trace(surface_speeds, Wanted::All).branches;
        branches.retain(|branch| branch.len() > 1);
        branches
    }

    /// The steady whirl that needs the least friction, to 1 %, of all that roll at a
    /// surface speed (rad/s) or a slower one, and slide at that; `None` where every one
    /// needs more than [`MOST_FRICTION`], or the string presses outwards nowhere.
    pub fn least_friction(&self, surface_speed: f64) -> Option<SteadyWhirl> {
        let slower = self.trace([0.0, surface_speed], Wanted::Least).branches;
        let whirls = slower
            .into_iter()
            .flatten()
            .chain(self.rolling_at(surface_speed))
            .filter(|whirl| whirl.least_friction <= MOST_FRICTION);
        whirls.min_by(|one, other| one.least_friction.total_cmp(&other.least_friction))
    }

    fn trace(&self, [slowest, fastest]: [f64; 2], wanted: Wanted) -> Trace<'_, K> {
        let mut trace = Trace {
            site: self,
            range: [slowest, fastest].map(|speed| Balance::new(&self.wall, speed)),
            wanted,
            least_pressing: MOST_FRICTION.recip().asinh(),
            branches: Vec::new(),
            is_open: false,
        };
        if let Some(ends) = self.rates(fastest) {
            let ends = ends.map(|rate| trace.point(rate));
            trace.add(&ends[0]);
            trace.between([&ends[0], &ends[1]]);
        }
        trace
    }
}

/// Which whirls are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Wanted {
    All,
    /// That which needs the least friction; those found on the way need ever less.
    Least,
}

/// A sample, and the whirl there if the string presses.
#[derive(Clone, Copy)]
struct Point {
    sample: Sample,
    pressing: f64,
    whirl: Option<SteadyWhirl>,
}

impl Point {
    /// Its rate, and how it presses there.
    fn place(&self) -> (f64, f64) {
        (self.sample.rate, self.pressing)
    }
}

struct Trace<'a, K> {
    site: &'a WhirlingSite<K>,
    /// At the slowest and the fastest surface speed.
    range: [Balance; 2],
    wanted: Wanted,
    least_pressing: f64,
    branches: Vec<Vec<SteadyWhirl>>,
    /// Whether the last branch continues.
    is_open: bool,
}

impl<K: Fn(f64) -> [f64; 2]> Trace<'_, K> {
    fn point(&self, rate: f64) -> Point {
        let sample = self.site.sample(rate);
        let pressing = sample.pressing();
        Point {
            sample,
            pressing,
            whirl: (pressing > self.least_pressing).then(|| self.site.whirl(&sample)),
        }
    }

    fn add(&mut self, point: &Point) {
        match (self.wanted, point.whirl) {
            (Wanted::All, Some(whirl)) => match self.branches.last_mut() {
                Some(branch) if self.is_open => branch.push(whirl),
                _ => self.branches.push(vec![whirl]),
            },
            (Wanted::Least, Some(whirl))
                if point.pressing > self.least_pressing
                    && whirl.surface_speed <= self.range[1].surface_speed =>
            {
                self.least_pressing = point.pressing;
                self.branches.push(vec![whirl]);
            }
            _ => {}
        }
        self.is_open = point.whirl.is_some();
    }

    /// Adds what lies above the first of two points, up to the second.
    fn between(&mut self, points: [&Point; 2]) {
        let [low, high] = points;
        let variation = self.site.variation_above(low.sample.rate);
        let distance = variation.distance(low.sample.rate, high.sample.rate);
        if self.has_none(points) {
            self.is_open = false;
            return self.add(high);
        }
        if distance < NEAREST {
            return self.add(high);
        }
        let middle = self.point(0.5 * (low.sample.rate + high.sample.rate));
        if self.wanted == Wanted::Least {
            self.add(&middle);
        }
        if self.is_settled([low, &middle, high], distance) {
            return self.add(high);
        }
        self.between([low, &middle]);
        self.between([&middle, high]);
    }

    /// Whether it is certain that nothing wanted lies between two points.
    fn has_none(&self, [low, high]: [&Point; 2]) -> bool {
        let variation = self.site.variation_above(low.sample.rate);
        let real = variation.real_range([&low.sample, &high.sample]);
        let rates = [low.sample.rate, high.sample.rate];
        let [slowest, fastest] = &self.range;
        variation.pressing_range([low, high].map(Point::place))[1] <= self.least_pressing
            || slowest.is_positive(real, rates)
            || fastest.is_negative(real, rates)
    }

    /// Whether three points in a row are close enough, and straight enough, to show
    /// what lies between them.
    fn is_settled(&self, points: [&Point; 3], distance: f64) -> bool {
        let [low, middle, high] = points.map(|point| point.pressing);
        let is_straight = (middle - 0.5 * (low + high)).abs() <= OFF_CHORD;
        let ends = [points[0], points[2]].map(Point::place);
        let variation = self.site.variation_above(points[0].sample.rate);
        let [least, _] = variation.pressing_range(ends);
        let is_close = distance <= FURTHEST || least.sinh() > LITTLE_FRICTION.recip();
        match self.wanted {
            Wanted::Least => is_straight && is_close,
            Wanted::All => {
                let [Some(low), Some(middle), Some(high)] = points.map(|point| point.whirl) else {
                    return false;
                };
                let mean = 0.5 * (low.surface_speed + high.surface_speed);
                let speed_is_straight = (middle.surface_speed - mean).abs() <= OFF_CHORD * mean;
                is_straight && is_close && speed_is_straight && least > self.least_pressing
            }
        }
    }
}
