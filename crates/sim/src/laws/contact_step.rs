//! One step at the wall: its depth, its friction, and whether it slides or rolls.
//!
//! With p_h the displacement a site would have without contact, and h₀ = A(0),
//! the position r e_r satisfies p_h = (r + h₀F_N) e_r − h₀αF_N e_θ, where αF_N is
//! the friction on the string along e_θ. For given α that is one equation for
//! the depth of penetration; α itself is ±μ in sliding, or the root of the
//! sliding speed in rolling. Where μ falls with the sliding speed, `slide` finds it.

use super::bracket::{RATIO_TOLERANCE, Trial, rolling_between};
use super::contact::{Approach, Contact, ContactError, Touch, WallLaw};
use super::contact_residual::ContactResidual;
use super::newton::newton;
use super::wall::Wall;
use crate::ranges::SceneError;

impl WallLaw for Wall {
    fn clearance(&self) -> f64 {
        self.clearance
    }

    fn radius(&self) -> f64 {
        self.radius
    }

    /// Solves one step at one site, for any numbers: position, load line
    /// and law of the wall then agree to 1e-9 of the distance |p_h|, and what
    /// rolls slides by no more than 1e-9 of the speeds that meet there, or of what
    /// the bit's speed jumps by where its torque falls from T_s to T_d. Lengths
    /// below 1e-150 m count as none.
    #[inline(always)]
    fn meet(&self, approach: &Approach) -> Result<Contact, ContactError> {
        if approach.sampling.collocation_offset > 0.0 {
            self.meet_in_step(approach)
        } else {
            self.meet_at(approach)
        }
    }

    fn rolling_limit(&self) -> Option<f64> {
        Some(self.friction)
    }

    fn slides_evenly(&self) -> bool {
        !self.falls()
    }

    fn check(&self) -> Result<(), SceneError> {
        self.check_numbers()
    }
}

impl Wall {
    /// One step of a wall that is where it is.
    #[inline(always)]
    pub(super) fn meet_at(&self, approach: &Approach) -> Result<Contact, ContactError> {
        let [x, y] = approach.free_position;
        let distance = (x * x + y * y).sqrt();
        if distance <= self.clearance {
            return Contact::free(approach.free_position);
        }
        let press = ContactStep::new(self, approach, distance);
        if self.falls() {
            return press.meet_falling();
        }
        if press.has_one_answer() {
            press.solve()
        } else {
            press.search()
        }
    }
}

/// A step in contact.
pub(super) struct ContactStep<'a> {
    wall: &'a Wall,
    approach: &'a Approach<'a>,
    /// |p_h|, m.
    distance: f64,
    /// w = (R₀²g₀/h₀) p_h + f_s p_prev, m/s: by how much the sliding speed grows with the
    /// angle by which friction turns e_r, is w·e_r. Of a torque law at the same site, which
    /// turns it more, nothing is known: its share is left out.
    weight: [f64; 2],
}

// Most of this is inlined by request: calls, and answers copied between them, would cost
// half as much again as what they do.
impl<'a> ContactStep<'a> {
    #[inline]
    pub(super) fn new(wall: &'a Wall, approach: &'a Approach<'a>, distance: f64) -> Self {
        let turning = match approach.spin.resistance {
            None => wall.radius.powi(2) * approach.spin.compliance / approach.compliance,
            Some(_) => 0.0,
        };
        let weight = std::array::from_fn(|axis| {
            turning * approach.free_position[axis]
                + approach.sampling.rate_in_step() * approach.previous_position[axis]
        });
        Self {
            wall,
            approach,
            distance,
            weight,
        }
    }

    /// Whether one friction ratio alone can solve the step.
    ///
    /// The ratio turns e_r from p_h one way or the other, at most by the angle at which a
    /// rigid wall takes all friction: c + x along p_h and μx across it, x the most that h₀F_N
    /// can be. w·e_r is a sinusoid of that angle: where it is positive at both ends it is
    /// between. What slides faster the more friction drives it can be held by one ratio only.
    #[inline]
    pub(super) fn has_one_answer(&self) -> bool {
        let Wall {
            clearance,
            friction,
            ..
        } = *self.wall;
        let ([x, y], [wx, wy]) = (self.approach.free_position, self.weight);
        let (along, across) = (x * wx + y * wy, (x * wy - y * wx).abs());
        let past = self.distance - clearance;
        // x is no more than what is past the wall, which is most often enough to know.
        let turns_little = along * clearance > across * friction * past;
        turns_little || {
            let gap = past * (self.distance + clearance);
            let root = (clearance * clearance + (1.0 + friction * friction) * gap).sqrt();
            let reach = gap / (clearance + root);
            along * (clearance + reach) > across * friction * reach
        }
    }

