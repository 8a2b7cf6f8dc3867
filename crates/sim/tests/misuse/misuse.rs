//! Systems and scenes that do not fit, and scenes out of range: each is refused by
//! name, none gives an answer without a word.

use linear::passivity::Ending;
use linear::{ChannelRequest, Method, Request, ResponseError, Responses, Sites, responses};
use problems::academic;
use problems::pipes::row;
use proptest::prelude::*;
use sim::excitation::least_impulse;
use sim::oscillator::worst_load_gain;
use sim::{
    BitTorque, EccentricMass, Impulse, Lateral, Outcome, Sampling, Scene, SceneError,
    SimulationError, Simulator, Stopping, System, Timing, Wall,
};

const SAMPLING_FREQUENCY: f64 = 200.0;
const LONGEST: f64 = 2.0;

const BIT: BitTorque = BitTorque {
    torque_static: 1200.0,
    torque_dynamic: 1000.0,
    decay_speed: 0.0,
};

const WALL: Wall = Wall {
    clearance: 0.015,
    stiffness: 1e9,
    friction: 0.5,
    dynamic_ratio: 1.0,
    stribeck_speed: 0.0,
    radius: 0.1,
};

/// Responses in torsion to some torques, and in bending where asked for.
fn built(distances: &[f64], torques: Vec<usize>, bends: bool, longest_time: f64) -> Responses {
    let string = row(5, 10.0);
    let mut channels = vec![ChannelRequest::Torsion { torques }];
    channels.extend(bends.then(academic::free_in_bending));
    let request = Request {
        sites: Sites::new(&string, distances).unwrap(),
        channels,
        sampling_frequency: SAMPLING_FREQUENCY,
        longest_time,
    };
    responses(&string, &Method::Quadrature, &request).unwrap()
}

fn torsion(distances: &[f64], torques: Vec<usize>) -> Responses {
    built(distances, torques, false, LONGEST)
}

fn lateral_simulator(distances: &[f64]) -> Simulator {
    let torques = (0..distances.len()).collect();
    Simulator::new(&built(distances, torques, true, LONGEST)).unwrap()
}

/// A bit alone.
fn cutting() -> Scene {
    Scene {
        start: sim::Start::Rest,
        surface_speed: 0.5,
        bit: Some(BIT),
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration: LONGEST,
            closing_window: 0.5,
        },
    }
}

/// A bit that is pushed, and unbalanced.
fn touching() -> Scene {
    let impulse = Impulse {
        site: 0,
        amount: 100.0,
        start: 0.1,
        duration: 0.05,
        direction: 0.0,
    };
    let mass = EccentricMass {
        site: 0,
        mass: 10.0,
        offset: 0.01,
    };
    Scene {
        axial: None,
        lateral: Some(Lateral {
            walls: vec![WALL],
            impulses: vec![impulse],
            eccentric_masses: vec![mass],
            lying: None,
            shocks: None,
        }),
        ..cutting()
    }
}

fn run(simulator: &Simulator, scene: &Scene) -> Result<Outcome, SimulationError> {
    simulator.simulate(scene, Stopping::Full, None)
}

/// Whichever other sites torques may act on, and in whichever order they are named.
#[test]
fn the_bit_is_the_site_at_the_bit() {
    let at_bit = |torques: Vec<usize>| {
        let simulator = Simulator::new(&torsion(&[0.0, 20.0], torques));
        run(&simulator.unwrap(), &cutting())
    };
    let [alone, after, before] = [vec![1], vec![0, 1], vec![1, 0]].map(|torques| {
        let torsion = at_bit(torques).unwrap().torsion().unwrap();
        (torsion.regime, torsion.sticks, torsion.peak_speed)
    });
    // A bit alone is stepped from its first slip on.
    assert_eq!(after, before);
    assert_eq!((alone.0, alone.1), (after.0, after.1));
    assert!((alone.2 / after.2 - 1.0).abs() < 1e-9);
    assert_eq!(at_bit(vec![0]), Err(SimulationError::NoTorqueInput));
    assert_eq!(at_bit(vec![]), Err(SimulationError::NoTorqueInput));
}

#[test]
fn a_bit_cuts_at_no_site_above_it() {
    let simulator = lateral_simulator(&[20.0]);
    assert_eq!(
        run(&simulator, &touching()),
        Err(SimulationError::NoTorqueInput)
    );
    let free = Scene {
        bit: None,
        ..touching()
    };
    assert!(run(&simulator, &free).is_ok());
}

/// Walls need bending and one wall a site; further responses do not matter.
#[test]
fn a_scene_that_does_not_fit_its_responses_is_refused() {
    let alone = Simulator::new(&torsion(&[0.0], vec![0])).unwrap();
    let found = run(&alone, &touching());
    assert_eq!(found, Err(SimulationError::NoForceInput));
    let two = lateral_simulator(&[0.0, 20.0]);
    let expected = SimulationError::NotAWallForEachSite { walls: 1, sites: 2 };
    assert_eq!(run(&two, &touching()), Err(expected));
    let [cutting_alone, cutting_there] = [&alone, &two].map(|simulator| {
        let torsion = run(simulator, &cutting()).unwrap().torsion().unwrap();
        (torsion.regime, torsion.sticks)
    });
    assert_eq!(cutting_alone, cutting_there);
}

