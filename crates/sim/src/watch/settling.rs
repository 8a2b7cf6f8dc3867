//! Whether whirl has settled, so that a simulation may end before its time.

use super::lateral::{LateralMeasures, SiteSums, WallWatch};
use super::rules::Rules;
use crate::laws::contact::{Contact, WallLaw};

/// One site over one window.
#[derive(Debug, Clone, Copy, Default)]
struct Window {
    sums: SiteSums,
    /// Of the radius, m².
    largest_square: f64,
    /// The largest part of the friction that rolling took.
    largest_ratio: f64,
}

/// Watches whether whirl settles.
#[derive(Debug, Clone)]
pub(crate) struct Settling {
    rules: Rules,
    window: usize,
    step: usize,
    steps: usize,
    now: Vec<Window>,
    last: Vec<Window>,
    before: Vec<Window>,
    agreeing: usize,
}

impl Settling {
    pub(crate) fn new(rules: Rules, sites: usize, sampling_frequency: f64, steps: usize) -> Self {
        let empty = || vec![Window::default(); sites];
        Self {
            window: ((rules.window * sampling_frequency).round() as usize).max(1),
            rules,
            step: 0,
            steps,
            now: empty(),
            last: empty(),
            before: empty(),
            agreeing: 0,
        }
    }

    /// Steps in which nothing touched: whirl begins anew.
    pub(crate) fn skip(&mut self, steps: usize) {
        self.step += steps;
        self.now.fill(Window::default());
        self.agreeing = 0;
    }

    /// One step; whether whirl is settled at its end.
    pub(crate) fn see<W: WallLaw>(&mut self, contacts: &[Contact], walls: &[W]) -> bool {
        for (site, contact) in contacts.iter().enumerate() {
            let [x, y] = contact.position;
            let now = &mut self.now[site];
            now.largest_square = now.largest_square.max(x * x + y * y);
            now.sums.see(contact, now.largest_square);
            now.largest_ratio = now.largest_ratio.max(contact.friction_ratio.abs());
        }
        self.step += 1;
        if self.step % self.window != 0 {
            return false;
        }
        std::mem::swap(&mut self.before, &mut self.last);
        std::mem::swap(&mut self.last, &mut self.now);
        for (now, contact) in self.now.iter_mut().zip(contacts) {
            *now = Window {
                sums: SiteSums::at(contact.position),
                ..Window::default()
            };
        }
        let any_contact = self.last.iter().any(|last| last.sums.contact > 0);
        let agrees = any_contact
            && (self.before.iter().zip(&self.last).zip(walls))
                .all(|((before, last), wall)| self.agree(before, last, wall));
        self.agreeing = if agrees { self.agreeing + 1 } else { 0 };
        self.agreeing >= self.rules.agreeing_windows
    }

    /// Whether a site is either always or never in contact, far enough from
    /// changing that, and on its way to little change.
    fn agree(&self, before: &Window, last: &Window, wall: &impl WallLaw) -> bool {
        let windows_left = (self.steps - self.step) as f64 / self.window as f64;
        let steady = |before: f64, last: f64, scale: f64| {
            (last - before).abs() * windows_left.max(1.0)
                <= self.rules.settling_tolerance * scale.abs()
        };
        let (one, other) = (&before.sums, &last.sums);
        let clearances = wall.clearance() * self.window as f64;
        let steady_radius = steady(one.radius, other.radius, clearances);
        if other.contact == 0 {
            let is_far = last.largest_square.sqrt() < self.rules.free_margin * wall.clearance();
            return one.contact == 0 && steady_radius && is_far;
        }
        let all = |count: usize| count == self.window;
        let holds = |limit: f64| last.largest_ratio < self.rules.rolling_margin * limit;
        let keeps_rolling =
            all(one.rolling) && all(other.rolling) && wall.rolling_limit().is_some_and(holds);
        let keeps_sliding = one.rolling == 0 && other.rolling == 0 && wall.slides_evenly();
        (keeps_rolling || keeps_sliding)
            && all(one.contact)
            && all(other.contact)
            && steady_radius
            && steady(
                one.turning.angle(),
                other.turning.angle(),
                other.turning.angle(),
            )
            && steady(one.normal_force, other.normal_force, other.normal_force)
    }

    /// What a watch has seen with the last window for its closing one.
    pub(crate) fn measures(&self, watch: &WallWatch) -> LateralMeasures {
        let last: Vec<SiteSums> = self.last.iter().map(|last| last.sums).collect();
        watch.measures_of(&last, self.window)
    }
}
