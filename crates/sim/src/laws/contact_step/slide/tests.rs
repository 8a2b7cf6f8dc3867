use std::cell::Cell;

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

use super::super::tests::any_step;
use super::*;
use crate::laws::contact::{Approach, WallLaw};

/// Ratios that are tried for roots.
const TRIED: u32 = 1000;

/// Stribeck's curve against surfaces that slide at a speed, or roll.
fn stribeck(wall: &Wall, speed: f64) -> f64 {
    let left = if speed <= 0.0 {
        1.0
    } else if wall.stribeck_speed == 0.0 {
        0.0
    } else {
        f64::exp(-speed * speed / (wall.stribeck_speed * wall.stribeck_speed))
    };
    wall.friction * (wall.dynamic_ratio + (1.0 - wall.dynamic_ratio) * left)
}

/// Sliding speeds at which the friction tried is that of the speed, as far as the trials tell,
/// from the fastest; none of them where what slides one way is held by all friction.
fn roots(wall: &Wall, direction: f64, speed_under: impl Fn(f64) -> f64) -> Vec<f64> {
    let friction = wall.friction;
    let dynamic = wall.dynamic_ratio * friction;
    let places = (0..=TRIED).map(|place| {
        let against = dynamic + (friction - dynamic) * f64::from(place) / f64::from(TRIED);
        let speed = direction * speed_under(-direction * against);
        (speed, stribeck(wall, speed) - against)
    });
    let places: Vec<(f64, f64)> = places.collect();
    let crossings = places.windows(2).filter(|pair| {
        let [(_, before), (_, after)] = [pair[0], pair[1]];
        (before >= 0.0) != (after >= 0.0) || after == 0.0
    });
    crossings
        .map(|pair| 0.5 * (pair[0].0 + pair[1].0))
        .filter(|speed| *speed > 0.0)
        .collect()
}

/// What Friedlander's rule takes: a sliding speed, positive forwards; zero where it rolls.
fn by_rule(wall: &Wall, before: f64, speed_under: impl Fn(f64) -> f64) -> f64 {
    let fast = 0.5f64.sqrt() * wall.stribeck_speed;
    if before.abs() > fast {
        let found = roots(wall, before.signum(), &speed_under);
        if let Some(speed) = found.first().filter(|speed| **speed > fast) {
            return before.signum() * speed;
        }
    }
    let held = [1.0, -1.0].map(|direction| (direction, speed_under(-direction * wall.friction)));
    match held
        .iter()
        .find(|(direction, speed)| direction * speed > 0.0)
    {
        None => 0.0,
        Some((direction, _)) => {
            let slowest = roots(wall, *direction, &speed_under).last().copied();
            direction * slowest.unwrap_or(f64::NAN)
        }
    }
}

/// Every branch, against a scan of all possible friction.
#[test]
fn a_site_keeps_doing_what_it_did() {
    let counts = [(); 4].map(|()| Cell::new(0));
    let config = Config {
        cases: 20_000,
        failure_persistence: None,
        ..Config::default()
    };
    let scales = prop_oneof![1 => Just(0.0), 3 => (-1.0..0.5f64).prop_map(|e| 10f64.powf(e))];
    let before = prop_oneof![1 => Just(None), 4 => (-1.5..1.5f64).prop_map(Some)];
    TestRunner::new(config)
        .run(&(any_step(), 0.0..1.0f64, scales, before), |drawn| {
            let ((wall, approach), dynamic_ratio, scale, before) = drawn;
            let distance = approach.free_position[0];
            let step = |wall: &Wall, ratio: f64| {
                ContactStep::new(wall, &approach, distance)
                    .trial(ratio)
                    .sliding_speed
            };
            // Of speeds that friction makes a difference to.
            let most = step(&wall, wall.friction) - step(&wall, -wall.friction);
            let wall = Wall {
                dynamic_ratio,
                stribeck_speed: scale * most,
                ..wall
            };
            let press = ContactStep::new(&wall, &approach, distance);
            if !press.has_one_answer() || distance <= wall.clearance {
                return Ok(());
            }
            let free = press.trial(0.0).sliding_speed;
            let expected = by_rule(&wall, before.map_or(free, |part| part * most), |ratio| {
                step(&wall, ratio)
            });
            let approach = Approach {
                previous_sliding_speed: before.map(|part| part * most),
                last_force: [0.0; 2],
                present_position: None,
                ..approach
            };
            let found: Contact = wall.meet(&approach).unwrap();
            let speed = found.sliding_speed;
            // What a scan can tell: speeds to within its places, and no two roots in one.
            let apart = (speed - expected).abs();
            let borders = 0.5f64.sqrt() * wall.stribeck_speed;
            let nearly = [found.sliding_speed, expected]
                .map(|it| (it.abs() / borders - 1.0).abs() < 0.05)
                .contains(&true);
            let kind = match (found.touch, speed == 0.0) {
                (Touch::Rolling, _) => 0,
                _ if before.is_none() => 1,
                _ if wall.is_fast(speed.abs()) => 2,
                _ => 3,
            };
            counts[kind].set(counts[kind].get() + 1);
            prop_assert!(
                apart <= 0.01 * most || nearly,
                "{found:?} instead of {expected}, most {most}"
            );
            Ok(())
        })
        .unwrap();
    let counts = counts.map(Cell::into_inner);
    assert!(counts.iter().all(|count| *count > 300), "{counts:?}");
}
