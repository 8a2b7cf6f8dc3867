//! Cost of whole cases and of the sum over the past: `cargo bench -p drillstring-sim`.
#![allow(missing_docs, reason = "benchmarks are no interface")]

use divan::{Bencher, black_box};
use linear::{Cascade, Method, Sites, responses};
use problems::academic;
use sim::convolution::{Convolution, Kernel, Kernels};
use sim::{
    EccentricMass, Impulse, Lateral, PipeFriction, Scene, Simulator, Stopping, SurfaceProfile,
    Timing, Wall,
};

fn main() {
    divan::main();
}

const SPEED: f64 = std::f64::consts::TAU;

/// `sites` places of contact, ten metres apart from the bit up.
fn simulator(sites: usize, longest_time: f64) -> Simulator {
    let string = academic::string();
    let distances: Vec<f64> = (0..sites).map(|site| 10.0 * site as f64).collect();
    let request = academic::lateral_request(&string, &distances, longest_time);
    Simulator::new(&responses(&string, &Method::Quadrature, &request).unwrap()).unwrap()
}

fn scene(sites: usize, friction: f64, duration: f64) -> Scene {
    let wall = Wall {
        clearance: 0.015,
        stiffness: 1e9,
        friction,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    };
    Scene {
        start: sim::Start::Rest,
        surface_speed: SPEED,
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: Some(Lateral {
            walls: vec![wall; sites],
            impulses: vec![Impulse {
                site: sites - 1,
                amount: 1000.0,
                start: 1.0,
                duration: 0.02,
                direction: 0.0,
            }],
            eccentric_masses: vec![],
            lying: None,
            shocks: None,
        }),
        timing: Timing {
            duration,
            closing_window: 2.0,
        },
    }
}

fn case(bencher: Bencher, sites: usize, friction: f64, duration: f64, stopping: Stopping) {
    let simulator = simulator(sites, duration);
    let scene = scene(sites, friction, duration);
    bencher.bench(|| black_box(&simulator).simulate(black_box(&scene), stopping, None));
}

/// Ten seconds, rolling whirl from one second to the end.
#[divan::bench(args = [1, 3, 9, 27], sample_count = 10)]
fn whirl(bencher: Bencher, sites: usize) {
    case(bencher, sites, 2.0, 10.0, Stopping::Full);
}

/// Ten seconds, without contact at the end.
#[divan::bench(args = [1, 3, 9, 27], sample_count = 10)]
fn transient(bencher: Bencher, sites: usize) {
    case(bencher, sites, 0.5, 10.0, Stopping::Full);
}

/// Ten seconds, sliding: forward whirl of an eccentric mass, against friction that falls to parts
/// of it.
#[divan::bench(args = [1.0, 0.5], sample_count = 10)]
fn sliding(bencher: Bencher, dynamic_ratio: f64) {
    let simulator = simulator(1, 10.0);
    let mut scene = scene(1, 0.5, 10.0);
    let lateral = scene.lateral.as_mut().unwrap();
    lateral.impulses.clear();
    lateral.eccentric_masses.push(EccentricMass {
        site: 0,
        mass: 1000.0,
        offset: 0.1,
    });
    lateral.walls[0].dynamic_ratio = dynamic_ratio;
    lateral.walls[0].stribeck_speed = 1.0;
    bencher.bench(|| black_box(&simulator).simulate(black_box(&scene), Stopping::Full, None));
}

/// Rolling whirl, and contact that ends, with what is certain or settled left out.
#[divan::bench(args = [1, 3, 9, 27], sample_count = 10)]
fn whirl_until_settled(bencher: Bencher, sites: usize) {
    case(bencher, sites, 2.0, 10.0, Stopping::Early);
}

#[divan::bench(args = [1, 3, 9, 27], sample_count = 10)]
fn transient_until_certain(bencher: Bencher, sites: usize) {
    case(bencher, sites, 0.5, 10.0, Stopping::Early);
}

/// Rolling whirl at one site for more and more steps.
#[divan::bench(args = [6400, 25_600, 102_400], sample_count = 10)]
fn steps(bencher: Bencher, steps: usize) {
    let duration = steps as f64 / academic::SAMPLING_FREQUENCY;
    case(bencher, 1, 2.0, duration, Stopping::Full);
}

fn noise(count: usize) -> Vec<f64> {
    (0..count)
        .map(|n| ((n * n) % 1009) as f64 / 1009.0 - 0.5)
        .collect()
}

