//! Sliding where friction falls with the speed: the friction that a trial takes must be that of
//! the speed at which it slides.
//!
//! The less friction holds it, the faster it slides, and the less friction holds it: up to three
//! ratios agree. Friedlander's rule takes that of the previous motion: a contact that slid fast
//! continues to while it can, at the fastest of them; all else rolls while it can, and slides at
//! the slowest. Fast is beyond v_s/√2, where the curve is steepest: what lies between the branches
//! does not last, and is where the curve is steeper than the string's answer.

use super::ContactStep;
use crate::laws::bracket::{RATIO_TOLERANCE, Trial, zero_between};
use crate::laws::contact::{Contact, ContactError, Touch};
use crate::laws::wall::Wall;

/// Friction and that of the sliding speed agree to this part of the coefficient: a hundred
/// times rounding.
const SAME: f64 = 1e-14;

/// Secants to a ratio: close to where two are one each takes a third of what is left.
const MOST_SECANTS: usize = 50;

/// A trial of sliding one way.
#[derive(Clone, Copy)]
struct Slide {
    trial: Trial,
    /// Friction against it, in parts of the normal force.
    against: f64,
    /// Sliding speed, m/s, that way.
    speed: f64,
    /// By how much the friction of that speed is more than that against it.
    more: f64,
}

impl Slide {
    /// The ratio at which the line through both trials has no more.
    fn secant(&self, other: &Slide) -> Option<f64> {
        let slope = (other.more - self.more) / (other.against - self.against);
        (slope < 0.0).then(|| other.against - other.more / slope)
    }
}

impl ContactStep<'_> {
    /// The answer of a wall whose friction falls.
    #[cold]
    pub(super) fn meet_falling(&self) -> Result<Contact, ContactError> {
        if let Some(fast) = self.fast() {
            return self.contact(fast, Touch::Sliding, self.slides_either_way());
        }
        let constant = Wall {
            dynamic_ratio: 1.0,
            ..*self.wall
        };
        let held = constant.meet_at(self.approach)?;
        // What all friction does not hold slides against less.
        if held.touch != Touch::Sliding || held.sliding_speed == 0.0 {
            return Ok(held);
        }
        let slow = self.slow(self.trial(held.friction_ratio));
        self.contact(slow, Touch::Sliding, held.ambiguous)
    }

    /// The solution that continues fast sliding, if there is one. A site that arrives at the wall
    /// slides as it would without friction.
    ///
    /// From the least friction up: beyond v_s/√2 the curve is convex, and secants stay on the
    /// side that they are on.
    fn fast(&self) -> Option<Trial> {
        let before =
            (self.approach.previous_sliding_speed).unwrap_or_else(|| self.trial(0.0).sliding_speed);
        if !self.wall.is_fast(before.abs()) {
            return None;
        }
        let slide = |against: f64| self.slide(before.signum(), against);
        let mut last = slide(self.wall.dynamic_friction());
        let mut next = last;
        for _ in 0..MOST_SECANTS {
            if !self.wall.is_fast(next.speed) {
                return None;
            }
            if next.more.abs() <= SAME * self.wall.friction {
                return Some(next.trial);
            }
            if next.more < 0.0 {
                return Some(self.between(last, next));
            }
            let against = if next.against == last.against {
                next.against + next.more
            } else {
                last.secant(&next)?
            };
            (last, next) = (next, slide(against));
        }
        None
    }

    /// What slides, all friction being against it, with that of its speed: the slowest.
    ///
    /// From the most friction down: up to v_s/√2 the curve is concave, and secants stay on the
    /// side that they are on; beyond there is one ratio left.
    fn slow(&self, held: Trial) -> Trial {
        let direction = held.sliding_speed.signum();
        let slide = |against: f64| self.slide(direction, against);
        let mut last = self.as_slide(direction, held);
        let mut next = last;
        for _ in 0..MOST_SECANTS {
            if next.more.abs() <= SAME * self.wall.friction {
                return next.trial;
            }
            if next.more > 0.0 {
                return self.between(next, last);
            }
            let against = if next.against == last.against {
                Some(next.against + next.more)
            } else {
                last.secant(&next)
            };
            let Some(against) = against.filter(|_| !self.wall.is_fast(next.speed)) else {
                break;
            };
            (last, next) = (next, slide(against));
        }
        self.between(slide(self.wall.dynamic_friction()), next)
    }

    /// Whether friction either way leaves the string sliding against it.
    fn slides_either_way(&self) -> bool {
        let friction = self.wall.friction;
        !self.has_one_answer()
            && self.trial(-friction).sliding_speed > 0.0
            && self.trial(friction).sliding_speed < 0.0
    }

    fn slide(&self, direction: f64, against: f64) -> Slide {
        self.as_slide(direction, self.trial(-direction * against))
    }

    fn as_slide(&self, direction: f64, trial: Trial) -> Slide {
        let against = -direction * trial.ratio;
        let speed = direction * trial.sliding_speed;
        Slide {
            trial,
            against,
            speed,
            more: self.wall.friction_at(speed) - against,
        }
    }

    /// Where friction and speed agree, between a trial with too little friction and one with
    /// too much.
    fn between(&self, little: Slide, much: Slide) -> Trial {
        let direction = -much.trial.ratio.signum();
        let tolerance = RATIO_TOLERANCE * self.wall.friction;
        let more = |trial: &Trial| self.as_slide(direction, *trial).more;
        let trial = |ratio| self.trial(ratio);
        zero_between(little.trial, much.trial, tolerance, more, trial)
    }
}

#[cfg(test)]
mod tests;
