//! What sites and contacts cost: `cargo bench -p drillstring-sim --bench many_sites`. Ten seconds of the
//! paper's string, one thread.
#![allow(missing_docs, reason = "benchmarks are no interface")]

use divan::{Bencher, black_box};
use linear::method::FiniteElement;
use linear::{Method, Sites, SteppedString, SurfaceSupport, responses};
use problems::academic::{self, BENDING, SAMPLING_FREQUENCY};
use sim::{EccentricMass, Lateral, Scene, Simulator, Stopping, SurfaceProfile, Timing, Wall};

fn main() {
    divan::main();
}

const DURATION: f64 = 10.0;

/// Distances from the bit, m, of a number of sites a metre apart.
fn distances(sites: usize) -> Vec<f64> {
    (0..sites).map(|site| site as f64).collect()
}

/// A case in which as many of the sites as are given stay on the wall: each bears a mass that
/// presses it outwards. The others are far from it.
fn scene(sites: usize, touching: usize) -> Scene {
    let wall = |clearance| Wall {
        clearance,
        stiffness: 1e9,
        friction: 0.5,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    };
    // From the bit up, and not side by side: neighbours would push one another inwards.
    let between = sites / touching;
    let touches = |site: usize| (site + 1) % between == 0 && site / between < touching;
    let mass = |site| EccentricMass {
        site,
        mass: 1000.0,
        offset: 0.1,
    };
    Scene {
        start: sim::Start::Rest,
        surface_speed: std::f64::consts::TAU,
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: Some(Lateral {
            walls: (0..sites)
                .map(|site| wall(if touches(site) { 0.015 } else { 10.0 }))
                .collect(),
            impulses: vec![],
            eccentric_masses: (0..sites).filter(|site| touches(*site)).map(mass).collect(),
            lying: None,
            shocks: None,
        }),
        timing: Timing {
            duration: DURATION,
            closing_window: 2.0,
        },
    }
}

fn by_taps(sites: usize) -> Simulator {
    let string = academic::string();
    let request = academic::lateral_request(&string, &distances(sites), DURATION);
    let method = Method::FiniteElement(FiniteElement::default());
    Simulator::new(&responses(&string, &method, &request).unwrap()).unwrap()
}

fn by_steps(sites: usize) -> Simulator {
    let string = academic::string();
    let places = Sites::new(&string, &distances(sites)).unwrap();
    let mesh = SteppedString::new(
        &string,
        &BENDING,
        SurfaceSupport::Free,
        &places,
        &FiniteElement::default(),
        SAMPLING_FREQUENCY,
    )
    .unwrap();
    let responses = mesh.responses(&[], DURATION).unwrap();
    Simulator::stepped(&mesh, &responses, &SurfaceProfile::default()).unwrap()
}

fn case(bencher: Bencher, simulator: &Simulator, sites: usize, touching: usize) {
    let scene = scene(sites, touching);
    bencher.bench(|| black_box(simulator).simulate(black_box(&scene), Stopping::Full, None));
}

const BY_TAPS: [usize; 5] = [1, 3, 9, 27, 32];
const BY_STEPS: [usize; 6] = [3, 9, 27, 81, 243, 300];

#[divan::bench(args = BY_TAPS, sample_count = 5)]
fn taps_with_a_contact(bencher: Bencher, sites: usize) {
    case(bencher, &by_taps(sites), sites, 1);
}

#[divan::bench(args = [3, 9, 27, 32], sample_count = 5)]
fn taps_with_three_contacts(bencher: Bencher, sites: usize) {
    case(bencher, &by_taps(sites), sites, 3);
}

#[divan::bench(args = BY_STEPS, sample_count = 5)]
fn steps_with_a_contact(bencher: Bencher, sites: usize) {
    case(bencher, &by_steps(sites), sites, 1);
}

#[divan::bench(args = BY_STEPS, sample_count = 5)]
fn steps_with_three_contacts(bencher: Bencher, sites: usize) {
    case(bencher, &by_steps(sites), sites, 3);
}

#[divan::bench(args = [27, 81, 243, 300], sample_count = 5)]
fn steps_with_ten_contacts(bencher: Bencher, sites: usize) {
    case(bencher, &by_steps(sites), sites, 10);
}

#[divan::bench(args = [3, 9, 27], sample_count = 3)]
fn prepare_taps(bencher: Bencher, sites: usize) {
    bencher.bench(|| by_taps(black_box(sites)));
}

#[divan::bench(args = BY_STEPS, sample_count = 3)]
fn prepare_steps(bencher: Bencher, sites: usize) {
    bencher.bench(|| by_steps(black_box(sites)));
}
