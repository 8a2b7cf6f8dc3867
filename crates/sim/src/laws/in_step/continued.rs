//! The wall met in the middle of a step by a site that continues as it moved: it slid and slides the same
//! way, or rolled and rolls. Newton's method, in the position or, along the direction in which it
//! rolls, in the distance from the centre, most often needs one or two evaluations of the law.

use super::super::contact::{Approach, Contact, Touch};
use super::super::contact_step::ContactStep;
use super::super::wall::Wall;
use super::length;

/// Newton's steps end where the square of one, and so what is left, is less than this part of the depth
/// times the distance from the centre.
const CLOSE: f64 = 1e-14;

/// What has not been found in this number of steps is looked for as anything else is.
const MOST_STEPS: usize = 8;

/// A step of a site that was on the wall at its beginning.
struct Continued<'a> {
    wall: &'a Wall,
    approach: &'a Approach<'a>,
    /// |p_h|, m.
    distance: f64,
    /// Distance from the centre at the beginning, m.
    before: f64,
    /// The square root of the depth there.
    root: f64,
}

/// The mean force of the wall in a step, N, and its slopes, N/m.
struct MeanForce {
    normal: f64,
    /// With the distance of the middle from the centre.
    by_middle: f64,
    /// With that of the end.
    by_end: f64,
    /// How deep the end is, m.
    depth: f64,
}

impl Wall {
    /// The answer where the site continues as it moved; `None` where it does anything else, other answers
    /// are not excluded, or the law is not one that this is written for.
    #[inline]
    pub(super) fn continues(&self, approach: &Approach) -> Option<Contact> {
        let slid = approach.previous_sliding_speed?;
        let is_written = self.stiffness.is_finite()
            && approach.spin.resistance.is_none()
            && approach.sampling.collocation_offset == 0.5
            && !self.falls();
        let before = length(approach.previous_position);
        let depth = before - self.clearance;
        if !(is_written && depth > 0.0) {
            return None;
        }
        let step = Continued {
            wall: self,
            approach,
            distance: length(approach.free_position),
            before,
            root: depth.sqrt(),
        };
        let (contact, depth) = match slid == 0.0 {
            true => step.rolls_on()?,
            false => step.slides_on(slid)?,
        };
        step.is_only_one(length(contact.position), depth)
            .then_some(contact)
    }
}

