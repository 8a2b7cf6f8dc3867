//! Friction at the wall that falls with the sliding speed, against an integration of the same
//! equations in much shorter steps that shares nothing with this crate: no load lines, no
//! branches. Which of several solutions is taken follows there from a little inertia.

use linear::passivity::Ending;
use linear::{ChannelRequest, Method, Request, Responses, Sites};
use problems::{academic, pipes};
use sim::laws::contact::{Contact, Touch};
use sim::{
    BitTorque, EccentricMass, Ended, Impulse, Lateral, Scene, Simulator, Stepper, Stopping, System,
    Timing, Wall,
};

/// A mass on a spring and a damper in both directions, kg, N s/m, N/m; it turns at the end of a
/// shaft so long that no echo comes back, of this impedance, N m s/rad.
const MASS: f64 = 100.0;
const DAMPING: f64 = 2000.0;
const STIFFNESS: f64 = 4e4;
const IMPEDANCE: f64 = 25.0;
/// The shaft turns at this speed, rad/s.
const SPEED: f64 = 3.0;
/// A push along x that grows and wanes, and a short impulse across it, N s.
const PUSH: Impulse = Impulse {
    site: 0,
    amount: 2000.0,
    start: 0.0,
    duration: 1.5,
    direction: 0.0,
};
const SHORT: Impulse = Impulse {
    site: 0,
    amount: 50.0,
    start: 0.3,
    duration: 0.02,
    direction: -std::f64::consts::FRAC_PI_2,
};
const DURATION: f64 = 1.2;

/// Where it presses with more than 780 N friction falls by more than the shaft gives way: speeds
/// between do not last, and it jumps.
const WALL: Wall = Wall {
    clearance: 0.015,
    stiffness: 1e7,
    friction: 0.5,
    dynamic_ratio: 0.4,
    stribeck_speed: 0.1,
    radius: 0.1,
};

/// The mass by implicit differences, in the place of a string's responses.
fn responses(sampling_frequency: f64) -> Responses {
    let request = Request {
        sites: Sites::bit(),
        channels: vec![
            ChannelRequest::Torsion { torques: vec![0] },
            academic::free_in_bending(),
        ],
        sampling_frequency: 10.0,
        longest_time: 1.0,
    };
    let mut responses =
        linear::responses(&pipes::row(5, 10.0), &Method::Quadrature, &request).unwrap();
    let steps = (DURATION * sampling_frequency) as usize + 2;
    let dt = sampling_frequency.recip();
    let (inertia, loss) = (MASS / (dt * dt), DAMPING / dt);
    let mut places = vec![0.0; steps + 2];
    for step in 0..steps {
        let [before, last] = [places[step], places[step + 1]];
        let force = if step == 0 { 1.0 } else { 0.0 };
        let pushed = force + inertia * (2.0 * last - before) + loss * last;
        places[step + 2] = pushed / (inertia + loss + STIFFNESS);
    }
    let at_once = |amount: f64| vec![amount, 0.0];
    responses.sampling_frequency = sampling_frequency;
    responses.longest_time = DURATION;
    let [torsion, bending] = &mut responses.channels[..] else {
        panic!("two channels");
    };
    torsion.from_surface = vec![at_once(1.0)];
    torsion.from_loads = vec![vec![at_once(IMPEDANCE.recip())]];
    torsion.ending = Ending::Whole;
    bending.from_loads = vec![vec![places.split_off(2)]];
    bending.ending = Ending::Cut;
    responses
}

fn contacts(sampling_frequency: f64, wall: Wall) -> Vec<Contact> {
    let system = System::new(&responses(sampling_frequency)).unwrap();
    let scene: Scene<BitTorque> = Scene {
        start: sim::Start::Rest,
        surface_speed: SPEED,
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: Some(Lateral {
            walls: vec![wall],
            impulses: vec![PUSH, SHORT],
            eccentric_masses: vec![],
            lying: None,
            shocks: None,
        }),
        timing: Timing {
            duration: DURATION,
            closing_window: 1.0,
        },
    };
    let mut stepper = Stepper::new(&system, &scene).unwrap();
    let mut contacts = Vec::new();
    while let Some(step) = stepper.step().unwrap() {
        contacts.push(step.contacts[0]);
    }
    contacts
}

