//! Contact with the borehole wall (Section 4.1, Eqs. 33–38 and 70–71): Hertzian
//! or rigid, with Coulomb friction that slides or rolls.
//!
//! With p_h the displacement a site would have without contact, and h₀ = A(0),
//! the position r e_r satisfies p_h = (r + h₀F_N) e_r − h₀αF_N e_θ, where αF_N is
//! the friction on the string along e_θ. For given α that is one equation for
//! the depth of penetration; α itself is ±μ in sliding, or the root of the
//! sliding speed in rolling.

use super::bit::{BitMotion, BitTorque};

/// A place on the wall and what the string does there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wall {
    /// Clearance c between string and wall, m.
    pub clearance: f64,
    /// Hertzian stiffness k_c, N/m^(3/2); infinite for a rigid wall.
    pub stiffness: f64,
    /// Coefficient of friction μ.
    pub friction: f64,
    /// Radius R₀ of the string, which friction turns, m.
    pub radius: f64,
}

/// What one step brings to a site, before contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// Displacement p_h without contact, m.
    pub free_position: [f64; 2],
    /// Position in the step before, m.
    pub previous_position: [f64; 2],
    /// Rotation speed without contact, rad/s.
    pub free_speed: f64,
    /// h₀: displacement per force within the step, m/N.
    pub compliance: f64,
    /// g₀: rotation speed per torque within the step, rad/s per N m.
    pub torsional_compliance: f64,
    /// Torque law and last motion of the bit, where the site is the bit and
    /// cuts: both laws then hold in one step (Eq. 36).
    pub bit: Option<(BitTorque, BitMotion)>,
    /// Sampling frequency, Hz.
    pub sampling_frequency: f64,
}

/// How the surfaces meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Touch {
    /// Not at all.
    Free,
    /// Sliding.
    Sliding,
    /// Rolling without sliding.
    Rolling,
}

/// The answer of the wall in one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// How the surfaces meet.
    pub touch: Touch,
    /// Position of the string's centre, m.
    pub position: [f64; 2],
    /// Force of the wall on the string, N.
    pub force: [f64; 2],
    /// Normal force F_N ≥ 0, N.
    pub normal_force: f64,
    /// Friction over normal force, α, positive along e_θ.
    pub friction_ratio: f64,
    /// Torque of friction on the string, N m.
    pub torque: f64,
    /// Whether other friction ratios would have solved the step too.
    pub ambiguous: bool,
}

impl Contact {
    /// At rest in the middle.
    pub const NONE: Contact = Contact {
        touch: Touch::Free,
        position: [0.0; 2],
        force: [0.0; 2],
        normal_force: 0.0,
        friction_ratio: 0.0,
        torque: 0.0,
        ambiguous: false,
    };
}

/// Rolling is solved to this fraction of the friction coefficient.
const RATIO_TOLERANCE: f64 = 1e-15;

/// A step of Newton's as small as this part of the root ends within rounding of
/// it: the next would be as small as the square of this.
const CLOSE: f64 = 1e-8;

/// A step that carries the free position further than this many clearances may
/// turn the centre so far that several friction ratios solve it.
const FAR: f64 = 1.1;

