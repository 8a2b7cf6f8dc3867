use std::cell::Cell;

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

use super::super::contact::Spin;
use super::*;
use crate::sampling::Sampling;

pub(in super::super) fn any_step() -> impl Strategy<Value = (Wall, Approach<'static>)> {
    let wall = (
        0.005..0.1f64,
        0.0..3.0f64,
        0.03..0.3f64,
        7.0..11.0f64,
        any::<bool>(),
    );
    let place = (1.0..3.0f64, 0.0..1.2f64, -3.2..3.2f64);
    let line = (
        -9.0..-5.0f64,
        -6.0..-2.0f64,
        -30.0..30.0f64,
        50.0..2000.0f64,
    );
    (wall, place, line).prop_map(|(wall, (out, before, turned), line)| {
        let (clearance, friction, radius, stiffness, is_rigid) = wall;
        let (compliance, spin_compliance, free_speed, frequency) = line;
        let stiffness = if is_rigid {
            f64::INFINITY
        } else {
            10f64.powf(stiffness)
        };
        let wall = Wall {
            clearance,
            stiffness,
            friction,
            dynamic_ratio: 1.0,
            stribeck_speed: 0.0,
            radius,
        };
        let spin = Spin {
            free_speed,
            compliance: 10f64.powf(spin_compliance),
            resistance: None,
        };
        let approach = Approach {
            free_position: [out * clearance, 0.0],
            previous_position: [turned.cos(), turned.sin()].map(|part| before * clearance * part),
            previous_sliding_speed: None,
            last_force: [0.0; 2],
            present_position: None,
            compliance: 10f64.powf(compliance),
            spin,
            sampling: Sampling::new(frequency, 0.0),
        };
        (wall, approach)
    })
}

/// Where one answer is all there can be, what slides faster the more friction drives
/// it, and searching them all finds the one that is solved for.
#[test]
fn what_has_one_answer_slides_faster_with_more_friction() {
    let counts = [(); 2].map(|()| Cell::new(0));
    let config = Config {
        cases: 20_000,
        failure_persistence: None,
        ..Config::default()
    };
    TestRunner::new(config)
        .run(&any_step(), |(wall, approach)| {
            let distance = approach.free_position[0];
            let press = ContactStep::new(&wall, &approach, distance);
            let has_one = press.has_one_answer();
            let count = &counts[usize::from(has_one)];
            count.set(count.get() + 1);
            if !has_one {
                return Ok(());
            }
            let speeds: Vec<f64> = (-20..=20)
                .map(|part| {
                    press
                        .trial(f64::from(part) / 20.0 * wall.friction)
                        .sliding_speed
                })
                .collect();
            let scale = speeds
                .iter()
                .fold(0.0, |scale: f64, speed| scale.max(speed.abs()));
            for pair in speeds.windows(2) {
                prop_assert!(pair[1] >= pair[0] - 1e-9 * scale, "{speeds:?}");
            }
            let (one, all) = (press.solve().unwrap(), press.search().unwrap());
            prop_assert!(!all.ambiguous, "{all:?}");
            for axis in 0..2 {
                let difference = (one.position[axis] - all.position[axis]).abs();
                prop_assert!(difference <= 1e-9 * distance, "{one:?} {all:?}");
            }
            Ok(())
        })
        .unwrap();
    let [several, one] = counts.map(Cell::into_inner);
    assert!(several > 1000 && one > 5000, "{several} {one}");
}