    /// Rolling, or sliding one way or the other.
    #[inline(always)]
    fn solve(&self) -> Result<Contact, ContactError> {
        let friction = self.wall.friction;
        if self.approach.spin.resistance.is_none() {
            let directions = self.rolling_directions();
            if let Some(rolling) = directions.and_then(|[one, _]| self.rolling_along(one)) {
                return self.contact(rolling, Touch::Rolling, false);
            }
        }
        let forward = self.slides_forward_without_friction();
        let ratio = if forward { -friction } else { friction };
        let one = self.trial(ratio);
        if one.sliding_speed == 0.0 || (one.sliding_speed > 0.0) == forward {
            return self.contact(one, Touch::Sliding, false);
        }
        let other = self.trial(-ratio);
        if other.sliding_speed == 0.0 || (other.sliding_speed > 0.0) != forward {
            return self.contact(other, Touch::Sliding, false);
        }
        let (forward, backward) = if forward { (one, other) } else { (other, one) };
        // A torque law at the same site, or a contact between rolling and
        // sliding to the last digit.
        self.contact(self.roll(forward, backward), Touch::Rolling, false)
    }

    /// The way the surfaces slide where the wall is smooth: friction slows it or
    /// stops it, but does not turn it round.
    fn slides_forward_without_friction(&self) -> bool {
        let approach = self.approach;
        let [x, y] = approach.free_position;
        let [px, py] = approach.previous_position;
        let spin = approach.spin.under(0.0);
        let drift = (px * y - py * x) * approach.sampling.rate_in_step();
        self.wall.radius * spin * self.distance + drift > 0.0
    }

    /// The square root of the depth of the last step, from which this one's is
    /// not far.
    fn last_root(&self) -> f64 {
        let [x, y] = self.approach.previous_position;
        ((x * x + y * y).sqrt() - self.wall.clearance)
            .max(0.0)
            .sqrt()
    }

    /// All solutions; the one that turns the centre least is taken, from where it is in this step so far or
    /// was before.
    fn search(&self) -> Result<Contact, ContactError> {
        let friction = self.wall.friction;
        let mut found = [None; 4];
        let (forward, backward) = (self.trial(-friction), self.trial(friction));
        found[0] = Some((forward, Touch::Sliding)).filter(|_| forward.sliding_speed >= 0.0);
        found[1] = Some((backward, Touch::Sliding)).filter(|_| backward.sliding_speed <= 0.0);
        if self.approach.spin.resistance.is_none() {
            let directions = self.rolling_directions().into_iter().flatten();
            for (found, direction) in found[2..].iter_mut().zip(directions) {
                let rolling = self.rolling_along(direction);
                *found = rolling.map(|trial| (trial, Touch::Rolling));
            }
        } else if forward.sliding_speed < 0.0 && backward.sliding_speed > 0.0 {
            found[2] = Some((self.roll(forward, backward), Touch::Rolling));
        }
        let ambiguous = found.iter().flatten().count() > 1;
        let [x, y] = (self.approach.present_position).unwrap_or(self.approach.previous_position);
        let along = |trial: &Trial| trial.direction[0] * x + trial.direction[1] * y;
        let nearest = (found.into_iter().flatten())
            .max_by(|one, other| along(&one.0).total_cmp(&along(&other.0)));
        match nearest {
            Some((trial, touch)) => self.contact(trial, touch, ambiguous),
            // A contact between rolling and sliding to the last digit.
            None => self.contact(self.roll(forward, backward), Touch::Rolling, false),
        }
    }