impl Wall {
    /// Solves one step at one site.
    pub fn meet(&self, approach: &Approach) -> Contact {
        let [x, y] = approach.free_position;
        let distance = (x * x + y * y).sqrt();
        if distance <= self.clearance {
            return Contact {
                position: approach.free_position,
                ..Contact::NONE
            };
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
}

/// A step in contact.
struct Press<'a> {
    wall: &'a Wall,
    approach: &'a Approach,
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
    fn solve(&self) -> Contact {
        let friction = self.wall.friction;
        if self.approach.bit.is_none()
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
        let spin = approach.bit.map_or(approach.free_speed, |(law, motion)| {
            law.meet(motion, approach.free_speed, approach.torsional_compliance)
                .speed
        });
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
    fn search(&self) -> Contact {
        let friction = self.wall.friction;
        let mut found = [None; 4];
        let (forward, backward) = (self.trial(-friction), self.trial(friction));
        found[0] = Some((forward, Touch::Sliding)).filter(|_| forward.sliding_speed >= 0.0);
        found[1] = Some((backward, Touch::Sliding)).filter(|_| backward.sliding_speed <= 0.0);
        if self.approach.bit.is_none() {
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
        let turning =
            self.wall.radius.powi(2) * approach.torsional_compliance / approach.compliance;
        let [wx, wy]: [f64; 2] = std::array::from_fn(|axis| {
            turning * approach.free_position[axis]
                + approach.sampling_frequency * approach.previous_position[axis]
        });
        let length = (wx * wx + wy * wy).sqrt();
        let sine = self.wall.radius * approach.free_speed / length;
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
        let (normal_force, depth) = if self.wall.stiffness.is_infinite() {
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

    /// The root of the sliding speed between two trials of opposite signs:
    /// false position with bisection whenever it stalls.
    fn roll(&self, mut low: Trial, mut high: Trial) -> Trial {
        let tolerance = RATIO_TOLERANCE * self.wall.friction;
        let mut width = (high.ratio - low.ratio).abs();
        loop {
            let slope = high.sliding_speed - low.sliding_speed;
            let secant = high.ratio - high.sliding_speed * (high.ratio - low.ratio) / slope;
            let trial = self.trial(secant);
            if trial.sliding_speed == 0.0 {
                return trial;
            }
            replace(&mut low, &mut high, trial);
            let middle = self.trial(0.5 * (low.ratio + high.ratio));
            replace(&mut low, &mut high, middle);
            let next = (high.ratio - low.ratio).abs();
            if next <= tolerance || next >= width {
                // As close as numbers get.
                let closer = low.sliding_speed.abs() < high.sliding_speed.abs();
                return if closer { low } else { high };
            }
            width = next;
        }
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
        let free_speed = self.approach.free_speed + self.approach.torsional_compliance * torque;
        let spin = self.approach.bit.map_or(free_speed, |(law, motion)| {
            law.meet(motion, free_speed, self.approach.torsional_compliance)
                .speed
        });
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
        if stiffness.is_infinite() {
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

    fn contact(&self, trial: Trial, touch: Touch, ambiguous: bool) -> Contact {
        let [cos, sin] = trial.direction;
        let friction = trial.ratio * trial.normal_force;
        Contact {
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

/// The root of a convex, increasing function, no higher than `highest`: a step
/// of Newton's from a guess on either side ends above it, and from there none
/// overshoots, until rounding stops them.
fn newton(guess: f64, highest: f64, value_and_slope: impl Fn(f64) -> (f64, f64)) -> f64 {
    let (value, slope) = value_and_slope(guess);
    let first = guess - value / slope;
    // A guess of zero has no slope.
    let mut root = if first < highest && first > 0.0 {
        first
    } else {
        highest
    };
    loop {
        let (value, slope) = value_and_slope(root);
        let next = root - value / slope;
        // Not a number ends it too.
        if !(next < root && next > 0.0) {
            return root;
        }
        if root - next <= CLOSE * root {
            return next;
        }
        root = next;
    }
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

    fn stiffnesses() -> impl Strategy<Value = f64> {
        prop_oneof![
            (3.0..12.0f64).prop_map(|e| 10f64.powf(e)),
            Just(f64::INFINITY)
        ]
    }

    fn walls() -> impl Strategy<Value = Wall> {
        let friction = prop_oneof![Just(0.0), 0.0..1.0f64, 0.0..50.0f64];
        (stiffnesses(), friction).prop_map(|(stiffness, friction)| Wall {
            clearance: 0.015,
            stiffness,
            friction,
            radius: 0.15,
        })
    }

    fn approaches(furthest: f64) -> impl Strategy<Value = Approach> {
        (
            0.0..furthest,
            0.0..6.3f64,
            0.0..1.05f64,
            -0.5..0.5f64,
            -50.0..50.0f64,
            -9.0..-6.0f64,
            -6.0..-3.0f64,
        )
            .prop_map(|(distance, angle, before, turn, free_speed, h, g)| {
                let clearance = 0.015;
                let at = |radius: f64, angle: f64| {
                    [
                        clearance * radius * angle.cos(),
                        clearance * radius * angle.sin(),
                    ]
                };
                Approach {
                    free_position: at(distance, angle),
                    previous_position: at(before, angle + turn),
                    free_speed,
                    compliance: 10f64.powf(h),
                    torsional_compliance: 10f64.powf(g),
                    bit: None,
                    sampling_frequency: 640.0,
                }
            })
    }

    fn check(wall: &Wall, approach: &Approach) -> Result<(), TestCaseError> {
        let contact = wall.meet(approach);
        let [x, y] = contact.position;
        let radius = x.hypot(y);
        let scale = approach.free_position[0].hypot(approach.free_position[1]);
        // Load lines: the position is the free one plus h₀ times the force.
        for axis in 0..2 {
            let line = approach.free_position[axis] + approach.compliance * contact.force[axis];
            prop_assert!((contact.position[axis] - line).abs() <= 1e-10 * scale);
        }
        // Complementarity: a force only in contact, and then by the law.
        if contact.touch == Touch::Free {
            prop_assert!(radius <= wall.clearance && contact.normal_force == 0.0);
            return Ok(());
        }
        prop_assert!(contact.normal_force >= 0.0);
        let depth = (contact.normal_force / wall.stiffness).powf(2.0 / 3.0);
        prop_assert!((radius - wall.clearance - depth).abs() <= 1e-10 * scale);
        // Coulomb's cone, and friction against sliding.
        prop_assert!(contact.friction_ratio.abs() <= wall.friction);
        let [cos, sin] = [x / radius, y / radius];
        let velocity = |axis: usize| {
            (contact.position[axis] - approach.previous_position[axis])
                * approach.sampling_frequency
        };
        let spin = approach.free_speed + approach.torsional_compliance * contact.torque;
        let sliding = wall.radius * spin - velocity(0) * sin + velocity(1) * cos;
        // The speed is known to rounding of its parts.
        let parts = wall.radius * (approach.free_speed.abs() + spin.abs())
            + approach.sampling_frequency * scale
            + wall.radius * approach.torsional_compliance * contact.torque.abs();
        match contact.touch {
            Touch::Rolling => prop_assert!(sliding.abs() <= 1e-10 * parts, "{}", sliding),
            _ => {
                let power = sliding * contact.friction_ratio;
                prop_assert!(power <= 1e-10 * parts * wall.friction, "{}", power);
                prop_assert!(contact.friction_ratio.abs() == wall.friction);
            }
        }
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..Default::default() })]

        #[test]
        fn every_step_obeys_its_laws(wall in walls(), approach in approaches(1.1)) {
            check(&wall, &approach)?;
        }

        #[test]
        fn so_does_a_step_far_through_the_wall(wall in walls(), approach in approaches(20.0)) {
            check(&wall, &approach)?;
        }
    }

    #[test]
    fn rotating_the_axes_rotates_the_answer() {
        let wall = Wall {
            clearance: 0.015,
            stiffness: 1e9,
            friction: 0.7,
            radius: 0.15,
        };
        let at = |angle: f64| {
            let turn = move |[x, y]: [f64; 2]| {
                [
                    x * angle.cos() - y * angle.sin(),
                    x * angle.sin() + y * angle.cos(),
                ]
            };
            let contact = wall.meet(&Approach {
                free_position: turn([0.0152, 0.001]),
                previous_position: turn([0.0149, 0.0005]),
                free_speed: 6.3,
                compliance: 1e-8,
                torsional_compliance: 5e-5,
                bit: None,
                sampling_frequency: 640.0,
            });
            (contact, turn)
        };
        let (reference, _) = at(0.0);
        for angle in [0.3, 1.7, 4.0] {
            let (turned, turn) = at(angle);
            let expected = turn(reference.force);
            for axis in 0..2 {
                let difference = (turned.force[axis] - expected[axis]).abs();
                assert!(difference <= 1e-9 * reference.normal_force);
            }
            assert_eq!(turned.touch, reference.touch);
        }
    }
}