impl Continued<'_> {
    /// F_N = 2 r (V₁ − V₀)/(r₁² − r₀²) with its slopes; `None` off the wall.
    #[inline(always)]
    fn mean_force(&self, middle: f64, end: f64) -> Option<MeanForce> {
        let depth = end - self.wall.clearance;
        if depth <= 0.0 {
            return None;
        }
        let (one, other) = (self.root, depth.sqrt());
        let (square, product) = (one * one, one * other);
        let per_roots = (one + other).recip();
        // The difference of fifth powers over that of the squares, without cancellation.
        let fourths = square * square + depth * depth + product * (square + product + depth);
        let steepness = fourths * per_roots;
        let slope = one * (square + 2.0 * product + 3.0 * depth) + 4.0 * depth * other;
        // Per depth, not per root of it.
        let steepens = 0.5 * (slope - steepness) * per_roots / other;
        let per_way = (self.before + end).recip();
        let by_middle = 0.8 * self.wall.stiffness * steepness * per_way;
        Some(MeanForce {
            normal: by_middle * middle,
            by_middle,
            by_end: 0.8 * self.wall.stiffness * middle * (steepens - steepness * per_way) * per_way,
            depth,
        })
    }

    /// Whether a step of Newton's method is the last.
    #[inline(always)]
    fn is_last(&self, step: f64, depth: f64) -> bool {
        step * step <= CLOSE * depth * self.distance
    }

    /// F_N as the law or the load line has it, whichever an error of the position changes less.
    #[inline(always)]
    fn normal_force(&self, by_law: f64, slope: f64, by_line: f64) -> f64 {
        match self.approach.compliance * slope < 1.0 {
            true => by_law,
            false => by_line,
        }
    }

    /// Rolling: its direction does not depend on the depth. Gives the depth of the end, too.
    #[inline]
    fn rolls_on(&self) -> Option<(Contact, f64)> {
        let approach = self.approach;
        let step = ContactStep::new(self.wall, approach, self.distance);
        let [direction, _] = step.rolling_directions()?;
        let ([cos, sin], [x, y], [px, py]) = (
            direction,
            approach.free_position,
            approach.previous_position,
        );
        let compliance = approach.compliance;
        let free = x * cos + y * sin;
        let along = px * cos + py * sin;
        // As deep at the end as at the beginning.
        let mut middle = along;
        for _ in 0..MOST_STEPS {
            let end_along = 2.0 * middle - along;
            let end = (end_along * end_along + self.before * self.before - along * along).sqrt();
            let force = self.mean_force(middle, end)?;
            let slope = force.by_middle + force.by_end * 2.0 * end_along / end;
            let miss = middle + compliance * force.normal - free;
            let change = -miss / (1.0 + compliance * slope);
            middle += change;
            if !self.is_last(change, force.depth) {
                continue;
            }
            let by_law = force.normal + slope * change;
            let normal_force = self.normal_force(by_law, slope, (free - middle) / compliance);
            let friction = (x * sin - y * cos) / compliance;
            let is_held = friction.abs() <= self.wall.friction * normal_force;
            let contact = Contact {
                touch: Touch::Rolling,
                position: [middle * cos, middle * sin],
                force: [
                    -normal_force * cos - friction * sin,
                    -normal_force * sin + friction * cos,
                ],
                normal_force,
                friction_ratio: friction / normal_force,
                torque: self.wall.radius * friction,
                sliding_speed: 0.0,
                ambiguous: false,
            };
            return is_held.then_some((contact, force.depth));
        }
        None
    }

    /// Sliding as fast as this (m/s) in the last step, and the same way in this. Gives the depth of the
    /// end, too.
    #[inline]
    fn slides_on(&self, slid: f64) -> Option<(Contact, f64)> {
        let approach = self.approach;
        let ratio = -self.wall.friction * slid.signum();
        let compliance = approach.compliance;
        let ([fx, fy], [px, py]) = (approach.free_position, approach.previous_position);
        let [mut x, mut y] = [0, 1]
            .map(|axis| approach.free_position[axis] + compliance * approach.last_force[axis]);
        for _ in 0..MOST_STEPS {
            let (end_x, end_y) = (2.0 * x - px, 2.0 * y - py);
            let (middle, end) = (length([x, y]), length([end_x, end_y]));
            let force = self.mean_force(middle, end)?;
            let (per_middle, per_end) = (middle.recip(), 2.0 * force.by_end / end);
            let (cos, sin) = (x * per_middle, y * per_middle);
            let slopes = [
                force.by_middle * cos + per_end * end_x,
                force.by_middle * sin + per_end * end_y,
            ];
            // The way of the force, and how it turns with the position.
            let way = [-cos - ratio * sin, -sin + ratio * cos];
            let turns = [sin - ratio * cos, -cos - ratio * sin];
            let [by_x, by_y] = [-force.by_middle * sin, force.by_middle * cos];
            let miss_x = x - fx - compliance * force.normal * way[0];
            let miss_y = y - fy - compliance * force.normal * way[1];
            let xx = 1.0 - compliance * (way[0] * slopes[0] + turns[0] * by_x);
            let xy = -compliance * (way[0] * slopes[1] + turns[0] * by_y);
            let yx = -compliance * (way[1] * slopes[0] + turns[1] * by_x);
            let yy = 1.0 - compliance * (way[1] * slopes[1] + turns[1] * by_y);
            let per = (xx * yy - xy * yx).recip();
            let change_x = (miss_y * xy - miss_x * yy) * per;
            let change_y = (miss_x * yx - miss_y * xx) * per;
            x += change_x;
            y += change_y;
            if !self.is_last(change_x.abs() + change_y.abs(), force.depth) {
                continue;
            }
            let per_middle = length([x, y]).recip();
            let (cos, sin) = (x * per_middle, y * per_middle);
            let by_law = force.normal + slopes[0] * change_x + slopes[1] * change_y;
            let by_line = ((fx - x) * cos + (fy - y) * sin) / compliance;
            let slope = force.by_middle + per_end * end;
            let normal_force = self.normal_force(by_law, slope, by_line);
            let friction = ratio * normal_force;
            let drift = (px * sin - py * cos) * approach.sampling.rate_in_step();
            let spin = approach.spin.under(self.wall.radius * friction);
            let sliding_speed = self.wall.radius * spin + drift;
            let contact = Contact {
                touch: Touch::Sliding,
                position: [x, y],
                force: [
                    -normal_force * cos - friction * sin,
                    -normal_force * sin + friction * cos,
                ],
                normal_force,
                friction_ratio: ratio,
                torque: self.wall.radius * friction,
                sliding_speed,
                ambiguous: false,
            };
            let slides_on = sliding_speed * slid > 0.0 && normal_force > 0.0;
            return slides_on.then_some((contact, force.depth));
        }
        None
    }

    /// Whether one friction ratio alone can solve the step, the distance of the middle from the
    /// centre and the depth of the end given, m: with a wall that is in the place of this one
    /// ([`Wall::instead`]) no deeper in than the deeper end.
    #[inline]
    fn is_only_one(&self, middle: f64, depth: f64) -> bool {
        let instead = Wall {
            clearance: middle - depth.max(self.root * self.root),
            ..*self.wall
        };
        instead.clearance > 0.0
            && ContactStep::new(&instead, self.approach, self.distance).has_one_answer()
    }
}