/// Where the mass is across the push, at a number of times a second: Newton's equations, an inertia
/// that the shaft turns within ten microseconds, and friction that stops what it would turn back.
fn integrated(wall: &Wall, per_second: usize) -> Vec<f64> {
    const PARTS: usize = 5000;
    let dt = 1.0 / (per_second * PARTS) as f64;
    let inertia = 1e-5 * IMPEDANCE;
    let ([mut x, mut y], [mut vx, mut vy], mut turning) = ([0.0f64; 2], [0.0f64; 2], SPEED);
    let steps = (DURATION * per_second as f64) as usize * PARTS;
    let mut places = vec![0.0];
    for step in 1..=steps {
        let time = step as f64 * dt;
        let [push, short] = [PUSH, SHORT].map(|it| {
            let part = ((time - it.start) / it.duration).clamp(0.0, 1.0);
            it.amount / it.duration * (1.0 - (std::f64::consts::TAU * part).cos())
        });
        let radius = x.hypot(y);
        let depth = (radius - wall.clearance).max(0.0);
        let normal = wall.stiffness * depth * depth.sqrt();
        let [cos, sin] = if radius > 0.0 {
            [x / radius, y / radius]
        } else {
            [1.0, 0.0]
        };
        let slid = wall.radius * turning - vx * sin + vy * cos;
        vx += dt / MASS * (push - STIFFNESS * x - DAMPING * vx - normal * cos);
        vy += dt / MASS * (-short - STIFFNESS * y - DAMPING * vy - normal * sin);
        turning += dt / inertia * IMPEDANCE * (SPEED - turning);
        let slides = wall.radius * turning - vx * sin + vy * cos;
        let gives = dt * (wall.radius * wall.radius / inertia + 1.0 / MASS);
        let scaled = slid / wall.stribeck_speed;
        let falling = (1.0 - wall.dynamic_ratio) * (-scaled * scaled).exp();
        let most = wall.friction * (wall.dynamic_ratio + falling) * normal;
        let friction = (-slides / gives).clamp(-most, most);
        vx -= dt / MASS * friction * sin;
        vy += dt / MASS * friction * cos;
        turning += dt / inertia * wall.radius * friction;
        x += dt * vx;
        y += dt * vy;
        if step % PARTS == 0 {
            places.push(y);
        }
    }
    places
}

/// The mass is carried along by the wall and slides back, again and again.
#[test]
fn val_motion_is_that_of_much_shorter_steps() {
    let per_second = 1000;
    let expected = integrated(&WALL, per_second);
    let furthest = expected.iter().fold(0.0f64, |most, y| most.max(y.abs()));
    let errors = [1, 4, 16].map(|times| {
        let found = contacts((per_second * times) as f64, WALL);
        let lets_go =
            |pair: &&[Contact]| [pair[0].touch, pair[1].touch] == [Touch::Rolling, Touch::Sliding];
        assert_eq!(found.windows(2).filter(lets_go).count(), 3);
        let apart = (found.iter().step_by(times).zip(&expected))
            .map(|(found, expected)| (found.position[1] - expected).abs());
        apart.fold(0.0, f64::max) / furthest
    });
    assert!(
        errors.windows(2).all(|pair| pair[1] < 0.4 * pair[0]),
        "{errors:?}"
    );
    assert!(errors[2] < 0.005, "{errors:?}");
}

/// What rolls does not feel the speed at which friction would fall.
#[test]
fn val_sliding_that_friction_may_shake_is_not_taken_as_settled() {
    let request = academic::lateral_request(&academic::string(), &[0.0], 10.0);
    let responses = linear::responses(&academic::string(), &Method::Quadrature, &request).unwrap();
    let simulator = Simulator::new(&responses).unwrap();
    let ended = |friction: f64, dynamic_ratio: f64, [short, eccentric]: [f64; 2]| {
        let wall = Wall {
            stiffness: 1e9,
            friction,
            dynamic_ratio,
            radius: 0.15,
            ..WALL
        };
        let scene = Scene {
            start: sim::Start::Rest,
            surface_speed: std::f64::consts::TAU,
            bit: None,
            friction: Vec::new(),
            axial: None,
            lateral: Some(Lateral {
                walls: vec![wall],
                impulses: vec![Impulse {
                    amount: short,
                    ..SHORT
                }],
                eccentric_masses: vec![EccentricMass {
                    site: 0,
                    mass: eccentric,
                    offset: 0.1,
                }],
                lying: None,
                shocks: None,
            }),
            timing: Timing {
                duration: 10.0,
                closing_window: 2.0,
            },
        };
        let outcome = simulator.simulate(&scene, Stopping::Early, None).unwrap();
        let rolls = outcome.lateral().unwrap().rolling_fraction;
        (outcome.ended, rolls > 0.5)
    };
    let (rolling, sliding) = ([1000.0, 0.0], [0.0, 1000.0]);
    assert_eq!(ended(2.0, 1.0, rolling), (Ended::Settled, true));
    assert_eq!(ended(2.0, 0.8, rolling), (Ended::Settled, true));
    assert_eq!(ended(0.5, 1.0, sliding), (Ended::Settled, false));
    assert_eq!(ended(0.5, 0.8, sliding), (Ended::End, false));
}