    /// The directions e_r along which a contact would roll, did friction allow it. Along the
    /// first the sliding speed increases with friction.
    ///
    /// Across e_r the load line leaves αF_N = −p_h·e_θ/h₀, so that the sliding
    /// speed R₀(θ̇_h + g₀R₀αF_N) − f_s p_prev·e_θ is linear in e_θ: it vanishes
    /// where w·e_θ = R₀θ̇_h ([`ContactStep::weight`]).
    #[inline(always)]
    pub(super) fn rolling_directions(&self) -> Option<[[f64; 2]; 2]> {
        let [wx, wy] = self.weight;
        let (square, speed) = (
            wx * wx + wy * wy,
            self.wall.radius * self.approach.spin.free_speed,
        );
        // w·e_r. No length or no number: nothing rolls.
        let along = (square - speed * speed).sqrt();
        if square == 0.0 || along.is_nan() {
            return None;
        }
        // e_r has the angle of w, less asin(speed/|w|) or less π − asin(speed/|w|). The division
        // does not wait for the root.
        let per_square = square.recip();
        let turned = |along: f64| {
            [
                (wx * along + wy * speed) * per_square,
                (wy * along - wx * speed) * per_square,
            ]
        };
        Some([along, -along].map(turned))
    }

    /// The contact that rolls at a direction e_r, if it presses and friction
    /// holds it.
    #[inline(always)]
    fn rolling_along(&self, [cos, sin]: [f64; 2]) -> Option<Trial> {
        let [x, y] = self.approach.free_position;
        let gap = x * cos + y * sin - self.wall.clearance;
        if gap <= 0.0 {
            return None;
        }
        let across = x * sin - y * cos;
        if !self.holds(gap, across) {
            return None;
        }
        let compliance = self.approach.compliance;
        let friction = across / compliance;
        let (normal_force, depth) = if self.wall.stiffness == f64::INFINITY {
            (gap / compliance, 0.0)
        } else {
            // δ + h₀k_c δ^(3/2) = gap, in √δ.
            let steepness = compliance * self.wall.stiffness;
            let above = |guess| from_above(guess, gap, steepness);
            let guess = continued(self.last_root(), gap, steepness);
            let root = newton(guess, above, |root| {
                let value = root * root * (1.0 + steepness * root) - gap;
                let slope = root * (2.0 + 3.0 * steepness * root);
                (value, slope)
            });
            (self.wall.stiffness * root.powi(3), root * root)
        };
        Some(Trial {
            ratio: friction / normal_force,
            normal_force,
            friction,
            radius: self.wall.clearance + depth,
            direction: [cos, sin],
            sliding_speed: 0.0,
        })
    }

    /// Whether friction holds what rolls, without solving for its normal force: αF_N is
    /// `across`/h₀, and δ + h₀F_N = gap grows with F_N. So at the force that would just hold
    /// it, that is no more than the gap.
    #[inline]
    fn holds(&self, gap: f64, across: f64) -> bool {
        let Wall {
            stiffness,
            friction,
            ..
        } = *self.wall;
        let depth = friction * gap - across.abs();
        let steepness = self.approach.compliance * stiffness;
        depth >= 0.0
            && (stiffness == f64::INFINITY
                || friction * across * across <= steepness * steepness * depth * depth * depth)
    }

    /// The contact that rolls, between two trials of opposite signs.
    fn roll(&self, low: Trial, high: Trial) -> Trial {
        let tolerance = RATIO_TOLERANCE * self.wall.friction;
        rolling_between(low, high, tolerance, |ratio| self.trial(ratio))
    }

    /// Position, forces and sliding speed for one friction ratio.
    fn trial(&self, ratio: f64) -> Trial {
        let (normal_force, depth) = self.press(ratio);
        let radius = self.wall.clearance + depth;
        let compliance = self.approach.compliance;
        // p_h in the frame (e_r, e_θ) gives the direction of e_r.
        let along = radius + compliance * normal_force;
        let across = -compliance * ratio * normal_force;
        let [x, y] = self.approach.free_position;
        let square = along * along + across * across;
        let direction = [
            (x * along + y * across) / square,
            (y * along - x * across) / square,
        ];
        let [cos, sin] = direction;
        let [px, py] = self.approach.previous_position;
        // e_θ = (−sin, cos), to which the new position is orthogonal.
        let drift = (px * sin - py * cos) * self.approach.sampling.rate_in_step();
        let friction = ratio * normal_force;
        let spin = self.approach.spin.under(self.wall.radius * friction);
        Trial {
            ratio,
            normal_force,
            friction,
            radius,
            direction,
            sliding_speed: self.wall.radius * spin + drift,
        }
    }

