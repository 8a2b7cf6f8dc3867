//! The law of the wall, step by step: every answer obeys the laws of contact, and for any numbers
//! there is an answer or an error.

use proptest::prelude::*;
use sim::laws::bit::BitMotion;
use sim::laws::contact::{Approach, Contact, ContactError, Resistance, Spin, Touch};
use sim::{BitTorque, LoadLine, Sampling, TorqueLaw, Wall, WallLaw};

/// What a step brings to a site, in plain numbers.
#[derive(Debug, Clone, Copy)]
struct Arrival {
    free_position: [f64; 2],
    previous_position: [f64; 2],
    previous_sliding_speed: Option<f64>,
    free_speed: f64,
    compliance: f64,
    torsional_compliance: f64,
    /// Torque law and last motion of the bit, where the site is the bit and cuts.
    bit: Option<(BitTorque, BitMotion)>,
    rate: f64,
}

impl Arrival {
    /// The speed under all else that turns the site.
    fn resisted(&self, free_speed: f64) -> f64 {
        let line = LoadLine {
            time: 0.0,
            free_speed,
            compliance: self.torsional_compliance,
        };
        (self.bit).map_or(free_speed, |(law, motion)| law.meet(&motion, line).speed)
    }

    fn meet(&self, wall: &Wall) -> Result<Contact, ContactError> {
        let speed = |free_speed: f64| self.resisted(free_speed);
        wall.meet(&Approach {
            free_position: self.free_position,
            previous_position: self.previous_position,
            previous_sliding_speed: self.previous_sliding_speed,
            last_force: [0.0; 2],
            present_position: None,
            compliance: self.compliance,
            spin: Spin {
                free_speed: self.free_speed,
                compliance: self.torsional_compliance,
                resistance: self.bit.map(|(law, _)| Resistance {
                    speed: &speed,
                    jump: self.torsional_compliance * law.largest_drop(),
                }),
            },
            sampling: Sampling::new(self.rate, 0.0),
        })
    }
}

fn stiffnesses() -> impl Strategy<Value = f64> {
    prop_oneof![
        (3.0..12.0f64).prop_map(|e| 10f64.powf(e)),
        Just(f64::INFINITY)
    ]
}

/// μ_d/μ_s and v_s, m/s.
fn falls() -> impl Strategy<Value = (f64, f64)> {
    let speeds = prop_oneof![Just(0.0), (-3.0..1.0f64).prop_map(|e| 10f64.powf(e))];
    prop_oneof![Just((1.0, 0.0)), (0.0..1.0f64, speeds)]
}

fn walls() -> impl Strategy<Value = Wall> {
    let friction = prop_oneof![Just(0.0), 0.0..1.0f64, 0.0..50.0f64];
    let wall = (stiffnesses(), friction, falls());
    wall.prop_map(
        |(stiffness, friction, (dynamic_ratio, stribeck_speed))| Wall {
            clearance: 0.015,
            stiffness,
            friction,
            dynamic_ratio,
            stribeck_speed,
            radius: 0.15,
        },
    )
}

/// How fast the surfaces slid, m/s, if they did.
fn slid() -> impl Strategy<Value = Option<f64>> {
    prop::option::of(prop_oneof![Just(0.0), -10.0..10.0f64])
}

fn approaches(furthest: f64) -> impl Strategy<Value = Arrival> {
    (
        0.0..furthest,
        0.0..6.3f64,
        0.0..1.05f64,
        -0.5..0.5f64,
        -50.0..50.0f64,
        -9.0..-6.0f64,
        -6.0..-3.0f64,
        slid(),
    )
        .prop_map(|(distance, angle, before, turn, free_speed, h, g, slid)| {
            let clearance = 0.015;
            let at = |radius: f64, angle: f64| {
                [
                    clearance * radius * angle.cos(),
                    clearance * radius * angle.sin(),
                ]
            };
            Arrival {
                free_position: at(distance, angle),
                previous_position: at(before, angle + turn),
                previous_sliding_speed: slid,
                free_speed,
                compliance: 10f64.powf(h),
                torsional_compliance: 10f64.powf(g),
                bit: None,
                rate: 640.0,
            }
        })
}

/// Any of the 2⁶⁴ patterns of bits: subnormal, infinite and no numbers too; as often
/// what a drillstring may have, or nearly so, for most patterns are far from it.
fn any_number(usual: impl Strategy<Value = f64> + 'static) -> impl Strategy<Value = f64> {
    let special = prop::sample::select(vec![
        0.0,
        -0.0,
        f64::from_bits(1),
        f64::MIN_POSITIVE,
        f64::EPSILON,
        f64::MAX,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ]);
    prop_oneof![
        12 => usual,
        3 => (-320.0..308.0f64).prop_map(|e| 10f64.powf(e)),
        2 => any::<u64>().prop_map(f64::from_bits),
        1 => special,
    ]
}

