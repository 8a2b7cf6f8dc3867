//! Validation of the steady motions that a case may begin with: they continue as a case from rest
//! does whose start is long past.

use linear::deviation::exact_undershoot;
use linear::estimates::{
    stick_slip_speed_limit, torsional_impedance, torsional_travel_time, winding_stiffness,
};
use linear::falling_torque::{resonances, steepest_fall};
use linear::steady::{rotation, winding};
use linear::{
    ChannelRequest, Drillstring, Hole, HoleSection, Method, Mud, Request, Responses, Sites,
    TopDrive,
};
use problems::pipes;
use problems::wells::{Draw, Well};
use sim::{
    BitTorque, Scene, Simulator, Start, Stopping, SurfaceProfile, SurfaceTorque, Timing,
    Trajectory, torsion_timing,
};

const SPEED: f64 = 3.0;

/// Time after which nothing of a start is left, and time that is compared after that, s.
const LONG: f64 = 60.0;
const COMPARED: f64 = 6.0;

const BIT: BitTorque = BitTorque {
    torque_static: 9000.0,
    torque_dynamic: 6000.0,
    decay_speed: 0.0,
};

/// Its damping leaves nothing of the start in [`LONG`].
fn string(drive: Option<TopDrive>) -> Drillstring {
    let string = pipes::row(100, 4.0);
    match drive {
        None => string,
        Some(drive) => string.with_top_drive(drive).unwrap(),
    }
}

struct Problem {
    string: Drillstring,
    sites: Sites,
    responses: Responses,
    simulator: Simulator,
    surface_torque: SurfaceTorque,
}

impl Problem {
    fn new(string: Drillstring, method: Method) -> Self {
        let sites = Sites::new(&string, &[400.0, 0.0]).unwrap();
        let request = Request {
            sites: sites.clone(),
            channels: vec![ChannelRequest::Torsion { torques: vec![1] }],
            sampling_frequency: 200.0,
            longest_time: LONG + COMPARED,
        };
        let responses = linear::responses(&string, &method, &request).unwrap();
        let taps = linear::surface_torque(&string, &method, &request).unwrap();
        let profile = SurfaceProfile::default();
        Self {
            surface_torque: SurfaceTorque::new(&responses, &taps, &profile, 0.0).unwrap(),
            simulator: Simulator::new(&responses).unwrap(),
            string,
            sites,
            responses,
        }
    }

    fn motion(&self, start: Start, bit: BitTorque, duration: f64) -> Trajectory {
        let scene = Scene {
            surface_speed: SPEED,
            start,
            bit: Some(bit),
            friction: Vec::new(),
            axial: None,
            lateral: None,
            timing: Timing {
                duration,
                closing_window: 1.0,
            },
        };
        let mut motion = Trajectory::default();
        let record = Some(&mut motion);
        (self.simulator.simulate(&scene, Stopping::Full, record)).unwrap();
        motion.surface_torque = self.surface_torque.of(SPEED, &scene.start, &motion);
        motion
    }
}

/// The largest difference of a motion from the end of another, in parts of the largest value.
fn off(late: &[f64], from: usize, motion: &[f64]) -> f64 {
    let largest = motion
        .iter()
        .fold(0.0f64, |most, value| most.max(value.abs()));
    let differences = late[from..]
        .iter()
        .zip(motion)
        .map(|(one, other)| (one - other).abs());
    differences.fold(0.0, f64::max) / largest
}

fn assert_continues(problem: &Problem, late: &Trajectory, from: usize, begun: &Trajectory) {
    let speeds = late.speeds.iter().zip(&begun.speeds);
    let torques = [
        (&late.bit_torque, &begun.bit_torque),
        (&late.surface_torque, &begun.surface_torque),
    ];
    for (late, begun) in speeds.chain(torques) {
        let off = off(late, from, begun);
        let method = problem.responses.method.name();
        assert!(off < 2e-4, "{method}: {off}");
    }
}

fn problems() -> impl Iterator<Item = Problem> {
    let drive = TopDrive {
        inertia: 1500.0,
        proportional_gain: 3000.0,
        integral_gain: 2000.0,
        delay: 0.0,
        late_inertia: 0.0,
    };
    let methods = [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(Default::default()),
    ];
    let drives = [None, Some(drive)];
    (methods.into_iter())
        .flat_map(move |method| drives.map(|drive| Problem::new(string(drive), method)))
}