    /// F_N and δ from (c + δ + h₀F_N)² + (h₀αF_N)² = |p_h|² and F_N = k_c δ^(3/2).
    fn press(&self, ratio: f64) -> (f64, f64) {
        let (clearance, compliance) = (self.wall.clearance, self.approach.compliance);
        let gap = (self.distance - clearance) * (self.distance + clearance);
        let stiffness = self.wall.stiffness;
        if stiffness == f64::INFINITY {
            // A quadratic, in the form that loses no digits.
            let spread = 1.0 + ratio * ratio;
            let root = (clearance * clearance + spread * gap).sqrt();
            return (gap / (compliance * (clearance + root)), 0.0);
        }
        let steepness = compliance * stiffness;
        let above = |guess| from_above(guess, self.distance - clearance, steepness);
        let root = newton(self.last_root(), above, |root| {
            let depth = root * root;
            let force = steepness * depth * root;
            let force_slope = 3.0 * steepness * depth;
            // |p_h|² − c² is known exactly; so is what δ adds to c².
            let along = depth + force;
            let value = along * (2.0 * clearance + along) + (ratio * force).powi(2) - gap;
            let slope = 2.0 * (clearance + along) * (2.0 * root + force_slope)
                + 2.0 * ratio * ratio * force * force_slope;
            (value, slope)
        });
        (stiffness * root.powi(3), root * root)
    }

    /// The answer of a trial, if it is one.
    #[inline(always)]
    fn contact(
        &self,
        trial: Trial,
        touch: Touch,
        ambiguous: bool,
    ) -> Result<Contact, ContactError> {
        let [cos, sin] = trial.direction;
        let friction = trial.friction;
        let contact = Contact {
            touch,
            position: [trial.radius * cos, trial.radius * sin],
            force: [
                -trial.normal_force * cos - friction * sin,
                -trial.normal_force * sin + friction * cos,
            ],
            normal_force: trial.normal_force,
            friction_ratio: trial.ratio,
            torque: self.wall.radius * friction,
            sliding_speed: match touch {
                Touch::Rolling => 0.0,
                _ => trial.sliding_speed,
            },
            ambiguous,
        };
        let obeyed = ContactResidual {
            wall: self.wall,
            approach: self.approach,
            distance: self.distance,
            trial: &trial,
            contact: &contact,
        };
        if obeyed.laws() {
            Ok(contact)
        } else {
            Err(obeyed.refusal())
        }
    }
}

/// About the root of s² + a s³ = gap, from that of another gap: what Taylor's series of the root
/// in the gap has up to third powers. All that waits for the gap are a few products, where a step
/// of Newton's method would wait for its division too. Where the series leads to no root, the
/// last one.
#[inline(always)]
fn continued(last: f64, gap: f64, steepness: f64) -> f64 {
    let per_slope = (last * (2.0 + 3.0 * steepness * last)).recip();
    let second = (1.0 + 3.0 * steepness * last) * per_slope;
    let third = 2.0 * second * second - steepness * per_slope;
    let step = (gap - last * last * (1.0 + steepness * last)) * per_slope;
    let root = last + step * (1.0 - step * (second - step * third));
    if root > 0.0 { root } else { last }
}

/// A guess that is above the root of s² + a s³ = gap, or what is no less than that root where
/// the guess is so far above it, or none.
#[inline]
fn from_above(guess: f64, gap: f64, steepness: f64) -> f64 {
    let square = guess * guess;
    let is_near = square < gap && steepness * square * guess < gap;
    if guess > 0.0 && is_near {
        return guess;
    }
    let soft = gap.sqrt();
    if steepness * soft < 1.0 {
        soft
    } else {
        soft.min(libm::cbrt(gap / steepness) * (1.0 + f64::EPSILON))
    }
}

mod slide;
#[cfg(test)]
pub(super) mod tests;