#[test]
fn a_case_longer_than_its_system_is_refused() {
    let scene = |duration: f64| Scene {
        timing: Timing {
            duration,
            closing_window: 0.5,
        },
        ..touching()
    };
    let simulator = lateral_simulator(&[0.0]);
    assert!(run(&simulator, &scene(LONGEST)).is_ok());
    for duration in [LONGEST + 0.01, 1e300] {
        let found = run(&simulator, &scene(duration));
        let expected = SimulationError::LongerThanPrepared {
            duration,
            prepared: LONGEST,
        };
        assert_eq!(found, Err(expected));
        let alone = Simulator::new(&torsion(&[0.0], vec![0])).unwrap();
        for bit in [Some(BIT), None] {
            let scene = Scene {
                bit,
                axial: None,
                lateral: None,
                ..scene(duration)
            };
            assert_eq!(run(&alone, &scene), Err(expected));
        }
    }
    // Taps that are cut off are good for no longer than they are.
    let mut cut = torsion(&[0.0], vec![0]);
    cut.channels[0].ending = Ending::Cut;
    let taps = cut.channels[0].taps();
    cut.longest_time = 2.0 * taps as f64 / SAMPLING_FREQUENCY;
    let expected = ResponseError::TooShort {
        taps,
        longest_time: cut.longest_time,
    };
    assert_eq!(System::new(&cut).map(|_| ()), Err(expected.into()));
}

type Change = fn(&mut Scene);

fn lateral(scene: &mut Scene) -> &mut Lateral {
    scene.lateral.as_mut().unwrap()
}

fn bit(scene: &mut Scene) -> &mut BitTorque {
    scene.bit.as_mut().unwrap()
}

