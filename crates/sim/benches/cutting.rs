//! Cost of a case of a bit that cuts, next to one of the same string whose bit has a law of friction:
//! `cargo bench -p drillstring-sim --bench cutting`.
#![allow(missing_docs, reason = "benchmarks are no interface")]

use divan::{Bencher, black_box};
use linear::{ChannelRequest, GrowingTorque, Method, Request, Responses, Sites, SteadyMotion};
use problems::dashpots::{BelowDashpots, pipe};
use sim::laws::rock::CuttingLaw;
use sim::{
    Axial, BitTorque, Blades, Cutting, FlatContact, Kick, Scene, Simulator, Start, Stopping,
    SurfaceProfile, System, Timing,
};

fn main() {
    divan::main();
}

/// rad/s.
const SPEED: f64 = 4.0;

/// m/s.
const RATE: f64 = 0.006;

/// Of a plain string that sends back most of a torsional wave and little of an axial one, at 640 Hz.
fn responses(duration: f64, is_axial: bool) -> Responses {
    let below = BelowDashpots::new(&[pipe(2000.0)], [0.9, 0.3]);
    let mut channels = vec![ChannelRequest::Torsion { torques: vec![0] }];
    if is_axial {
        channels.push(ChannelRequest::Axial {
            rod: Box::new(below.rod.clone()),
            forces: vec![0],
        });
    }
    let request = Request {
        sites: Sites::bit(),
        channels,
        sampling_frequency: 640.0,
        longest_time: duration,
    };
    linear::responses(&below.string, &Method::Held, &request).unwrap()
}

/// It turns steadily against a torque, N m, kicked.
fn scene(duration: f64, torque: f64) -> Scene {
    let steady = |torque: f64| GrowingTorque { torque, rate: 0.0 };
    Scene {
        surface_speed: SPEED,
        start: Start::Steady(SteadyMotion {
            speeds: vec![SPEED],
            at_bit: steady(-torque),
            at_surface: steady(torque),
        }),
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration,
            closing_window: 0.5 * duration,
        },
    }
}

fn case(bencher: Bencher, simulator: &Simulator, scene: &Scene) {
    bencher.bench(|| {
        black_box(simulator)
            .simulate(black_box(scene), Stopping::Full, None)
            .unwrap()
    });
}

/// Torsion alone: a bit that sticks and slips by its law.
#[divan::bench(args = [10.0, 60.0], sample_count = 50)]
fn law_of_friction(bencher: Bencher, duration: f64) {
    let simulator = Simulator::new(&responses(duration, false)).unwrap();
    let bit = BitTorque {
        torque_static: 6000.0,
        torque_dynamic: 4300.0,
        decay_speed: 1.0,
    };
    let mut scene = scene(duration, 4300.0 + 1700.0 * (-SPEED).exp());
    scene.bit = Some(bit);
    case(bencher, &simulator, &scene);
}

/// A bit that sticks and slips because its blades cut what they have left.
#[divan::bench(args = [10.0, 60.0], sample_count = 50)]
fn even_blades(bencher: Bencher, duration: f64) {
    cutting(bencher, duration, (Blades::Even(4), relief()));
}

/// The same where nothing bounds how fast they sink in: rock ahead may be so steep that more than one
/// speed would do.
#[divan::bench(args = [10.0, 60.0], sample_count = 50)]
fn even_blades_without_relief(bencher: Bencher, duration: f64) {
    cutting(bencher, duration, (Blades::Even(4), f64::INFINITY));
}

/// The same with four rocks to keep.
#[divan::bench(args = [10.0, 60.0], sample_count = 50)]
fn uneven_blades(bencher: Bencher, duration: f64) {
    let angles = [80f64, 100.0, 85.0, 95.0].map(f64::to_radians);
    cutting(
        bencher,
        duration,
        (Blades::Uneven(angles.to_vec()), relief()),
    );
}

/// That of 60°.
fn relief() -> f64 {
    60f64.to_radians().tan()
}

fn cutting(bencher: Bencher, duration: f64, (blades, relief): (Blades, f64)) {
    let responses = responses(duration, true);
    let profile = SurfaceProfile::Rise(0.0);
    let system = System::started(&responses, &profile).unwrap();
    let simulator = Simulator::of(system.moving_along(&responses, &profile).unwrap());
    let cutting = Cutting {
        rock: CuttingLaw {
            bit_radius: 0.108,
            specific_energy: 60e6,
            cutting_ratio: 0.6,
            friction: 0.6,
            contact_strength: 60e6,
            contact_growth: 1.0,
            wear_flat: 5e-3,
            poor_cleaning: None,
        },
        contact: FlatContact::AtOnce,
        blades,
        relief,
    };
    let advance = RATE / SPEED * std::f64::consts::TAU / 4.0;
    let mut scene = scene(duration, cutting.steady(advance)[0]);
    scene.axial = Some(Axial {
        cutting,
        feed: RATE,
        start_rate: RATE,
        kick: Some(Kick {
            torque: 1000.0,
            force: 5000.0,
            duration: 2.0,
        }),
    });
    case(bencher, &simulator, &scene);
}
