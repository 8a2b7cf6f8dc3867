//! Cost of one contact solve: `cargo bench -p drillstring-sim`.
#![allow(missing_docs, reason = "benchmarks are no interface")]

use divan::{Bencher, black_box};
use sim::laws::contact::{Approach, Spin, Touch};
use sim::{Sampling, Wall, WallLaw};

fn main() {
    divan::main();
}

fn approach(free_speed: f64) -> Approach<'static> {
    Approach {
        free_position: [0.0163, -0.0004],
        previous_position: [0.0160, 0.0002],
        previous_sliding_speed: None,
        last_force: [0.0; 2],
        present_position: None,
        compliance: 1e-8,
        spin: Spin {
            free_speed,
            compliance: 5e-5,
            resistance: None,
        },
        sampling: Sampling::new(640.0, 0.0),
    }
}

fn wall(friction: f64, stiffness: f64) -> Wall {
    Wall {
        clearance: 0.015,
        stiffness,
        friction,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    }
}

fn solve(bencher: Bencher, wall: Wall, touch: Touch) {
    let approach = approach(6.3);
    assert_eq!(wall.meet(&approach).map(|met| met.touch), Ok(touch));
    bencher.bench_local(|| black_box(&wall).meet(black_box(&approach)));
}

#[divan::bench(args = [1e9, f64::INFINITY])]
fn sliding(bencher: Bencher, stiffness: f64) {
    solve(bencher, wall(0.1, stiffness), Touch::Sliding);
}

#[divan::bench(args = [1e9, f64::INFINITY])]
fn rolling(bencher: Bencher, stiffness: f64) {
    solve(bencher, wall(20.0, stiffness), Touch::Rolling);
}

/// At a speed at which half of what falls is left, as it did before.
#[divan::bench(args = [1e9, f64::INFINITY])]
fn sliding_against_falling_friction(bencher: Bencher, stiffness: f64) {
    let wall = Wall {
        dynamic_ratio: 0.5,
        stribeck_speed: 1.0,
        ..wall(0.1, stiffness)
    };
    solve(bencher, wall, Touch::Sliding);
}
