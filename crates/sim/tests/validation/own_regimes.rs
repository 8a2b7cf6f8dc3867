//! User-defined laws in regimes, early end and trajectories: as the built-in ones where they equal
//! these, and by closed forms otherwise.

use linear::{Method, Responses, SteadyMotion, steady};
use problems::academic;
use sim::laws::contact::{Approach, Contact, ContactError};
use sim::laws::torque::{BitMotion, TorqueStep};
use sim::{
    BitTorque, Ended, Impulse, Lateral, LoadLine, Outcome, Scene, SceneError, Simulator, Start,
    Stopping, TabulatedFriction, Timing, TorqueLaw, TorsionRegime, Trajectory, Wall, WallLaw,
};

const RPM: f64 = std::f64::consts::TAU / 60.0;
const DURATION: f64 = 60.0;

fn responses(method: Method) -> Responses {
    let request = academic::bit_request(DURATION);
    linear::responses(&academic::string(), &method, &request).unwrap()
}

fn scene<B>(surface_speed: f64, start: Start, bit: B) -> Scene<B> {
    Scene {
        surface_speed,
        start,
        bit: Some(bit),
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration: DURATION,
            closing_window: 10.0,
        },
    }
}

/// A built-in law behind the trait, as one's own would be: with all that it says of itself, or
/// with no more than its answers.
#[derive(Clone)]
struct Wrapped {
    law: BitTorque,
    says_all: bool,
}

impl TorqueLaw for Wrapped {
    type State = <BitTorque as TorqueLaw>::State;

    fn meet(&self, before: &Self::State, line: LoadLine) -> TorqueStep<Self::State> {
        self.law.meet(before, line)
    }

    fn turning_at(&self, speed: f64) -> Self::State {
        self.law.turning_at(speed)
    }

    fn holds(&self) -> Option<f64> {
        self.law.holds().filter(|_| self.says_all)
    }

    fn is_constant_in_slip(&self) -> bool {
        self.says_all && self.law.is_constant_in_slip()
    }

    fn is_autonomous(&self) -> bool {
        self.says_all
    }
}

fn outcome<B: TorqueLaw>(simulator: &Simulator, scene: &Scene<B>, stopping: Stopping) -> Outcome {
    simulator.simulate_laws(scene, stopping, None).unwrap()
}

fn trajectory<B: TorqueLaw>(simulator: &Simulator, scene: &Scene<B>) -> Trajectory {
    let mut record = Trajectory::default();
    let simulated = simulator.simulate_laws(scene, Stopping::Full, Some(&mut record));
    simulated.map(|_| record).unwrap()
}

/// Starts at rest, with the bit held, and in steady rotation.
fn starts(surface_speed: f64, law: &BitTorque) -> [Start; 3] {
    let (string, sites) = (academic::string(), linear::Sites::bit());
    let held = (1.0 + 1e-9) * law.torque_static;
    let motions: [SteadyMotion; 2] = [
        steady::winding(&string, &sites, surface_speed, held),
        steady::rotation(&string, &sites, surface_speed, 0.99 * law.torque_dynamic),
    ];
    let [wound, turning] = motions.map(Start::Steady);
    [Start::Rest, wound, turning]
}

#[test]
fn val_a_law_that_is_the_built_in_one_gives_its_outcome_and_motion_to_the_last_bit() {
    let (mut seen, mut ended) = (Vec::new(), Vec::new());
    for method in [Method::Held, Method::Quadrature] {
        let simulator = Simulator::new(&responses(method)).unwrap();
        for (speed, decay_speed) in [(0.1, 0.0), (0.4, 0.0), (0.1, 0.05 * RPM)] {
            let surface_speed = speed * RPM;
            let law = BitTorque {
                torque_static: 4800.0,
                torque_dynamic: 4000.0,
                decay_speed,
            };
            for start in starts(surface_speed, &law) {
                let built_in = scene(surface_speed, start.clone(), law);
                let own = scene(
                    surface_speed,
                    start,
                    Wrapped {
                        law,
                        says_all: true,
                    },
                );
                for stopping in [Stopping::Early, Stopping::Checked, Stopping::Full] {
                    let expected = simulator.simulate(&built_in, stopping, None).unwrap();
                    assert_eq!(outcome(&simulator, &own, stopping), expected);
                    seen.push(expected.torsion().unwrap().regime);
                    ended.push(expected.ended);
                }
                assert_eq!(
                    trajectory(&simulator, &own),
                    trajectory(&simulator, &built_in)
                );
            }
        }
    }
    for regime in [TorsionRegime::Smooth, TorsionRegime::StickSlip] {
        assert!(seen.contains(&regime), "{seen:?}");
    }
    for end in [Ended::Certain, Ended::Settled, Ended::End] {
        assert!(ended.contains(&end), "{ended:?}");
    }
}

