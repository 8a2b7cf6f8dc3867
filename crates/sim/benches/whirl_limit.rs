//! What the limits of whirl of many sites cost: `cargo bench -p drillstring-sim --bench whirl_limit`. The paper's
//! string, sites a metre apart from the bit up, one thread.
#![allow(missing_docs, reason = "benchmarks are no interface")]

use std::f64::consts::TAU;

use divan::{Bencher, black_box};
use linear::bending_decay::BendingDecay;
use linear::waves::lateral::BendingNetwork;
use linear::{Complex64, Sites, SurfaceSupport};
use problems::academic::{self, BENDING};
use sim::{Wall, WhirlingSites};

fn main() {
    divan::main();
}

/// 60 and 180 rpm, rad/s.
const SPEEDS: [f64; 2] = [TAU, 3.0 * TAU];

/// Times what is asked of a number of sites.
fn of_sites<T>(
    bencher: Bencher,
    sites: usize,
    asked: impl Fn(&WhirlingSites<&dyn Fn(f64) -> Vec<Complex64>>) -> T,
) {
    let string = academic::string();
    let places: Vec<f64> = (0..sites).map(|site| site as f64).collect();
    let places = Sites::new(&string, &places).unwrap();
    let network = BendingNetwork::new(&string, BENDING, SurfaceSupport::Free, &places).unwrap();
    let receptance = |rate: f64| network.at_rate(rate).entries().to_vec();
    let wall = Wall {
        clearance: 0.015,
        stiffness: 1e9,
        friction: 0.0,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    };
    bencher.bench_local(|| {
        asked(black_box(&WhirlingSites {
            walls: vec![wall; sites],
            receptance: &receptance,
            decay: BendingDecay::new(&string, &BENDING),
        }))
    });
}

const SITES: [usize; 6] = [3, 9, 27, 81, 243, 300];

#[divan::bench(args = SITES, sample_count = 3, sample_size = 1)]
fn any_sites_at_one_speed(bencher: Bencher, sites: usize) {
    of_sites(bencher, sites, |it| it.least_friction([SPEEDS[0]; 2]));
}

#[divan::bench(args = SITES, sample_count = 3, sample_size = 1)]
fn any_sites_over_speeds(bencher: Bencher, sites: usize) {
    of_sites(bencher, sites, |it| it.least_friction(SPEEDS));
}

#[divan::bench(args = [3, 5, 9, 27, 32], sample_count = 1, sample_size = 1)]
fn sliding_together_at_one_speed(bencher: Bencher, sites: usize) {
    of_sites(bencher, sites, |it| it.least_together(SPEEDS[0]));
}