#[test]
fn scenes_out_of_range_are_refused() {
    let changes: [Change; 19] = [
        |it| it.surface_speed = f64::NAN,
        |it| it.surface_speed = f64::INFINITY,
        |it| it.timing.duration = f64::NAN,
        |it| it.timing.duration = f64::INFINITY,
        |it| it.timing.duration = -1.0,
        |it| it.timing.closing_window = f64::NAN,
        |it| it.timing.closing_window = f64::INFINITY,
        |it| bit(it).torque_static = f64::NAN,
        |it| bit(it).torque_dynamic = -1.0,
        |it| lateral(it).walls[0].clearance = 0.0,
        |it| lateral(it).walls[0].stiffness = f64::NAN,
        |it| lateral(it).walls[0].friction = -0.1,
        |it| lateral(it).walls[0].radius = f64::NAN,
        |it| lateral(it).impulses[0].amount = f64::NAN,
        |it| lateral(it).impulses[0].start = f64::INFINITY,
        |it| lateral(it).impulses[0].direction = f64::INFINITY,
        |it| lateral(it).impulses[0].duration = 0.0,
        |it| lateral(it).eccentric_masses[0].mass = -1.0,
        |it| lateral(it).eccentric_masses[0].offset = f64::NAN,
    ];
    let system = lateral_simulator(&[0.0]);
    assert!(run(&system, &touching()).is_ok());
    for (number, change) in changes.into_iter().enumerate() {
        let mut scene = touching();
        change(&mut scene);
        let found = run(&system, &scene);
        let is_refused = matches!(
            found,
            Err(SimulationError::Scene(SceneError::OutOfRange { .. }))
        );
        assert!(is_refused, "{number}: {found:?}");
    }
    let sites: [(Change, &str); 2] = [
        (|it| lateral(it).impulses[0].site = 1, "an impulse"),
        (
            |it| lateral(it).eccentric_masses[0].site = 7,
            "an eccentric mass",
        ),
    ];
    for (change, expected) in sites {
        let mut scene = touching();
        change(&mut scene);
        match run(&system, &scene) {
            Err(SimulationError::Scene(SceneError::NoSuchSite { what, sites: 1, .. })) => {
                assert_eq!(what, expected);
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn a_bit_that_holds_less_than_turns_it_is_refused() {
    let expected = SimulationError::Scene(SceneError::Torques {
        torque_static: 900.0,
        torque_dynamic: 1000.0,
    });
    let alone = Simulator::new(&torsion(&[0.0], vec![0])).unwrap();
    let touches = lateral_simulator(&[0.0]);
    for (simulator, mut scene) in [(alone, cutting()), (touches, touching())] {
        bit(&mut scene).torque_static = 900.0;
        assert_eq!(run(&simulator, &scene), Err(expected));
    }
}

#[test]
fn responses_that_no_string_gives_are_refused() {
    let good = built(&[0.0], vec![0], true, LONGEST);
    type Change = fn(&mut Responses);
    let changes: [(Change, ResponseError); 6] = [
        (
            |it| it.sampling_frequency = f64::NAN,
            ResponseError::SamplingFrequency { value: f64::NAN },
        ),
        (
            |it| it.channels[0].from_surface[0].clear(),
            ResponseError::Shape,
        ),
        (|it| it.channels[1].from_loads.clear(), ResponseError::Shape),
        (
            |it| it.channels[0].loads[0] = 4,
            ResponseError::NoSuchSite { site: 4, sites: 1 },
        ),
        (
            |it| it.channels[1].from_loads[0][0][0] = -1.0,
            ResponseError::Instant {
                site: 0,
                value: -1.0,
            },
        ),
        (
            |it| drop(it.channels.remove(0)),
            ResponseError::NoChannel {
                channel: linear::Channel::Torsion,
            },
        ),
    ];
    for (change, expected) in changes {
        let mut bad = good.clone();
        change(&mut bad);
        let found = System::new(&bad).map(|_| ());
        assert_eq!(
            found.map_err(|it| it.to_string()),
            Err(expected.to_string())
        );
    }
    let mut torsion = torsion(&[0.0], vec![0]);
    for longest_time in [f64::NAN, f64::INFINITY, -1.0] {
        torsion.longest_time = longest_time;
        let found = System::new(&torsion);
        assert!(
            matches!(found, Err(SimulationError::Scene(_))),
            "{longest_time}"
        );
    }
    // Friction would turn a site that no torque can act on.
    let unlike = System::new(&built(&[0.0, 20.0], vec![1], true, LONGEST));
    assert_eq!(unlike.map(|_| ()), Err(SimulationError::UnlikeChannels));
    assert!(worst_load_gain(&[]).is_err());
    assert!(worst_load_gain(&[vec![&[1.0]], vec![&[1.0]]]).is_err());
    assert!(worst_load_gain(&[vec![&[]]]).is_err());
    assert!(worst_load_gain(&[vec![&[1.0, f64::NAN]]]).is_err());
}

/// An impulse that outlasts every response takes no more memory than one that is as
/// long as they are.
#[test]
fn an_impulse_without_end_has_a_least_amount() {
    let taps = [1.0, 0.5, 0.25];
    let of = |duration: f64| {
        least_impulse(
            &taps,
            Sampling::new(SAMPLING_FREQUENCY, 0.0),
            duration,
            0.015,
        )
    };
    assert!(of(0.01).is_finite());
    for duration in [1e7, 1e308] {
        assert!(of(duration) > of(1.0));
    }
    assert!(of(f64::NAN).is_nan() || of(f64::NAN) == f64::INFINITY);
}

fn decades(from: f64, to: f64) -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), (from..to).prop_map(|e| 10f64.powf(e))]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..Default::default() })]

    /// Masses and pushes that throw the string about until numbers end: an outcome in
    /// numbers, or an error that says when.
    #[test]
    fn an_extreme_scene_has_a_finite_outcome_or_an_error(
        speed in decades(-3.0, 300.0),
        torque in decades(-3.0, 300.0),
        mass in decades(-3.0, 300.0),
        amount in decades(-3.0, 300.0),
        friction in decades(-3.0, 300.0),
        stiffness in prop_oneof![Just(f64::INFINITY), (-300.0..300.0f64).prop_map(|e| 10f64.powf(e))],
        cuts in any::<bool>(),
    ) {
        static SIMULATOR: std::sync::LazyLock<Simulator> =
            std::sync::LazyLock::new(|| lateral_simulator(&[0.0, 20.0]));
        let mut scene = touching();
        scene.surface_speed = speed;
        scene.bit = cuts.then_some(BitTorque {
            torque_static: 1.2 * torque,
            torque_dynamic: torque,
            decay_speed: 0.0,
        });
        let lateral = lateral(&mut scene);
        lateral.walls = vec![Wall { friction, stiffness, ..WALL }; 2];
        lateral.impulses[0].amount = amount;
        lateral.eccentric_masses[0].mass = mass;
        for stopping in [Stopping::Full, Stopping::Early] {
            match SIMULATOR.simulate(&scene, stopping, None) {
                Ok(outcome) => {
                    let lateral = outcome.lateral().unwrap();
                    let torsion = outcome.torsion().map_or(0.0, |torsion| torsion.peak_speed);
                    let numbers = [
                        lateral.peak_radius,
                        lateral.mean_radius,
                        lateral.mean_normal_force,
                        lateral.precession_rate,
                        torsion,
                    ];
                    prop_assert!(numbers.iter().all(|number| number.is_finite()));
                }
                Err(
                    error @ (SimulationError::Scene(_)
                    | SimulationError::LongerThanPrepared { .. }),
                ) => prop_assert!(false, "{}", error),
                Err(_) => {}
            }
        }
    }
}