/// One response, as many steps as taps: the sum as it is written.
#[divan::bench(args = [1600, 6400, 25_600], sample_count = 10)]
fn history_direct(bencher: Bencher, taps: usize) {
    let (kernel, inputs) = (Kernel::new(&noise(taps)), noise(taps));
    bencher.bench(|| {
        let sums = (0..taps).map(|step| black_box(&kernel).past_sum(&inputs[..step]));
        sums.sum::<f64>()
    });
}

/// The same by blocks.
#[divan::bench(args = [1600, 6400, 25_600], sample_count = 10)]
fn history_by_blocks(bencher: Bencher, taps: usize) {
    let (kernels, inputs) = (Kernels::new(&[vec![noise(taps)]]).unwrap(), noise(taps));
    bencher.bench(|| {
        let mut history = Convolution::new(black_box(&kernels), 1, taps);
        let (mut past, mut sum) = ([0.0], 0.0);
        for &input in &inputs {
            history.past(&mut past).unwrap();
            sum += past[0];
            history.push(&[input]).unwrap();
        }
        sum
    });
}

/// Friction on a number of pieces of a string that sticks and slips, 60 s at 160 Hz.
#[divan::bench(args = [20, 50, 200], sample_count = 10)]
fn string_friction(bencher: Bencher, pieces: usize) {
    let string = academic::damped_string(1.0);
    let piece = string.length() / pieces as f64;
    let middle = |index: usize| (index as f64 + 0.5) * piece;
    let distances: Vec<f64> = (0..pieces).map(middle).chain([0.0]).collect();
    let nodes = Sites::new(&string, &distances).unwrap();
    let cascade = Cascade::new(&string, &Method::Quadrature, &nodes, 160.0, 60.0).unwrap();
    let simulator = Simulator::in_pieces(&cascade, &SurfaceProfile::Rise(2.0), 0.0).unwrap();
    let friction = PipeFriction {
        torque_static: 60_000.0 / pieces as f64,
        torque_dynamic: 30_000.0 / pieces as f64,
        stribeck_speed: 0.5,
    };
    let friction = vec![Some(friction); pieces];
    let scene = Scene {
        surface_speed: 0.5 * SPEED,
        start: sim::Start::Rest,
        bit: None,
        friction: friction.into_iter().chain([None]).collect(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration: 60.0,
            closing_window: 10.0,
        },
    };
    bencher.bench(|| {
        black_box(&simulator)
            .simulate(black_box(&scene), Stopping::Full, None)
            .unwrap()
    });
}

/// Cutting a string at a number of nodes.
#[divan::bench(args = [20, 50, 200], sample_count = 10)]
fn cascade(bencher: Bencher, pieces: usize) {
    let string = academic::damped_string(1.0);
    let piece = string.length() / pieces as f64;
    let distances: Vec<f64> = (0..pieces).map(|it| (it as f64 + 0.5) * piece).collect();
    let nodes = Sites::new(&string, &distances).unwrap();
    bencher.bench(|| Cascade::new(&string, &Method::Quadrature, black_box(&nodes), 160.0, 60.0));
}

/// The sums of three sites in torsion and in two planes of bending, 6400 steps:
/// 27 responses term by term.
#[divan::bench(sample_count = 5)]
fn three_sites_direct(bencher: Bencher) {
    let (kernel, inputs) = (Kernel::new(&noise(6400)), noise(6400));
    bencher.bench(|| {
        let sum = |step: usize| -> f64 {
            (0..27)
                .map(|_| black_box(&kernel).past_sum(&inputs[..step]))
                .sum()
        };
        (0..6400).map(sum).sum::<f64>()
    });
}

/// The same by blocks.
#[divan::bench(sample_count = 5)]
fn three_sites_by_blocks(bencher: Bencher) {
    let kernels = Kernels::new(&vec![vec![noise(6400); 3]; 3]).unwrap();
    let inputs = noise(6400);
    bencher.bench(|| {
        let mut torsion = Convolution::new(black_box(&kernels), 1, 6400);
        let mut bending = Convolution::new(black_box(&kernels), 2, 6400);
        let (mut three, mut six, mut sum) = ([0.0; 3], [0.0; 6], 0.0);
        for &input in &inputs {
            torsion.past(&mut three).unwrap();
            bending.past(&mut six).unwrap();
            sum += three[0] + six[0];
            torsion.push(&[input; 3]).unwrap();
            bending.push(&[input; 6]).unwrap();
        }
        sum
    });
}