fn any_wall() -> impl Strategy<Value = Wall> {
    let exponent = |from: f64, to: f64| (from..to).prop_map(|e| 10f64.powf(e));
    (
        any_number(exponent(-4.0, 0.0)),
        any_number(stiffnesses()),
        any_number(0.0..50.0f64),
        any_number(0.0..2.0f64),
        any_number(exponent(-4.0, 1.0)),
        any_number(0.01..0.5f64),
    )
        .prop_map(
            |(clearance, stiffness, friction, dynamic_ratio, stribeck_speed, radius)| Wall {
                clearance,
                stiffness,
                friction,
                dynamic_ratio,
                stribeck_speed,
                radius,
            },
        )
}

fn any_bit() -> impl Strategy<Value = Option<(BitTorque, BitMotion)>> {
    let motions = prop::sample::select(vec![
        BitMotion::Stuck,
        BitMotion::Forward,
        BitMotion::Backward,
    ]);
    let law =
        (any_number(0.0..1e5f64), any_number(1.0..2.0f64)).prop_map(|(torque, ratio)| BitTorque {
            torque_static: ratio * torque,
            torque_dynamic: torque,
            decay_speed: 0.0,
        });
    prop::option::of((law, motions))
}

fn any_approach() -> impl Strategy<Value = Arrival> {
    let exponent = |from: f64, to: f64| (from..to).prop_map(|e| 10f64.powf(e));
    let place = || any_number(-0.1..0.1f64);
    (
        [place(), place(), place(), place()],
        any_number(-50.0..50.0f64),
        any_number(exponent(-9.0, -6.0)),
        any_number(exponent(-6.0, -3.0)),
        any_number(exponent(1.0, 5.0)),
        any_bit(),
        prop::option::of(any_number(-10.0..10.0f64)),
    )
        .prop_map(
            |(place, free_speed, compliance, torsional, frequency, bit, slid)| Arrival {
                free_position: [place[0], place[1]],
                previous_position: [place[2], place[3]],
                previous_sliding_speed: slid,
                free_speed,
                compliance,
                torsional_compliance: torsional,
                bit,
                rate: frequency,
            },
        )
}

/// What every answer promises, as a part of the distance, or of the speeds that meet:
/// as much again is left for the rounding of the test itself.
const TOLERANCE: f64 = 1e-9;

/// Squares of smaller lengths, m, are no numbers.
const LEAST_LENGTH: f64 = 1e-150;

/// That an answer obeys the laws of contact, from its numbers alone.
fn obeys(wall: &Wall, approach: &Arrival, tolerance: f64) -> Result<(), TestCaseError> {
    let Ok(contact) = approach.meet(wall) else {
        return Ok(());
    };
    let [x, y] = contact.position;
    let radius = x.hypot(y);
    let scale = approach.free_position[0].hypot(approach.free_position[1]) + LEAST_LENGTH;
    // Load lines: the position is the free one plus h₀ times the force.
    for axis in 0..2 {
        let line = approach.free_position[axis] + approach.compliance * contact.force[axis];
        prop_assert!(
            (contact.position[axis] - line).abs() <= tolerance * scale
                || contact.touch == Touch::Free
        );
    }
    // Complementarity: a force only in contact, and then by the law.
    if contact.touch == Touch::Free {
        prop_assert!(contact.position == approach.free_position && radius.is_finite());
        prop_assert!(radius <= wall.clearance * (1.0 + tolerance) + LEAST_LENGTH);
        prop_assert!(contact.force == [0.0; 2] && contact.normal_force == 0.0);
        return Ok(());
    }
    prop_assert!(contact.normal_force >= 0.0 && contact.normal_force.is_finite());
    let depth = radius - wall.clearance;
    prop_assert!(depth >= -tolerance * scale);
    // The force at a depth known to within the tolerance.
    let force = |depth: f64| wall.stiffness * depth.max(0.0).powf(1.5);
    let (least, most) = (
        force(depth - tolerance * scale),
        force(depth + tolerance * scale),
    );
    let is_rigid = wall.stiffness == f64::INFINITY;
    let rounding = f64::MIN_POSITIVE;
    let by_law = if is_rigid {
        depth.abs() <= tolerance * scale
    } else {
        contact.normal_force * (1.0 + tolerance) + rounding >= least
            && contact.normal_force * (1.0 - tolerance) <= most + rounding
    };
    prop_assert!(by_law);
    // Coulomb's cone, and friction against sliding.
    prop_assert!(contact.friction_ratio.abs() <= wall.friction * (1.0 + tolerance));
    // A wall that leaves no room for a position leaves none for a direction.
    if radius <= LEAST_LENGTH {
        return Ok(());
    }
    let [cos, sin] = [x / radius, y / radius];
    let velocity =
        |axis: usize| (contact.position[axis] - approach.previous_position[axis]) * approach.rate;
    let (gives, free) = (approach.torsional_compliance, approach.free_speed);
    let turned = free + gives * contact.torque;
    let spin = approach.resisted(turned);
    let sliding = wall.radius * spin - velocity(0) * sin + velocity(1) * cos;
    // The speed is known to rounding of its parts: what turns the string, what all
    // friction may add, and how far the centre may go round.
    let previous = approach.previous_position[0].hypot(approach.previous_position[1]);
    let by_friction = gives * wall.radius * wall.friction * contact.normal_force;
    let turns = free.abs() + spin.abs() + turned.abs() + by_friction.abs();
    let goes = approach.rate * (scale + previous);
    let parts = (wall.radius * turns).abs() + goes.abs();
    if !parts.is_finite() {
        return Ok(());
    }
    prop_assert!(sliding.is_finite());
    // The speed that a bit jumps by where it slips.
    let jump = (approach.bit).map_or(0.0, |(law, _)| {
        gives * (law.torque_static - law.torque_dynamic)
    });
    let jump = if jump.is_finite() {
        wall.radius * jump
    } else {
        0.0
    };
    let most = tolerance * parts + jump.abs() * (1.0 + tolerance) + f64::MIN_POSITIVE;
    if contact.touch == Touch::Rolling {
        prop_assert!(sliding.abs() <= most, "{:e} {:e}", sliding, most);
        return Ok(());
    }
    prop_assert!((sliding - contact.sliding_speed).abs() <= most);
    let with_friction = sliding * contact.friction_ratio.signum();
    // All possible friction at a speed known to within the same.
    let [more, less] = [-most, most].map(|off| friction_at(wall, off - with_friction));
    let friction = contact.friction_ratio.abs();
    let rounding = tolerance * wall.friction + f64::MIN_POSITIVE;
    // What does not rub does so at any speed, even one that is no number.
    let is_smooth = wall.friction == 0.0 && friction == 0.0;
    prop_assert!(is_smooth || friction >= less - rounding && friction <= more + rounding);
    if wall.friction > 0.0 {
        prop_assert!(with_friction <= most, "{:e} {:e}", with_friction, most);
    }
    Ok(())
}