/// A bit that is held while the string winds up for a minute, and breaks loose.
#[test]
fn val_a_string_that_winds_up_steadily_continues_as_after_a_long_time_from_rest() {
    for problem in problems() {
        let mut stubborn = BIT;
        // It breaks loose after some LONG.
        stubborn.torque_static = LONG * SPEED * winding_stiffness(&problem.string);
        let late = problem.motion(Start::Rest, stubborn, LONG + COMPARED);
        let slip = late.speeds[1].iter().position(|speed| *speed > 0.0);
        let slip = slip.expect("it breaks loose");
        let (held, before) = (late.bit_torque[slip - 1], late.bit_torque[slip - 2]);
        let offset = problem.responses.method.collocation_offset();
        let torque = -(held + (1.0 - offset) * (held - before));
        let start = winding(&problem.string, &problem.sites, SPEED, torque);
        let eager = BitTorque {
            // The first step is the one in which it breaks loose.
            torque_static: torque * (1.0 - 1e-9),
            ..stubborn
        };
        let begun = problem.motion(Start::Steady(start), eager, COMPARED - 1.0);
        assert!(begun.speeds[1][0] > 0.0);
        assert_continues(&problem, &late, slip, &begun);
    }
}

/// A bit that has turned for a minute turns on.
#[test]
fn val_a_string_that_rotates_steadily_continues_as_after_a_long_time_from_rest() {
    for problem in problems() {
        let late = problem.motion(Start::Rest, BIT, LONG);
        let from = (0.9 * LONG * 200.0) as usize;
        let start = rotation(&problem.string, &problem.sites, SPEED, BIT.torque_dynamic);
        let begun = problem.motion(Start::Steady(start), BIT, 0.09 * LONG);
        assert!((begun.speeds[1][0] / SPEED - 1.0).abs() < 1e-12);
        assert_continues(&problem, &late, from, &begun);
    }
}

/// The bit slows down by what the greater torque takes of the speed of its collars.
#[test]
fn val_a_torque_that_rises_slows_the_bit_down_as_its_impedance_says() {
    let problem = Problem::new(string(None), Method::Held);
    let start = rotation(
        &problem.string,
        &problem.sites,
        SPEED,
        0.9 * BIT.torque_dynamic,
    );
    let motion = problem.motion(Start::Steady(start), BIT, 0.02);
    let pipe = problem.string.sections()[0].parts[0];
    let impedance = torsional_impedance(&problem.string, &pipe);
    let expected = SPEED - 0.1 * BIT.torque_dynamic / impedance;
    let found = motion.speeds[1][1];
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
}

/// On random strings about their limits: what is certain is so, and what has settled too.
#[test]
fn val_cases_that_end_early_have_the_labels_of_those_that_do_not() {
    let mut ended = [0; 3];
    let mut labels = [0; 3];
    for number in 0..24 {
        let mut draw = Draw::new(number);
        let string = Well::draw(number, &mut draw).string;
        let rate = draw.uniform(1.1, 1.6);
        let bit = BitTorque {
            torque_dynamic: 4000.0,
            torque_static: 4000.0 * rate,
            decay_speed: 0.0,
        };
        let undershoot = exact_undershoot(&string).unwrap();
        let speed = stick_slip_speed_limit(undershoot, bit.torque_static, bit.torque_dynamic)
            * draw.uniform(0.3, 1.5);
        let sites = Sites::bit();
        let starts = [
            winding(&string, &sites, speed, bit.torque_static),
            rotation(&string, &sites, speed, 0.9 * bit.torque_dynamic),
        ];
        let scenes = starts.map(|start| {
            let start = Start::Steady(start);
            Scene {
                surface_speed: speed,
                timing: torsion_timing(&string, speed, &bit, &start),
                start,
                bit: Some(bit),
                friction: Vec::new(),
                axial: None,
                lateral: None,
            }
        });
        let request = Request {
            sites,
            channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
            sampling_frequency: (200.0 / torsional_travel_time(&string)).min(600.0),
            longest_time: scenes[0].timing.duration,
        };
        let responses = linear::responses(&string, &Method::Held, &request).unwrap();
        let simulator = Simulator::new(&responses).unwrap();
        for scene in scenes {
            let regime = |stopping| {
                let outcome = simulator.simulate(&scene, stopping, None).unwrap();
                (outcome.torsion().unwrap().regime, outcome.ended)
            };
            let ((early, how), (full, _)) = (regime(Stopping::Early), regime(Stopping::Full));
            assert_eq!(early, full, "{number}: {how:?}");
            ended[how as usize] += 1;
            labels[full as usize] += 1;
        }
    }
    println!("ended {ended:?}, labels {labels:?}");
    assert!(ended.iter().all(|count| *count > 0), "{ended:?}");
    assert!(labels[1..].iter().all(|count| *count > 5), "{labels:?}");
}

/// The speed of the bit in a motion that begins in smooth rotation with a disturbance too small to
/// matter to its law.
fn disturbed(string: &Drillstring, frequency: f64, bit: BitTorque, speed: f64) -> Vec<f64> {
    const TRAVELS: f64 = 320.0;
    let travel = torsional_travel_time(string);
    let request = Request {
        sites: Sites::bit(),
        channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
        sampling_frequency: frequency,
        longest_time: TRAVELS * travel,
    };
    let responses = linear::responses(string, &Method::Held, &request).unwrap();
    let torque = (1.0 - 1e-6) * bit.torque_at(speed);
    let scene = Scene {
        surface_speed: speed,
        start: Start::Steady(rotation(string, &request.sites, speed, torque)),
        bit: Some(bit),
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration: request.longest_time,
            closing_window: 1.0,
        },
    };
    let mut motion = Trajectory::default();
    let simulator = Simulator::new(&responses).unwrap();
    (simulator.simulate(&scene, Stopping::Full, Some(&mut motion))).unwrap();
    motion.speeds.swap_remove(0)
}

