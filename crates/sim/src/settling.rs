//! When a simulation may end before its time: when the rest is certain, or when
//! whirl has settled.

use crate::laws::wall::{Contact, Wall};
use crate::whirl::{LateralMeasures, SiteSums, WallWatch};

/// What a simulation may leave out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stopping {
    /// Nothing: every step to the end of the time.
    Full,
    /// What is certain is not stepped, and settled motion ends it.
    Early,
    /// As [`Stopping::Early`], but settled motion is followed to the end, to see
    /// whether it was settled.
    Checked,
}

/// Why a simulation ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// At the end of its time.
    End,
    /// The rest was known: out of contact the string is linear, and its future
    /// reaches no wall.
    Certain,
    /// Nothing changed any more, to [`SETTLING_TOLERANCE`].
    Settled,
}

impl Ended {
    /// The word in result files.
    pub fn name(self) -> &'static str {
        match self {
            Ended::End => "end",
            Ended::Certain => "certain",
            Ended::Settled => "settled",
        }
    }
}

/// Whirl has settled if radius, rate and force, going on to change as they did
/// lately, change by no more than this until the end of the time: the radius in
/// parts of the clearance, the others of themselves.
pub const SETTLING_TOLERANCE: f64 = 1e-2;

/// Means are taken over this time, s.
const WINDOW: f64 = 0.25;

/// Means that have to agree, one after the other.
const AGREEING_WINDOWS: usize = 4;

/// A rolling site that settles keeps this far from sliding.
const ROLLING_MARGIN: f64 = 0.98;

/// A free site that settles keeps this far from the wall.
const FREE_MARGIN: f64 = 0.95;

/// One site over one window.
#[derive(Debug, Clone, Copy, Default)]
struct Window {
    sums: SiteSums,
    largest_radius: f64,
    /// The largest part of the friction that rolling took.
    largest_ratio: f64,
}

/// Watches whether whirl settles.
#[derive(Debug, Clone)]
pub(crate) struct Settling {
    window: usize,
    step: usize,
    steps: usize,
    now: Vec<Window>,
    last: Vec<Window>,
    before: Vec<Window>,
    agreeing: usize,
    positions: Vec<[f64; 2]>,
}

impl Settling {
    pub(crate) fn new(sites: usize, step_length: f64, steps: usize) -> Self {
        let empty = || vec![Window::default(); sites];
        Self {
            window: ((WINDOW / step_length).round() as usize).max(1),
            step: 0,
            steps,
            now: empty(),
            last: empty(),
            before: empty(),
            agreeing: 0,
            positions: vec![[0.0; 2]; sites],
        }
    }

    /// Steps in which nothing touched: whirl begins anew.
    pub(crate) fn skip(&mut self, steps: usize) {
        self.step += steps;
        self.now.fill(Window::default());
        self.agreeing = 0;
    }

    /// One step; whether whirl is settled at its end.
    pub(crate) fn see(&mut self, contacts: &[Contact], walls: &[Wall]) -> bool {
        for (site, contact) in contacts.iter().enumerate() {
            let [x, y] = contact.position;
            let before = std::mem::replace(&mut self.positions[site], contact.position);
            let now = &mut self.now[site];
            now.largest_radius = now.largest_radius.max((x * x + y * y).sqrt());
            now.sums.see(contact, before, now.largest_radius);
            now.largest_ratio = now.largest_ratio.max(contact.friction_ratio.abs());
        }
        self.step += 1;
        if !self.step.is_multiple_of(self.window) {
            return false;
        }
        std::mem::swap(&mut self.before, &mut self.last);
        std::mem::swap(&mut self.last, &mut self.now);
        self.now.fill(Window::default());
        let any_contact = self.last.iter().any(|last| last.sums.contact > 0);
        let agrees = any_contact
            && (self.before.iter().zip(&self.last).zip(walls))
                .all(|((before, last), wall)| self.agree(before, last, wall));
        self.agreeing = if agrees { self.agreeing + 1 } else { 0 };
        self.agreeing >= AGREEING_WINDOWS
    }

    /// Whether a site is either always or never in contact, far enough from
    /// changing that, and on its way to little change.
    fn agree(&self, before: &Window, last: &Window, wall: &Wall) -> bool {
        let windows_left = (self.steps - self.step) as f64 / self.window as f64;
        let steady = |before: f64, last: f64, scale: f64| {
            (last - before).abs() * windows_left.max(1.0) <= SETTLING_TOLERANCE * scale.abs()
        };
        let (one, other) = (&before.sums, &last.sums);
        let clearances = wall.clearance * self.window as f64;
        let steady_radius = steady(one.radius, other.radius, clearances);
        if other.contact == 0 {
            let is_far = last.largest_radius < FREE_MARGIN * wall.clearance;
            return one.contact == 0 && steady_radius && is_far;
        }
        let all = |count: usize| count == self.window;
        let keeps_rolling = all(one.rolling)
            && all(other.rolling)
            && last.largest_ratio < ROLLING_MARGIN * wall.friction;
        let keeps_sliding = one.rolling == 0 && other.rolling == 0;
        (keeps_rolling || keeps_sliding)
            && all(one.contact)
            && all(other.contact)
            && steady_radius
            && steady(one.angle, other.angle, other.angle)
            && steady(one.normal_force, other.normal_force, other.normal_force)
    }

    /// What a watch has seen with the last window for its closing one.
    pub(crate) fn measures(&self, watch: &WallWatch) -> LateralMeasures {
        let last: Vec<SiteSums> = self.last.iter().map(|last| last.sums).collect();
        watch.measures_of(&last, self.window)
    }
}
