//! One step at the wall: its depth, its friction, and whether it slides or rolls.
//!
//! With p_h the displacement a site would have without contact, and h₀ = A(0),
//! the position r e_r satisfies p_h = (r + h₀F_N) e_r − h₀αF_N e_θ, where αF_N is
//! the friction on the string along e_θ. For given α that is one equation for
//! the depth of penetration; α itself is ±μ in sliding, or the root of the
//! sliding speed in rolling.

use super::contact::{Approach, Contact, ContactError, Touch, WallLaw};
use super::newton::newton;
use super::wall::Wall;
use crate::ranges::SceneError;

/// Rolling is solved to this fraction of the friction coefficient.
const RATIO_TOLERANCE: f64 = 1e-15;

/// Most halvings of a bracket of friction ratios: fifty-one take −μ … μ down to
/// [`RATIO_TOLERANCE`].
const MOST_HALVINGS: usize = 64;

/// An answer obeys the laws of contact to this part of the distance |p_h|. Roots are
/// found to rounding: only what is no answer is further off.
const TOLERANCE: f64 = 1e-9;

/// A step that carries the free position further than this many clearances may
/// turn the centre so far that several friction ratios solve it.
const FAR: f64 = 1.1;

impl WallLaw for Wall {
    fn clearance(&self) -> f64 {
        self.clearance
    }

    fn radius(&self) -> f64 {
        self.radius
    }

    /// Solves one step at one site, whatever its numbers are: position, load line
    /// and law of the wall then agree to 1e-9 of the distance |p_h|, and what
    /// rolls slides by no more than 1e-9 of the speeds that meet there, or of what
    /// the bit's speed jumps by where its torque falls from T_s to T_d. Lengths
    /// below 1e-150 m count as none.
    fn meet(&self, approach: &Approach) -> Result<Contact, ContactError> {
        let [x, y] = approach.free_position;
        let distance = (x * x + y * y).sqrt();
        if distance <= self.clearance {
            return Contact::free(approach.free_position);
        }
        let press = Press {
            wall: self,
            approach,
            distance,
        };
        if distance > FAR * self.clearance {
            press.search()
        } else {
            press.solve()
        }
    }

    fn check(&self) -> Result<(), SceneError> {
        self.check_numbers()
    }
}

/// A step in contact.
struct Press<'a> {
    wall: &'a Wall,
    approach: &'a Approach<'a>,
    /// |p_h|, m.
    distance: f64,
}

/// The state of a step for one friction ratio.
#[derive(Clone, Copy)]
struct Trial {
    ratio: f64,
    normal_force: f64,
    radius: f64,
    direction: [f64; 2],
    sliding_speed: f64,
}