/// Stribeck's curve.
fn friction_at(wall: &Wall, speed: f64) -> f64 {
    // What is no part is taken for one.
    if speed <= 0.0 || !(0.0..1.0).contains(&wall.dynamic_ratio) {
        return wall.friction;
    }
    let left = match wall.stribeck_speed {
        0.0 => 0.0,
        scale => f64::exp(-(speed / scale) * (speed / scale)),
    };
    wall.friction * (wall.dynamic_ratio + (1.0 - wall.dynamic_ratio) * left)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..Default::default() })]

    #[test]
    fn val_every_step_obeys_its_laws(wall in walls(), approach in approaches(1.1)) {
        prop_assert!(approach.meet(&wall).is_ok());
        obeys(&wall, &approach, 1e-10)?;
    }

    #[test]
    fn val_so_does_a_step_far_through_the_wall(wall in walls(), approach in approaches(20.0)) {
        prop_assert!(approach.meet(&wall).is_ok());
        obeys(&wall, &approach, 1e-10)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100_000, failure_persistence: None, ..Default::default() })]

    /// How often the searches within may try is bounded by their own tests.
    #[test]
    fn val_a_step_of_any_numbers_has_an_answer_that_obeys_or_an_error(
        wall in any_wall(),
        approach in any_approach(),
    ) {
        obeys(&wall, &approach, 2.0 * TOLERANCE)?;
    }
}

/// Forces that a million kilograms ten metres off the centre end in: the free
/// position has no square, and the sliding speed of no friction ratio is a number.
#[test]
fn a_position_beyond_all_numbers_is_an_error() {
    let wall = Wall {
        clearance: 0.015,
        stiffness: 1e9,
        friction: 0.5,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    };
    for far in [1e160, f64::INFINITY, f64::NAN] {
        let approach = Arrival {
            free_position: [far, 0.0],
            previous_position: [0.01, 0.0],
            previous_sliding_speed: None,
            free_speed: 1047.0,
            compliance: 1e-8,
            torsional_compliance: 5e-5,
            bit: None,
            rate: 640.0,
        };
        assert_eq!(approach.meet(&wall), Err(ContactError::NotFinite));
        let beyond_law = Wall {
            clearance: f64::NAN,
            ..wall
        };
        let near = Arrival {
            free_position: [0.02, 0.0],
            ..approach
        };
        assert_eq!(near.meet(&beyond_law), Err(ContactError::Unsolved));
    }
}

#[test]
fn val_rotating_the_axes_rotates_the_answer() {
    let wall = Wall {
        clearance: 0.015,
        stiffness: 1e9,
        friction: 0.7,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    };
    let at = |angle: f64| {
        let turn = move |[x, y]: [f64; 2]| {
            [
                x * angle.cos() - y * angle.sin(),
                x * angle.sin() + y * angle.cos(),
            ]
        };
        let contact = Arrival {
            free_position: turn([0.0152, 0.001]),
            previous_position: turn([0.0149, 0.0005]),
            previous_sliding_speed: None,
            free_speed: 6.3,
            compliance: 1e-8,
            torsional_compliance: 5e-5,
            bit: None,
            rate: 640.0,
        }
        .meet(&wall);
        (contact.unwrap(), turn)
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
