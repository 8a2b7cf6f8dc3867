//! Whether an answer obeys the laws of contact: each is checked, for rounding may have
//! left none of what was solved.

use super::bracket::Trial;
use super::contact::{Approach, Contact, ContactError, Touch};
use super::wall::Wall;

/// An answer obeys the laws of contact to this part of the distance |p_h|. Roots are
/// found to rounding: only what is no answer is further off.
const TOLERANCE: f64 = 1e-9;

/// A step with its answer.
pub(super) struct ContactResidual<'a> {
    pub(super) wall: &'a Wall,
    pub(super) approach: &'a Approach<'a>,
    /// |p_h|, m.
    pub(super) distance: f64,
    pub(super) trial: &'a Trial,
    pub(super) contact: &'a Contact,
}

impl ContactResidual<'_> {
    /// Whether an answer obeys the laws of contact; what is no number does not.
    #[inline(always)]
    pub(super) fn laws(&self) -> bool {
        let (approach, trial, contact) = (self.approach, self.trial, self.contact);
        let [cos, sin] = trial.direction;
        let on_load_line = |axis: usize| {
            let pushed = approach.free_position[axis] + approach.compliance * contact.force[axis];
            (contact.position[axis] - pushed).abs() <= TOLERANCE * self.distance
        };
        (cos * cos + sin * sin - 1.0).abs() <= TOLERANCE
            && self.distance.is_finite()
            && on_load_line(0)
            && on_load_line(1)
            && trial.normal_force >= 0.0
            && self.wall.clearance >= 0.0
            && trial.ratio.abs() <= (1.0 + TOLERANCE) * self.wall.friction
            && trial.sliding_speed.is_finite()
            && contact.torque.is_finite()
            && match contact.touch {
                Touch::Rolling => self.rolls(),
                _ => self.turns_as_tried() && (!self.wall.falls() || self.rubs_as_it_slides()),
            }
    }

    /// Whether friction is that of the sliding speed, as far as that is known, and against it.
    fn rubs_as_it_slides(&self) -> bool {
        let (ratio, speed) = (self.trial.ratio, self.trial.sliding_speed);
        let (against, speed) = (ratio.abs(), -speed * ratio.signum());
        // What is no number is in no range.
        let known = self.least_speed();
        let [slower, faster] = [speed - known, speed + known].map(|it| self.wall.friction_at(it));
        let rounding = TOLERANCE * self.wall.friction + f64::MIN_POSITIVE;
        speed >= -known && faster - rounding <= against && against <= slower + rounding
    }

    /// Whether friction turns the string as it did in the trial, which knows the way
    /// of sliding: products of numbers far too small are not what they say.
    #[inline(always)]
    fn turns_as_tried(&self) -> bool {
        let torque = self.contact.torque;
        let tried = self.wall.radius * self.trial.ratio * self.trial.normal_force;
        (tried - torque).abs() <= TOLERANCE * torque.abs()
    }

    /// Whether what rolls does not slide: by no more than a part of the speeds that
    /// meet, what all friction adds to them included, or than what a bit jumps by
    /// where it slips, for there its speed takes no value between.
    #[inline(always)]
    fn rolls(&self) -> bool {
        let (approach, trial) = (self.approach, self.trial);
        let spin = approach.spin.under(self.contact.torque);
        let ([cos, sin], [px, py]) = (trial.direction, approach.previous_position);
        let drift = (px * sin - py * cos) * approach.sampling.rate_in_step();
        let sliding_speed = self.wall.radius * spin + drift;
        sliding_speed.abs() <= self.least_speed()
    }

    /// The least speed that distinguishes sliding from rolling; NaN where the speeds that meet are.
    #[inline(always)]
    fn least_speed(&self) -> f64 {
        let (wall, approach, trial) = (self.wall, self.approach, self.trial);
        let (gives, free_speed) = (approach.spin.compliance, approach.spin.free_speed);
        let jump = approach.spin.resistance.map_or(0.0, |law| law.jump);
        // A bit that holds any torque never slips.
        let jump = if jump.is_finite() { jump } else { 0.0 };
        let [px, py] = approach.previous_position;
        let by_friction = gives * wall.radius * wall.friction * trial.normal_force;
        let turns = wall.radius * (free_speed.abs() + by_friction);
        let goes = (self.distance + px.abs() + py.abs()) * approach.sampling.rate_in_step();
        let speeds = turns.abs() + goes.abs();
        if !speeds.is_finite() {
            return f64::NAN;
        }
        let least = TOLERANCE * speeds + (1.0 + TOLERANCE) * (wall.radius * jump).abs();
        least + f64::MIN_POSITIVE
    }

    /// Why there is no answer.
    #[cold]
    pub(super) fn refusal(&self) -> ContactError {
        let [px, py] = self.approach.previous_position;
        let motion = [self.distance, px, py, self.approach.spin.free_speed];
        if motion.iter().all(|number| number.is_finite()) {
            ContactError::Unsolved
        } else {
            ContactError::NotFinite
        }
    }
}