#[test]
fn val_a_law_that_says_nothing_of_itself_is_stepped_to_its_end_and_has_the_same_label() {
    let simulator = Simulator::new(&responses(Method::Held)).unwrap();
    for speed in [0.1, 0.4] {
        let law = BitTorque {
            torque_static: 4800.0,
            torque_dynamic: 4000.0,
            decay_speed: 0.0,
        };
        let expected = scene(speed * RPM, Start::Rest, law);
        let expected = simulator
            .simulate(&expected, Stopping::Early, None)
            .unwrap();
        let own = scene(
            speed * RPM,
            Start::Rest,
            Wrapped {
                law,
                says_all: false,
            },
        );
        let found = outcome(&simulator, &own, Stopping::Early);
        assert_eq!(found.ended, Ended::End);
        assert!(found.simulated > expected.simulated);
        let (found, expected) = (found.torsion().unwrap(), expected.torsion().unwrap());
        assert_eq!(
            (found.regime, found.sticks),
            (expected.regime, expected.sticks)
        );
        assert_eq!(found.first_slip, expected.first_slip);
        assert!((found.closing_speed / expected.closing_speed - 1.0).abs() < 0.02);
        // One that says only that its torque is constant is certain not to stop again.
        let table = TabulatedFriction {
            torque_static: 4800.0,
            rows: vec![(0.0, 4000.0)],
        };
        let table = scene(speed * RPM, Start::Rest, table);
        let found = outcome(&simulator, &table, Stopping::Early);
        assert_eq!(found.torsion(), Some(expected));
    }
}

/// The string transmits the bit's torque and no more of the drive's speed is lost than to
/// damping: the bit turns at Ω − T/k_d, with T its torque at that speed. Between the two motions
/// neither sticks.
#[test]
fn val_smooth_rotation_is_at_the_laws_own_torque() {
    let law = TabulatedFriction::sampled(|speed| 2500.0 + 9000.0 * speed, 0.2, 200);
    let simulator = Simulator::new(&responses(Method::Held)).unwrap();
    let surface_speed = 0.06;
    let own = scene(surface_speed, Start::Rest, law.clone());
    let motion = trajectory(&simulator, &own);
    let ends = motion.bit_torque.len() - 6400..;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (torque, speed) = (
        -mean(&motion.bit_torque[ends.clone()]),
        mean(&motion.speeds[0][ends]),
    );
    let expected = steady::rotation_speed(&academic::string(), surface_speed, torque);
    assert!((speed / expected - 1.0).abs() < 1e-3, "{speed} {expected}");
    assert!((torque / law.torque_at(speed) - 1.0).abs() < 1e-3);
    let found = outcome(&simulator, &own, Stopping::Early)
        .torsion()
        .unwrap();
    assert_eq!(found.regime, TorsionRegime::Smooth);
}

/// A front at the bit meets the impedance ζ of the string there: where the torque falls with the
/// speed by more than that, speeds between do not last and the bit jumps; where by less, none is
/// left out, and where it rises nothing grows. ζ = 1/A(0) by `held`.
#[test]
fn val_a_torque_that_falls_more_steeply_than_the_impedance_jumps() {
    let responses = responses(Method::Held);
    let impedance = 1.0 / responses.at_bit().unwrap()[0];
    let simulator = Simulator::new(&responses).unwrap();
    let (low, high) = (0.004, 0.008);
    let between = |slope: f64| {
        let most = 4000.0;
        let least = most - slope * (high - low);
        let rows = vec![(0.0, most), (low, most), (high, least)];
        let law = TabulatedFriction {
            torque_static: most,
            rows,
        };
        let own = scene(0.1 * RPM, Start::Rest, law);
        let motion = trajectory(&simulator, &own);
        let inside = |speed: &&f64| (1.05 * low..0.95 * high).contains(*speed);
        motion.speeds[0].iter().filter(inside).count()
    };
    assert_eq!(between(1.05 * impedance), 0);
    assert!(between(0.5 * impedance) > 0);
}

/// A bit that the rock does not quite hold, as where friction is smoothed about zero: it creeps.
struct Creeping {
    law: BitTorque,
    counts_as_stuck_below: f64,
}

/// rad/s.
const CREEP: f64 = 1e-7;

impl TorqueLaw for Creeping {
    type State = BitMotion;

    fn meet(&self, before: &BitMotion, line: LoadLine) -> TorqueStep<BitMotion> {
        let step = self.law.meet(before, line);
        if step.state != BitMotion::Stuck {
            return step;
        }
        let torque = (CREEP - line.free_speed) / line.compliance;
        TorqueStep {
            torque,
            speed: CREEP,
            ..step
        }
    }