/// The root mean square deviation of a bit's speed from the surface's, in an early and in the last
/// part of a motion.
fn deviations(speeds: &[f64], speed: f64) -> [f64; 2] {
    let window = speeds.len() / 8;
    [3, 7].map(|place| {
        let part = &speeds[place * window..(place + 1) * window];
        let squares = part.iter().map(|it| (it - speed).powi(2)).sum::<f64>();
        (squares / window as f64).sqrt()
    })
}

/// On random strings, under torques that fall with the speed: small vibration grows below the
/// limit of smooth rotation of the lowest modes and dies away above that of all that are stepped.
#[test]
fn val_smooth_rotation_is_lost_below_its_limit_and_lasts_above() {
    for number in 0..12 {
        let mut draw = Draw::new(number);
        let string = Well::draw(number, &mut draw).string;
        let travel = torsional_travel_time(&string);
        let frequency = 256.0 / travel;
        let of_lowest = steepest_fall(&string, 4.0 / travel).unwrap().unwrap();
        let of_all = steepest_fall(&string, 0.5 * frequency).unwrap().unwrap();
        let drop = 4000.0 * draw.uniform(0.1, 0.5);
        let bit = BitTorque {
            torque_static: 4000.0 + drop,
            torque_dynamic: 4000.0,
            // The torque falls too steeply up to about this speed.
            decay_speed: drop / (of_lowest * draw.uniform(2.0, 6.0)),
        };
        let speed = 0.5 * bit.speed_of_fall(of_lowest).unwrap();
        let [early, late] = deviations(&disturbed(&string, frequency, bit, speed), speed);
        assert!(late > 1e-3, "{number}: {early:.2e} {late:.2e}");
        let speed = 1.4 * bit.speed_of_fall(of_all).unwrap();
        let [early, late] = deviations(&disturbed(&string, frequency, bit, speed), speed);
        assert!(late < 0.5 * early, "{number}: {early:.2e} {late:.2e}");
    }
}

/// In mud, and of a material with loss: below the speed of the resonance that bears least vibration
/// grows at its frequency, and above that speed all of it dies away. So high-frequency torsional
/// oscillation is that of the linear criterion.
#[test]
fn val_with_loss_vibration_grows_at_the_resonance_that_bears_least() {
    for number in 0..8 {
        let mut draw = Draw::new(number);
        let plain = Well::draw(number, &mut draw).string;
        let tubes = plain.sections().iter().flat_map(|section| &section.parts);
        let widest = tubes.map(|tube| tube.outer_radius);
        let section = HoleSection {
            length: plain.length(),
            radius: 1.3 * widest.fold(0.0, f64::max),
        };
        let mud = Mud {
            density: 1300.0,
            viscosity: draw.uniform(0.01, 0.05),
        };
        let sections = vec![section];
        let string = (plain.in_hole(Hole { sections, mud }))
            .and_then(|string| string.with_loss_factor(draw.uniform(1e-3, 5e-3)))
            .unwrap();
        let resonances = resonances(&string, 1000.0).unwrap().into_iter();
        let least = resonances
            .max_by(|one, other| one.mobility.total_cmp(&other.mobility))
            .unwrap();
        let travel = torsional_travel_time(&string);
        let frequency = (24.0 * least.frequency).max(256.0 / travel);
        let drop = 4000.0 * draw.uniform(0.1, 0.5);
        let bit = BitTorque {
            torque_static: 4000.0 + drop,
            torque_dynamic: 4000.0,
            decay_speed: drop / (3.0 * least.steepest_fall()),
        };
        let limit = bit.speed_of_fall(least.steepest_fall()).unwrap();
        let speed = 1.15 * limit;
        let [early, late] = deviations(&disturbed(&string, frequency, bit, speed), speed);
        assert!(late < 0.5 * early, "{number}: {early:.2e} {late:.2e}");
        let speed = 0.9 * limit;
        let speeds = disturbed(&string, frequency, bit, speed);
        let [early, late] = deviations(&speeds, speed);
        assert!(late > 2.0 * early, "{number}: {early:.2e} {late:.2e}");
        let window = &speeds[7 * speeds.len() / 8..];
        let mean = window.iter().sum::<f64>() / window.len() as f64;
        let upward = (window.windows(2)).filter(|ends| ends[0] < mean && ends[1] >= mean);
        let found = upward.count() as f64 * frequency / window.len() as f64;
        let off = (found / least.frequency - 1.0).abs();
        assert!(off < 0.1, "{number}: {found} Hz, {} Hz", least.frequency);
    }
}
