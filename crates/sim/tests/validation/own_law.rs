//! A torque law and a wall of one's own step as the built-in ones do, through the same
//! stepper.

use linear::{ChannelRequest, Method, Request, Responses, Sites};
use problems::academic;
use problems::pipes::row;
use sim::laws::bit::BitMotion;
use sim::laws::contact::{Approach, Contact, ContactError, Touch};
use sim::laws::torque::TorqueStep;
use sim::{
    BitTorque, Impulse, Lateral, LoadLine, Scene, SimulationError, Simulator, Stepper, Stopping,
    System, Timing, TorqueLaw, Trajectory, Wall, WallLaw,
};

const DURATION: f64 = 20.0;

fn responses(torques: Vec<usize>) -> Responses {
    let request = Request {
        sites: Sites::bit(),
        channels: vec![ChannelRequest::Torsion { torques }],
        sampling_frequency: 640.0,
        longest_time: DURATION,
    };
    linear::responses(&row(50, 1.0), &Method::Quadrature, &request).unwrap()
}

fn scene<B>(surface_speed: f64, bit: B) -> Scene<B, Wall> {
    Scene {
        start: sim::Start::Rest,
        surface_speed,
        bit: Some(bit),
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration: DURATION,
            closing_window: 5.0,
        },
    }
}

/// The speeds of the bit in every step.
fn speeds<B: TorqueLaw>(
    responses: &Responses,
    scene: &Scene<B, Wall>,
) -> Result<Vec<f64>, SimulationError> {
    let system = System::new(responses)?;
    let mut stepper = Stepper::new(&system, scene)?;
    let mut speeds = Vec::with_capacity(stepper.steps());
    while let Some(step) = stepper.step()? {
        speeds.push(step.bit.as_ref().unwrap().speed);
    }
    Ok(speeds)
}

/// The built-in law in other words: the torque that holds, up to T_s, then T_d.
struct Own(BitTorque);

impl TorqueLaw for Own {
    /// The direction in which it turned, or 0.
    type State = i8;

    fn meet(&self, before: &i8, line: LoadLine) -> TorqueStep<i8> {
        let turning = |direction: i8| {
            let torque = -f64::from(direction) * self.0.torque_dynamic;
            let speed = line.free_speed + line.compliance * torque;
            (speed * f64::from(direction) > 0.0).then_some(TorqueStep {
                torque,
                speed,
                state: direction,
            })
        };
        let holding = -line.free_speed / line.compliance;
        let continues = (*before != 0).then(|| turning(*before)).flatten();
        let slips = || {
            let exceeds = holding.abs() > self.0.torque_static;
            exceeds
                .then(|| turning(line.free_speed.signum() as i8))
                .flatten()
        };
        continues.or_else(slips).unwrap_or(TorqueStep {
            torque: holding,
            speed: 0.0,
            state: 0,
        })
    }
}

#[test]
fn val_the_built_in_law_as_ones_own_gives_the_built_in_motion() {
    let responses = responses(vec![0]);
    let law = BitTorque {
        torque_static: 1200.0,
        torque_dynamic: 1000.0,
        decay_speed: 0.0,
    };
    let simulator = Simulator::new(&responses).unwrap();
    for surface_speed in [0.01, 0.5] {
        let own = speeds(&responses, &scene(surface_speed, Own(law))).unwrap();
        let stepped = speeds(&responses, &scene(surface_speed, law)).unwrap();
        assert_eq!(own, stepped);
        // The simulator leaves out what the bit does until it first slips.
        let mut record = Trajectory::default();
        let scene = scene(surface_speed, law);
        simulator
            .simulate(&scene, Stopping::Full, Some(&mut record))
            .unwrap();
        let expected = &record.speeds[0];
        assert_eq!(stepped.len(), expected.len());
        let sizes = expected.iter().map(|speed| speed.abs());
        let largest = sizes.fold(0.0, f64::max);
        assert!(largest > surface_speed);
        for (found, expected) in stepped.iter().zip(expected) {
            let difference = (found - expected).abs();
            assert!(difference < 1e-9 * largest, "{found} {expected}");
        }
    }
    assert_eq!(BitMotion::default(), BitMotion::Stuck);
}

#[test]
fn what_cannot_be_stepped_is_an_error() {
    let still = |_: LoadLine| 0.0;
    let found = speeds(&responses(vec![]), &scene(1.0, still));
    assert_eq!(found, Err(SimulationError::NoTorqueInput));
    let broken = |line: LoadLine| if line.time > 0.5 { f64::NAN } else { 0.0 };
    let found = speeds(&responses(vec![0]), &scene(1.0, broken));
    assert!(
        matches!(found, Err(SimulationError::NotFinite { site: 0, time }) if (time - 0.5).abs() < 0.01)
    );
}

/// Rigid and smooth: the centre stays on the circle, pushed straight back.
struct Smooth {
    clearance: f64,
}

impl WallLaw for Smooth {
    fn clearance(&self) -> f64 {
        self.clearance
    }

    fn radius(&self) -> f64 {
        0.1
    }

    fn meet(&self, approach: &Approach) -> Result<Contact, ContactError> {
        let [x, y] = approach.free_position;
        let distance = x.hypot(y);
        if distance <= self.clearance {
            return Contact::free(approach.free_position);
        }
        let force = (distance - self.clearance) / approach.compliance;
        let along = |size: f64| [x / distance * size, y / distance * size];
        Ok(Contact {
            touch: Touch::Sliding,
            position: along(self.clearance),
            force: along(-force),
            normal_force: force,
            ..Contact::NONE
        })
    }
}

/// Every position of the bit, and how many steps touch.
fn positions<W: WallLaw>(system: &System, wall: W) -> (Vec<[f64; 2]>, usize) {
    let impulse = |start, direction| Impulse {
        site: 0,
        amount: 1000.0,
        start,
        duration: 0.02,
        direction,
    };
    let scene: Scene<BitTorque, W> = Scene {
        start: sim::Start::Rest,
        surface_speed: 6.0,
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: Some(Lateral {
            walls: vec![wall],
            impulses: vec![impulse(0.1, 0.0), impulse(0.5, 2.0)],
            eccentric_masses: vec![],
            lying: None,
            shocks: None,
        }),
        timing: Timing {
            duration: 1.0,
            closing_window: 0.5,
        },
    };
    let mut stepper = Stepper::new(system, &scene).unwrap();
    let (mut positions, mut touches) = (Vec::new(), 0);
    while let Some(step) = stepper.step().unwrap() {
        touches += usize::from(step.contacts[0].touches());
        positions.push(step.contacts[0].position);
    }
    (positions, touches)
}

#[test]
fn val_a_smooth_wall_of_ones_own_gives_the_motion_of_the_built_in_one() {
    let string = row(50, 1.0);
    let request = academic::lateral_request(&string, &[0.0], 1.0);
    let responses = linear::responses(&string, &Method::Quadrature, &request).unwrap();
    let system = System::new(&responses).unwrap();
    let clearance = 0.015;
    let (own, touches) = positions(&system, Smooth { clearance });
    let built_in = Wall {
        clearance,
        stiffness: f64::INFINITY,
        friction: 0.0,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.1,
    };
    let (expected, expected_touches) = positions(&system, built_in);
    assert!(touches > 10);
    assert_eq!(touches, expected_touches);
    for (found, expected) in own.iter().zip(&expected) {
        let apart = (found[0] - expected[0]).hypot(found[1] - expected[1]);
        assert!(apart < 1e-9 * clearance, "{found:?} {expected:?}");
    }
}