impl Press<'_> {
    /// Rolling, or sliding one way or the other.
    fn solve(&self) -> Result<Contact, ContactError> {
        let friction = self.wall.friction;
        if self.approach.spin.resistance.is_none()
            && let [Some(rolling), _] = self.rolling()
        {
            return self.contact(rolling, Touch::Rolling, false);
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
        let drift = (px * y - py * x) * approach.sampling_frequency;
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

    /// All solutions; the one that turns the centre least is taken.
    fn search(&self) -> Result<Contact, ContactError> {
        let friction = self.wall.friction;
        let mut found = [None; 4];
        let (forward, backward) = (self.trial(-friction), self.trial(friction));
        found[0] = Some((forward, Touch::Sliding)).filter(|_| forward.sliding_speed >= 0.0);
        found[1] = Some((backward, Touch::Sliding)).filter(|_| backward.sliding_speed <= 0.0);
        if self.approach.spin.resistance.is_none() {
            for (found, rolling) in found[2..].iter_mut().zip(self.rolling()) {
                *found = rolling.map(|trial| (trial, Touch::Rolling));
            }
        } else if forward.sliding_speed < 0.0 && backward.sliding_speed > 0.0 {
            found[2] = Some((self.roll(forward, backward), Touch::Rolling));
        }
        let ambiguous = found.iter().flatten().count() > 1;
        let [x, y] = self.approach.previous_position;
        let along = |trial: &Trial| trial.direction[0] * x + trial.direction[1] * y;
        let nearest = (found.into_iter().flatten())
            .max_by(|one, other| along(&one.0).total_cmp(&along(&other.0)));
        match nearest {
            Some((trial, touch)) => self.contact(trial, touch, ambiguous),
            // A contact between rolling and sliding to the last digit.
            None => self.contact(self.roll(forward, backward), Touch::Rolling, false),
        }
    }

    /// The contacts that roll, friction allowing. The first is the one at which
    /// the sliding speed increases with friction.
    ///
    /// Across e_r the load line leaves αF_N = −p_h·e_θ/h₀, so that the sliding
    /// speed R₀(θ̇_h + g₀R₀αF_N) − f_s p_prev·e_θ is linear in e_θ: it vanishes
    /// where w·e_θ = R₀θ̇_h for w = (R₀²g₀/h₀) p_h + f_s p_prev.
    fn rolling(&self) -> [Option<Trial>; 2] {
        let approach = self.approach;
        let turning = self.wall.radius.powi(2) * approach.spin.compliance / approach.compliance;
        let [wx, wy]: [f64; 2] = std::array::from_fn(|axis| {
            turning * approach.free_position[axis]
                + approach.sampling_frequency * approach.previous_position[axis]
        });
        let length = (wx * wx + wy * wy).sqrt();
        let sine = self.wall.radius * approach.spin.free_speed / length;
        // No length or no number: nothing rolls.
        if sine.is_nan() || sine.abs() > 1.0 {
            return [None, None];
        }
        // e_θ at the angle of w plus a right angle minus asin, or plus it.
        let cosine = (1.0 - sine * sine).sqrt();
        [cosine, -cosine].map(|cosine| {
            // e_r has the angle ψ_w − asin(sine).
            let direction = [
                (wx * cosine + wy * sine) / length,
                (wy * cosine - wx * sine) / length,
            ];
            self.rolling_along(direction)
        })
    }

    /// The contact that rolls at a direction e_r, if it presses and friction
    /// holds it.
    fn rolling_along(&self, [cos, sin]: [f64; 2]) -> Option<Trial> {
        let [x, y] = self.approach.free_position;
        let gap = x * cos + y * sin - self.wall.clearance;
        if gap <= 0.0 {
            return None;
        }
        let compliance = self.approach.compliance;
        let (normal_force, depth) = if self.wall.stiffness == f64::INFINITY {
            (gap / compliance, 0.0)
        } else {
            // δ + h₀k_c δ^(3/2) = gap, in √δ.
            let steepness = compliance * self.wall.stiffness;
            let highest = start_from_above(gap, steepness);
            let root = newton(self.last_root(), highest, |root| {
                let value = root * root * (1.0 + steepness * root) - gap;
                let slope = root * (2.0 + 3.0 * steepness * root);
                (value, slope)
            });
            (self.wall.stiffness * root.powi(3), root * root)
        };
        let friction = (x * sin - y * cos) / compliance;
        let holds = friction.abs() <= self.wall.friction * normal_force;
        holds.then_some(Trial {
            ratio: friction / normal_force,
            normal_force,
            radius: self.wall.clearance + depth,
            direction: [cos, sin],
            sliding_speed: 0.0,
        })
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
        let drift = (px * sin - py * cos) * self.approach.sampling_frequency;
        let torque = self.wall.radius * ratio * normal_force;
        let spin = self.approach.spin.under(torque);
        Trial {
            ratio,
            normal_force,
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
        let start = start_from_above(self.distance - clearance, steepness);
        let root = newton(self.last_root(), start, |root| {
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
    fn contact(
        &self,
        trial: Trial,
        touch: Touch,
        ambiguous: bool,
    ) -> Result<Contact, ContactError> {
        let [cos, sin] = trial.direction;
        let friction = trial.ratio * trial.normal_force;
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
            ambiguous,
        };
        if self.is_met_by(&trial, &contact) {
            Ok(contact)
        } else {
            Err(self.refusal())
        }
    }

    /// Whether an answer obeys the laws of contact; what is no number does not.
    fn is_met_by(&self, trial: &Trial, contact: &Contact) -> bool {
        let approach = self.approach;
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
                Touch::Rolling => self.rolls(trial, contact),
                _ => self.turns_as_tried(trial, contact),
            }
    }

    /// Whether friction turns the string as it did in the trial, which knows the way
    /// of sliding: products of numbers far too small are not what they say.
    fn turns_as_tried(&self, trial: &Trial, contact: &Contact) -> bool {
        let tried = self.wall.radius * trial.ratio * trial.normal_force;
        (tried - contact.torque).abs() <= TOLERANCE * contact.torque.abs()
    }

    /// Whether what rolls does not slide: by no more than a part of the speeds that
    /// meet, what all friction adds to them included, or than what a bit jumps by
    /// where it slips, for there its speed takes no value between.
    fn rolls(&self, trial: &Trial, contact: &Contact) -> bool {
        let (wall, approach) = (self.wall, self.approach);
        let (gives, free_speed) = (approach.spin.compliance, approach.spin.free_speed);
        let spin = approach.spin.under(contact.torque);
        let jump = approach.spin.resistance.map_or(0.0, |law| law.jump);
        // A bit that holds any torque never slips.
        let jump = if jump.is_finite() { jump } else { 0.0 };
        let ([cos, sin], [px, py]) = (trial.direction, approach.previous_position);
        let drift = (px * sin - py * cos) * approach.sampling_frequency;
        let sliding_speed = wall.radius * spin + drift;
        let by_friction = gives * wall.radius * wall.friction * trial.normal_force;
        let turns = wall.radius * (free_speed.abs() + by_friction);
        let goes = (self.distance + px.abs() + py.abs()) * approach.sampling_frequency;
        let speeds = turns.abs() + goes.abs();
        let least = TOLERANCE * speeds + (1.0 + TOLERANCE) * (wall.radius * jump).abs();
        speeds.is_finite() && sliding_speed.abs() <= least + f64::MIN_POSITIVE
    }

    /// Why there is no answer.
    #[cold]
    fn refusal(&self) -> ContactError {
        let [px, py] = self.approach.previous_position;
        let motion = [self.distance, px, py, self.approach.spin.free_speed];
        if motion.iter().all(|number| number.is_finite()) {
            ContactError::Unsolved
        } else {
            ContactError::NotFinite
        }
    }
}

/// No less than the root of s² + a s³ = gap.
fn start_from_above(gap: f64, steepness: f64) -> f64 {
    let soft = gap.sqrt();
    if steepness * soft < 1.0 {
        soft
    } else {
        soft.min((gap / steepness).cbrt() * (1.0 + f64::EPSILON))
    }
}

/// The contact that rolls between two of opposite sliding speeds, to within
/// `tolerance` of the friction ratio: false position, and a bisection after each.
fn rolling_between(
    mut low: Trial,
    mut high: Trial,
    tolerance: f64,
    mut trial: impl FnMut(f64) -> Trial,
) -> Trial {
    let mut width = (high.ratio - low.ratio).abs();
    for _ in 0..MOST_HALVINGS {
        let slope = high.sliding_speed - low.sliding_speed;
        let secant = high.ratio - high.sliding_speed * (high.ratio - low.ratio) / slope;
        let found = trial(secant);
        if found.sliding_speed == 0.0 {
            return found;
        }
        replace(&mut low, &mut high, found);
        let middle = trial(0.5 * (low.ratio + high.ratio));
        replace(&mut low, &mut high, middle);
        let next = (high.ratio - low.ratio).abs();
        // As close as numbers get, or not numbers.
        if !(next > tolerance && next < width) {
            break;
        }
        width = next;
    }
    let closer = low.sliding_speed.abs() < high.sliding_speed.abs();
    if closer { low } else { high }
}

/// Keeps the root between the two.
fn replace(low: &mut Trial, high: &mut Trial, trial: Trial) {
    if (trial.sliding_speed < 0.0) == (low.sliding_speed < 0.0) {
        *low = trial;
    } else {
        *high = trial;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Any of the 2⁶⁴ patterns of bits: subnormal, infinite and no numbers too.
    fn any_number() -> impl Strategy<Value = f64> {
        any::<u64>().prop_map(f64::from_bits)
    }

    fn place(ratio: f64, sliding_speed: f64) -> Trial {
        Trial {
            ratio,
            normal_force: 1.0,
            radius: 1.0,
            direction: [1.0, 0.0],
            sliding_speed,
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 5000, failure_persistence: None, ..Default::default() })]

        /// Answers without sense, one after the other and round again.
        #[test]
        fn a_bracket_is_tried_a_bounded_number_of_times(
            ends in [any_number(), any_number(), any_number(), any_number()],
            tolerance in any_number(),
            answers in prop::collection::vec((any_number(), any_number()), 1..40),
        ) {
            let [a, b, c, d] = ends;
            let mut tried = 0;
            rolling_between(place(a, b), place(c, d), tolerance, |ratio| {
                tried += 1;
                assert!(tried <= 2 * MOST_HALVINGS);
                let (elsewhere, sliding_speed) = answers[tried % answers.len()];
                // As often as not, what was asked for.
                place(if tried % 2 == 0 { ratio } else { elsewhere }, sliding_speed)
            });
        }

        #[test]
        fn the_ratio_that_rolls_is_found_in_its_bracket(root in -1.0..1.0f64, power in 0i32..4) {
            let trial = |ratio: f64| place(ratio, (ratio - root).powi(2 * power + 1));
            let found = rolling_between(trial(-1.0), trial(1.0), RATIO_TOLERANCE, trial);
            prop_assert!((found.ratio - root).abs() <= 1e-14);
        }
    }
}