    fn motion(&self, step: &TorqueStep<BitMotion>) -> BitMotion {
        let is_slow = step.speed.abs() < self.counts_as_stuck_below;
        BitMotion::of(if is_slow { 0.0 } else { step.speed })
    }
}

#[test]
fn val_a_law_that_never_stands_still_says_when_it_counts_as_stuck() {
    let simulator = Simulator::new(&responses(Method::Quadrature)).unwrap();
    let law = BitTorque {
        torque_static: 4800.0,
        torque_dynamic: 4000.0,
        decay_speed: 0.0,
    };
    let measures = |counts_as_stuck_below: f64| {
        let law = Creeping {
            law,
            counts_as_stuck_below,
        };
        let own = scene(0.1 * RPM, Start::Rest, law);
        outcome(&simulator, &own, Stopping::Early)
            .torsion()
            .unwrap()
    };
    let built_in = scene(0.1 * RPM, Start::Rest, law);
    let built_in = simulator.simulate(&built_in, Stopping::Full, None).unwrap();
    let (found, expected) = (measures(2.0 * CREEP), built_in.torsion().unwrap());
    assert_eq!(found.regime, TorsionRegime::StickSlip);
    assert_eq!(found.sticks, expected.sticks);
    assert!((found.period.unwrap() / expected.period.unwrap() - 1.0).abs() < 1e-3);
    assert_eq!(measures(0.0).regime, TorsionRegime::Smooth);
}

/// A built-in wall behind the trait.
#[derive(Clone)]
struct WrappedWall(Wall);

impl WallLaw for WrappedWall {
    fn clearance(&self) -> f64 {
        self.0.clearance
    }

    fn radius(&self) -> f64 {
        self.0.radius
    }

    fn meet(&self, approach: &Approach) -> Result<Contact, ContactError> {
        self.0.meet(approach)
    }

    fn rolling_limit(&self) -> Option<f64> {
        self.0.rolling_limit()
    }

    fn slides_evenly(&self) -> bool {
        self.0.slides_evenly()
    }

    fn check(&self) -> Result<(), SceneError> {
        self.0.check()
    }
}

#[test]
fn val_a_wall_that_is_the_built_in_one_gives_its_outcome_and_motion_to_the_last_bit() {
    let string = academic::string();
    let request = academic::lateral_request(&string, &[0.0], 10.0);
    let responses = linear::responses(&string, &Method::Quadrature, &request).unwrap();
    let simulator = Simulator::new(&responses).unwrap();
    let mut ended = Vec::new();
    for (friction, amount) in [(0.5, 400.0), (2.0, 1000.0)] {
        let wall = Wall {
            clearance: 0.015,
            stiffness: 1e9,
            friction,
            dynamic_ratio: 1.0,
            stribeck_speed: 0.0,
            radius: 0.15,
        };
        let impulse = Impulse {
            site: 0,
            amount,
            start: 0.1,
            duration: 0.02,
            direction: 0.0,
        };
        let built_in: Scene = Scene {
            bit: None,
            axial: None,
            lateral: Some(Lateral {
                walls: vec![wall],
                impulses: vec![impulse],
                eccentric_masses: vec![],
                lying: None,
                shocks: None,
            }),
            timing: Timing {
                duration: 10.0,
                closing_window: 2.0,
            },
            ..scene(
                std::f64::consts::TAU,
                Start::Rest,
                BitTorque {
                    torque_static: 0.0,
                    torque_dynamic: 0.0,
                    decay_speed: 0.0,
                },
            )
        };
        let own: Scene<BitTorque, WrappedWall> = Scene {
            surface_speed: built_in.surface_speed,
            start: Start::Rest,
            bit: None,
            friction: Vec::new(),
            axial: None,
            lateral: Some(Lateral {
                walls: vec![WrappedWall(wall)],
                impulses: vec![impulse],
                eccentric_masses: vec![],
                lying: None,
                shocks: None,
            }),
            timing: built_in.timing,
        };
        let expected = simulator
            .simulate(&built_in, Stopping::Early, None)
            .unwrap();
        let found = simulator
            .simulate_laws(&own, Stopping::Early, None)
            .unwrap();
        assert_eq!(found, expected);
        ended.push(expected.ended);
        let mut motions = [Trajectory::default(), Trajectory::default()];
        let [one, other] = &mut motions;
        simulator
            .simulate(&built_in, Stopping::Full, Some(one))
            .unwrap();
        simulator
            .simulate_laws(&own, Stopping::Full, Some(other))
            .unwrap();
        assert_eq!(motions[0], motions[1]);
    }
    assert!(ended.iter().any(|end| *end != Ended::End), "{ended:?}");
}
