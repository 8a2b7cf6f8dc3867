use std::cell::Cell;

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

use super::super::contact::Touch;
use super::super::contact_step::tests::any_step;
use super::*;
use crate::sampling::Sampling;

/// A step in the middle of which the law is met, of a site that came from the wall and slid either way or
/// rolled there, and the part of the force to begin from.
fn any_continued_step() -> impl Strategy<Value = (Wall, Approach<'static>, f64)> {
    let depth = (-7.0..-1.0f64).prop_map(|power| 10f64.powf(power));
    let moved = [-0.3..0.3f64, -0.3..0.3f64];
    (
        any_step(),
        depth,
        -3.2..3.2f64,
        moved,
        -1..=1i32,
        0.3..1.5f64,
    )
        .prop_map(
            |((wall, approach), depth, angle, [out, across], slid, part)| {
                let [cos, sin] = [angle.cos(), angle.sin()];
                let before = wall.clearance * (1.0 + depth);
                let approach = Approach {
                    previous_position: [before * cos, before * sin],
                    free_position: [
                        before * ((1.0 + out) * cos - across * sin),
                        before * ((1.0 + out) * sin + across * cos),
                    ],
                    previous_sliding_speed: Some(f64::from(slid)),
                    sampling: Sampling::new(approach.sampling.frequency, 0.5),
                    ..approach
                };
                (wall, approach, part)
            },
        )
}

/// Newton's method and the secant rule, which share but the way in which a site rolls, find the same.
#[test]
fn what_continues_is_what_the_secant_rule_finds() {
    let counts = [(); 2].map(|()| Cell::new(0));
    let config = Config {
        cases: 100_000,
        failure_persistence: None,
        ..Config::default()
    };
    TestRunner::new(config)
        .run(&any_continued_step(), |(wall, approach, part)| {
            let Some(expected) = wall.work_of_wall(&approach) else {
                return Ok(());
            };
            let last_force = expected.force.map(|force| part * force);
            let Some(found) = wall.continues(&Approach {
                last_force,
                ..approach
            }) else {
                return Ok(());
            };
            let count = &counts[usize::from(found.touch == Touch::Rolling)];
            count.set(count.get() + 1);
            prop_assert_eq!(found.touch, expected.touch);
            let off = |one: [f64; 2], other: [f64; 2], scale: f64| {
                (one[0] - other[0]).hypot(one[1] - other[1]) / scale
            };
            let scales = [length(approach.free_position), length(expected.force)];
            let offs = [
                off(found.position, expected.position, scales[0]),
                off(found.force, expected.force, scales[1]),
            ];
            prop_assert!(
                offs[0] < 1e-10 && offs[1] < 1e-8,
                "{offs:?} {found:?} {expected:?}"
            );
            Ok(())
        })
        .unwrap();
    let [slides, rolls] = counts.map(Cell::into_inner);
    assert!(slides > 3000 && rolls > 2000, "{slides} {rolls}");
}
