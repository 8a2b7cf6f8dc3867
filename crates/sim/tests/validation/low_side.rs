//! Strings that lie on the low side of their hole, against two programs that share no
//! time-stepping code with this one or with one another: explicit second differences of lumped
//! masses, and cubic elements by Newmark's method.

use std::f64::consts::{PI, TAU};

use linear::elements::reconstruction::WholeString;
use linear::method::FiniteElement;
use linear::steady::rotation;
use linear::{
    Bending, Budget, ChannelRequest, Drillstring, Hole, HoleSection, Material, Method, Mud,
    PlacePlan, PlaceQuantity, Request, Section, Sites, SurfaceSupport, Tube, responses,
};
use sim::{
    AtPlaces, EccentricMass, Impulse, Lateral, LateralMeasures, LateralRegime, Lying,
    LyingMeasures, Scene, Simulator, Start, Stopping, Timing, Trajectory, Wall,
};

const LENGTH: f64 = 60.0;
const CLEARANCE: f64 = 0.053_975;
const STIFFNESS: f64 = 1e9;

/// Forces of nine walls at rest on the string of 8-inch collars at 60°, N, from an end to the
/// middle.
const AT_REST: [f64; 5] = [11_261.174, 10_004.243, 10_876.063, 10_658.886, 10_722.275];

fn string() -> Drillstring {
    let steel = Material {
        shear_modulus: 79.3e9,
        density: 7850.0,
    };
    let collar = Tube {
        length: LENGTH,
        inner_radius: 0.0357,
        outer_radius: 0.1016,
    };
    let section = Section {
        repeat: 1,
        parts: vec![collar],
    };
    let around = HoleSection {
        length: LENGTH,
        radius: 0.155_575,
    };
    let hole = Hole {
        mud: Mud {
            density: 1200.0,
            viscosity: 0.0,
        },
        sections: vec![around],
    };
    let string = Drillstring::new(steel, vec![section], 0.03).unwrap();
    string.in_hole(hole).unwrap()
}

/// A simulator of it with nine walls, for a time (s).
fn simulator(method: &Method, sampling_frequency: f64, longest_time: f64) -> Simulator {
    held_by(&[], method, sampling_frequency, longest_time)
}

/// The same whose linear string is held by springs (N/m), which are taken back.
fn held_by(
    springs: &[f64],
    method: &Method,
    sampling_frequency: f64,
    longest_time: f64,
) -> Simulator {
    let request = request(springs, sampling_frequency, longest_time);
    Simulator::new(&responses(&string(), method, &request).unwrap()).unwrap()
}

const BENDING: Bending = Bending {
    youngs_modulus: 206e9,
    damping: 200.0,
    compression: 0.0,
};

/// What its responses are wanted for.
fn request(springs: &[f64], sampling_frequency: f64, longest_time: f64) -> Request {
    let sites: Vec<f64> = (0..9)
        .map(|site| (f64::from(site) + 0.5) * LENGTH / 9.0)
        .collect();
    let mut places = Sites::new(&string(), &sites).unwrap();
    if !springs.is_empty() {
        places = places.held_by(springs.to_vec()).unwrap();
    }
    Request {
        sites: places,
        channels: vec![
            ChannelRequest::Torsion {
                torques: (0..9).collect(),
            },
            ChannelRequest::Bending {
                bending: BENDING,
                support: SurfaceSupport::Free,
            },
        ],
        sampling_frequency,
        longest_time,
    }
}

/// Where the walls hold it at rest.
fn lying() -> Lying {
    let forces = (0..9).map(|site: usize| AT_REST[site.min(8 - site)]);
    let position = |force: f64| [-(CLEARANCE + (force / STIFFNESS).powf(2.0 / 3.0)), 0.0];
    Lying {
        positions: forces.clone().map(position).collect(),
        forces: forces.map(|force| [force, 0.0]).collect(),
        torques: vec![0.0; 9],
        low_side: vec![PI; 9],
    }
}

/// One that turns from the beginning on, lying as at rest.
fn turning(rpm: f64, friction: f64, duration: f64) -> Scene {
    let speed = rpm * TAU / 60.0;
    let string = string();
    let sites: Vec<f64> = (0..9)
        .map(|site| (f64::from(site) + 0.5) * LENGTH / 9.0)
        .collect();
    let sites = Sites::new(&string, &sites).unwrap();
    let wall = Wall {
        clearance: CLEARANCE,
        stiffness: STIFFNESS,
        friction,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.1016,
    };
    Scene {
        surface_speed: speed,
        start: Start::Steady(rotation(&string, &sites, speed, 0.0)),
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: Some(Lateral {
            walls: vec![wall; 9],
            impulses: vec![],
            eccentric_masses: vec![],
            lying: Some(lying()),
            shocks: None,
        }),
        timing: Timing {
            duration,
            closing_window: 5.0,
        },
    }
}

fn measured(simulator: &Simulator, scene: &Scene) -> LateralMeasures {
    let outcome = simulator.simulate(scene, Stopping::Early, None).unwrap();
    outcome.lateral().unwrap()
}

/// Mean angle of the middle of the string from the low side and half of what it swings through, deg,
/// in the last 5 s of a case.
fn middle(simulator: &Simulator, scene: &Scene, sampling_frequency: f64) -> [f64; 2] {
    let mut motion = Trajectory::default();
    simulator
        .simulate(scene, Stopping::Full, Some(&mut motion))
        .unwrap();
    let steps = (5.0 * sampling_frequency) as usize;
    let places = motion.positions[4].iter().rev().take(steps);
    let angles: Vec<f64> = places.map(|[x, y]| y.atan2(-x).to_degrees()).collect();
    let least = angles.iter().copied().fold(f64::INFINITY, f64::min);
    let most = angles.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    [
        angles.iter().sum::<f64>() / steps as f64,
        0.5 * (most - least),
    ]
}

fn low_side_of(it: &LateralMeasures) -> LyingMeasures {
    it.lying.unwrap()
}

/// Unbalanced by 1 kg m in the middle.
fn unbalanced(rpm: f64) -> Scene {
    let mut scene = turning(rpm, 0.3, 40.0);
    let mass = EccentricMass {
        site: 4,
        mass: 1.0,
        offset: 1.0,
    };
    scene.lateral.as_mut().unwrap().eccentric_masses = vec![mass];
    scene
}

#[test]
fn val_a_string_that_lies_does_not_move_until_it_is_pushed() {
    for method in [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(FiniteElement::default()),
    ] {
        let simulator = simulator(&method, 1000.0, 10.0);
        for stiffness in [STIFFNESS, f64::INFINITY] {
            let mut scene = turning(60.0, 0.0, 10.0);
            let lateral = scene.lateral.as_mut().unwrap();
            lateral
                .walls
                .iter_mut()
                .for_each(|wall| wall.stiffness = stiffness);
            let lying = lateral.lying.as_mut().unwrap();
            if stiffness == f64::INFINITY {
                lying.positions = vec![[-CLEARANCE, 0.0]; 9];
            }
            let at_rest = lying.clone();
            let mut motion = Trajectory::default();
            simulator
                .simulate(&scene, Stopping::Full, Some(&mut motion))
                .unwrap();
            for (site, (place, [force, _])) in
                at_rest.positions.iter().zip(at_rest.forces).enumerate()
            {
                for (there, [by, across]) in
                    motion.positions[site].iter().zip(&motion.wall_forces[site])
                {
                    let moved = (there[0] - place[0]).hypot(there[1] - place[1]);
                    assert!(moved < 1e-13, "{method:?} {stiffness}: {moved}");
                    assert!((by - force).abs() + across.abs() < 1e-6 * force);
                }
            }
        }
    }
}

/// A rod that slides steadily climbs by the angle of friction everywhere, N falling as
/// 1/√(1 + μ²).
#[test]
fn val_steady_sliding_continues_as_it_began() {
    let friction: f64 = 0.3;
    for method in [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(FiniteElement::default()),
    ] {
        let simulator = simulator(&method, 1000.0, 5.0);
        let mut scene = turning(90.0, friction, 5.0);
        let lying = scene.lateral.as_mut().unwrap().lying.as_mut().unwrap();
        let [cos, sin] = [1.0, friction].map(|it| it / (1.0 + friction * friction).sqrt());
        for site in 0..9 {
            let normal = lying.forces[site][0] * cos;
            let radius = CLEARANCE + (normal / STIFFNESS).powf(2.0 / 3.0);
            lying.positions[site] = [-radius * cos, radius * sin];
            let along = friction * normal;
            lying.forces[site] = [normal * cos + along * sin, along * cos - normal * sin];
            lying.torques[site] = -0.1016 * along;
        }
        let began = lying.clone();
        let mut motion = Trajectory::default();
        simulator
            .simulate(&scene, Stopping::Full, Some(&mut motion))
            .unwrap();
        for (site, place) in began.positions.iter().enumerate() {
            for there in &motion.positions[site] {
                let moved = (there[0] - place[0]).hypot(there[1] - place[1]);
                assert!(moved < 1e-9, "{method:?} {site}: {moved}");
            }
            let speed = 90.0 * TAU / 60.0;
            let mut speeds = motion.speeds[site].iter();
            assert!(speeds.all(|it| (it - speed).abs() < 1e-9), "{method:?}");
        }
    }
    let mut scene = turning(90.0, friction, 5.0);
    scene.start = Start::Rest;
    scene
        .lateral
        .as_mut()
        .unwrap()
        .lying
        .as_mut()
        .unwrap()
        .torques[3] = -1.0;
    let simulator = simulator(&Method::Quadrature, 500.0, 5.0);
    let refused = simulator.simulate(&scene, Stopping::Early, None);
    assert!(
        refused
            .unwrap_err()
            .to_string()
            .contains("slides on no wall")
    );
}

/// Greatest angle (deg), then in the last 5 of 20 s mean, amplitude (deg) and frequency (Hz), as
/// explicit masses have them and, by half a thousandth to half a hundredth other, Newmark's elements.
#[test]
fn val_a_string_climbs_its_wall_and_swings_as_other_programs_have_it() {
    for (method, frequency) in [
        (Method::Quadrature, 2000.0),
        (Method::Held, 1500.0),
        (Method::FiniteElement(FiniteElement::default()), 1500.0),
    ] {
        let simulator = simulator(&method, frequency, 20.0);
        for (rpm, friction, [greatest, climb, amplitude, swings]) in [
            (60.0, 0.1, [10.935, 5.7091, 0.0543, 1.525]),
            (120.0, 0.3, [33.745, 16.7031, 0.1683, 1.550]),
            (180.0, 0.6, [81.411, 30.971, 0.3866, 1.625]),
        ] {
            let found = measured(&simulator, &turning(rpm, friction, 20.0));
            assert_eq!(found.regime, LateralRegime::LowSide);
            let lying = low_side_of(&found);
            let greatest_found = lying.greatest_angle.to_degrees();
            let [climbs, swing] = middle(&simulator, &turning(rpm, friction, 20.0), frequency);
            let what = format!("{method:?} {rpm} {friction}: {lying:?}");
            assert!((greatest_found / greatest - 1.0).abs() < 5e-3, "{what}");
            assert!((climbs - climb).abs() < 1e-2, "{what}");
            // Steady sliding climbs by the angle of friction.
            assert!(
                (climbs - friction.atan().to_degrees()).abs() < 1e-2,
                "{what}"
            );
            assert!((swing / amplitude - 1.0).abs() < 2e-2, "{what}");
            assert!((lying.swing_frequency - swings).abs() < 0.025, "{what}");
        }
        // Rolling all the way round: R Ω/(c + δ), the depth that of its forces.
        for (rpm, friction, rate, within) in [(120.0, 0.8, 3.64, 0.02), (180.0, 1.0, 5.3, 0.15)] {
            let found = measured(&simulator, &turning(rpm, friction, 20.0));
            assert_eq!(found.regime, LateralRegime::BackwardWhirl);
            let turns = -found.precession_rate / TAU;
            assert!((turns - rate).abs() < within, "{method:?}: {turns}");
        }
    }
}

/// The swing of the middle in the last 5 of 40 s.
#[test]
fn val_unbalance_makes_a_string_snake_at_its_swinging_frequency() {
    let simulator = simulator(&Method::Quadrature, 2000.0, 40.0);
    for (rpm, amplitude, regime) in [
        (60.0, 0.1534, LateralRegime::LowSide),
        (80.0, 0.5030, LateralRegime::LowSide),
        (88.0, 1.1663, LateralRegime::Snaking),
        (92.0, 1.9944, LateralRegime::Snaking),
        (94.0, 1.7580, LateralRegime::Snaking),
        (120.0, 1.3650, LateralRegime::Snaking),
    ] {
        let found = measured(&simulator, &unbalanced(rpm));
        let lying = low_side_of(&found);
        assert_eq!(found.regime, regime, "{rpm} {lying:?}");
        let [_, swing] = middle(&simulator, &unbalanced(rpm), 2000.0);
        assert!((swing / amplitude - 1.0).abs() < 1e-2, "{rpm}: {swing}");
        assert!((60.0 * lying.swing_frequency - rpm).abs() < 0.05);
    }
}

/// The whole string at a speed (m/s) sideways, where it climbs.
#[test]
fn val_an_impulse_decides_whether_it_goes_round() {
    let simulator = simulator(&Method::Quadrature, 2000.0, 20.0);
    // Steel, and mud in it and around it.
    let mass_per_metre = 324.736_985;
    for (rpm, friction, speed, regime) in [
        (120.0, 0.3, 0.5, LateralRegime::LowSide),
        (120.0, 0.3, 1.0, LateralRegime::BackwardWhirl),
        (120.0, 0.6, 0.5, LateralRegime::BackwardWhirl),
        (180.0, 0.1, 2.0, LateralRegime::BackwardWhirl),
        (60.0, 0.3, 1.0, LateralRegime::LowSide),
    ] {
        let mut scene = turning(rpm, friction, 20.0);
        let impulse = |site| Impulse {
            site,
            amount: mass_per_metre * LENGTH / 9.0 * speed,
            start: 0.0,
            duration: 0.02,
            direction: 0.5 * PI,
        };
        scene.lateral.as_mut().unwrap().impulses = (0..9).map(impulse).collect();
        let found = measured(&simulator, &scene);
        assert_eq!(found.regime, regime, "{rpm} {friction} {speed}");
    }
}

/// The same string with any springs on its linear part: to rounding where a method's steps follow from
/// its stiffness, and by the method's error otherwise.
#[test]
fn val_springs_that_are_taken_back_change_nothing() {
    let springs = [3e4, 0.0, 1e5, 2e4, 5e5, 0.0, 7e3, 1e5, 4e4];
    for (method, within) in [
        (Method::Quadrature, 1e-8),
        (Method::FiniteElement(FiniteElement::default()), 1e-8),
        (Method::Held, 2e-3),
    ] {
        let one = simulator(&method, 2000.0, 4.0);
        let other = held_by(&springs, &method, 2000.0, 4.0);
        // At rest, and pushed so that it flies and lands.
        for amount in [0.0, 500.0] {
            let mut scene = turning(60.0, 0.3, 4.0);
            let impulse = |site| Impulse {
                site,
                amount,
                start: 0.1,
                duration: 0.05,
                direction: 0.3,
            };
            scene.lateral.as_mut().unwrap().impulses = (0..9).map(impulse).collect();
            let [one, other] = [&one, &other].map(|simulator| {
                let mut motion = Trajectory::default();
                simulator
                    .simulate(&scene, Stopping::Full, Some(&mut motion))
                    .unwrap();
                motion.positions
            });
            let early = (0.4 * 2000.0) as usize;
            let apart = one.iter().zip(&other).flat_map(|(one, other)| {
                let steps = one.iter().zip(other).take(early);
                steps.map(|([x, y], [u, v])| (x - u).hypot(y - v))
            });
            let most = apart.fold(0.0, f64::max);
            assert!(most < within * CLEARANCE, "{method:?} {amount}: {most}");
        }
    }
}

#[test]
fn val_a_string_at_rest_elsewhere_and_springs_too_stiff_are_refused() {
    let scene = turning(60.0, 0.1, 1.0);
    let mut elsewhere = scene.clone();
    let lateral = elsewhere.lateral.as_mut().unwrap();
    lateral.lying.as_mut().unwrap().forces.pop();
    for (springs, scene, words) in [
        (&[][..], &elsewhere, "8 places, but there are 9 walls"),
        (&[1e9; 9], &scene, "too stiff to be taken back"),
    ] {
        let simulator = held_by(springs, &Method::Quadrature, 500.0, 1.0);
        let refused = simulator.simulate(scene, Stopping::Early, None);
        let error = refused.unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    }
}

/// The whole string goes through all of its sites where springs hold its linear part, too: those are in
/// its forces.
#[test]
fn val_a_string_held_by_springs_goes_through_its_sites() {
    let springs = [3e4, 0.0, 1e5, 2e4, 5e5, 0.0, 7e3, 1e5, 4e4];
    let (frequency, snapshots) = (1000.0, [0, 60, 150, 999]);
    for (method, within) in [
        (Method::FiniteElement(MESH), 1e-8),
        (Method::Quadrature, 0.1),
    ] {
        let mut scene = turning(60.0, 0.3, 1.0);
        let pushed = Impulse {
            site: 4,
            amount: 2000.0,
            start: 0.05,
            duration: 0.05,
            direction: 0.3,
        };
        scene.lateral.as_mut().unwrap().impulses = vec![pushed];
        let motion = motion(&held_by(&springs, &method, frequency, 1.0), &scene);
        let (string, sites) = (string(), request(&springs, frequency, 1.0).sites);
        let whole = WholeString {
            string: &string,
            bending: &BENDING,
            support: SurfaceSupport::Free,
            sites: &sites,
            sampling_frequency: frequency,
            parameters: MESH,
        };
        let distances = sites.distances_from_bit();
        let resting = |from_bit: f64| {
            let site = distances.iter().position(|it| (it - from_bit).abs() < 1e-9);
            site.map_or([0.0; 2], |site| lying().positions[site])
        };
        let whole = whole.reconstruct_about(&resting, &motion.forces, &snapshots);
        let whole = whole.unwrap();
        let (mut off, mut moved) = (0.0_f64, 0.0_f64);
        for (site, distance) in distances.iter().enumerate() {
            let node = |depth: &f64| (depth - (LENGTH - distance)).abs() < 1e-9;
            let node = whole.depths.iter().position(node).unwrap();
            let began = motion.positions[site][0];
            for (step, [x, y]) in snapshots.iter().zip(&whole.shapes) {
                let [at_x, at_y] = motion.positions[site][*step];
                off = off.max((x[node] - at_x).hypot(y[node] - at_y));
                moved = moved.max((at_x - began[0]).hypot(at_y - began[1]));
            }
        }
        assert!(moved > 0.3 * CLEARANCE, "{method:?}: {moved}");
        assert!(off < within * CLEARANCE, "{method:?}: {off}");
    }
}

/// Where moments are compared, m from the bit: at walls and between them.
const BENT_AT: [f64; 5] = [55.0, 40.0, 30.0, 26.5, 10.0];

/// What bends it at rest at a wall, q d²/12 of equal spans, N m.
const BENT_BY: f64 = 1_605.383_434 * (LENGTH / 9.0) * (LENGTH / 9.0) / 12.0;

/// Elements short enough for the waves that matter.
const MESH: FiniteElement = FiniteElement {
    elements_per_cell: 54,
    gamma: 0.52,
    beta: None,
};

/// Steps of the last 5 s.
fn closing(motion: &Trajectory, sampling_frequency: f64) -> usize {
    motion.times.len() - (5.0 * sampling_frequency) as usize
}

/// Moments of the last 5 s of a motion by the responses of a method.
fn moments_by(
    method: &Method,
    springs: &[f64],
    (sampling_frequency, duration): (f64, f64),
    motion: &Trajectory,
) -> Vec<[Vec<f64>; 2]> {
    let (string, request) = (string(), request(springs, sampling_frequency, duration));
    let plan =
        PlacePlan::new(&string, method, &request, (PlaceQuantity::Moment, &BENT_AT)).unwrap();
    let moments = AtPlaces::new(plan.build(&Budget::unlimited()).unwrap()).unwrap();
    let from = closing(motion, sampling_frequency);
    moments.of(&motion.forces, from).unwrap()
}

/// The same by elements that the forces are applied to: of a method's responses they know nothing.
fn moments_of_elements(sampling_frequency: f64, motion: &Trajectory) -> Vec<[Vec<f64>; 2]> {
    let string = string();
    let whole = WholeString {
        string: &string,
        bending: &BENDING,
        support: SurfaceSupport::Free,
        sites: &request(&[], sampling_frequency, 1.0).sites,
        sampling_frequency,
        parameters: MESH,
    };
    let from = closing(motion, sampling_frequency);
    whole.moments(&motion.forces, &BENT_AT, from).unwrap()
}

/// The greatest and the root mean square of differences of moments, N m, and the greatest moment.
fn apart(ones: &[[Vec<f64>; 2]], others: &[[Vec<f64>; 2]]) -> [f64; 3] {
    let all = |moments: &[[Vec<f64>; 2]]| -> Vec<f64> {
        moments.iter().flatten().flatten().copied().collect()
    };
    let greatest = |values: &[f64]| values.iter().fold(0.0, |most: f64, it| most.max(it.abs()));
    let (ones, others) = (all(ones), all(others));
    assert_eq!(ones.len(), others.len());
    let differences = ones.iter().zip(&others).map(|(one, other)| one - other);
    let differences: Vec<f64> = differences.collect();
    let squares: f64 = differences.iter().map(|it| it * it).sum();
    let mean = (squares / ones.len() as f64).sqrt();
    [greatest(&differences), mean, greatest(&ones)]
}

fn motion(simulator: &Simulator, scene: &Scene) -> Trajectory {
    let mut motion = Trajectory::default();
    simulator
        .simulate(scene, Stopping::Full, Some(&mut motion))
        .unwrap();
    motion
}

/// Climbing, and shaken by an eccentric mass, by two methods that share no equation, each with its own
/// motion: over time alike to half a per cent of what bends the string at rest. That is what is left of
/// waves of hundreds of hertz from the start, which only the damping of the string takes.
#[test]
fn val_a_moving_string_is_bent_alike_by_methods_that_share_no_equation() {
    let frequency = 2000.0;
    for (name, scene, moves) in [
        ("climbs", turning(120.0, 0.3, 20.0), 30.0),
        ("snakes", unbalanced(94.0), 250.0),
    ] {
        let duration = scene.timing.duration;
        let [held, elements] = [Method::Held, Method::FiniteElement(MESH)].map(|method| {
            let motion = motion(&simulator(&method, frequency, duration), &scene);
            moments_by(&method, &[], (frequency, duration), &motion)
        });
        let [most, mean, greatest] = apart(&held, &elements);
        assert!(greatest > moves, "{name}: {greatest}");
        assert!(most < 5e-3 * BENT_BY, "{name}: {most}");
        assert!(mean < 1e-3 * BENT_BY, "{name}: {mean}");
    }
}

/// Rolling round its hole it is bent by sixteen times as much, and no two motions are alike; but by the
/// same forces it is bent as elements are that know nothing of the responses.
#[test]
fn val_a_string_that_whirls_is_bent_by_its_forces_as_elements_are() {
    let (frequency, duration) = (2000.0, 10.0);
    let scene = turning(120.0, 0.8, duration);
    for (method, within) in [
        (Method::Held, [4e-2, 1e-2]),
        (Method::FiniteElement(MESH), [1e-7, 1e-8]),
    ] {
        let motion = motion(&simulator(&method, frequency, duration), &scene);
        let own = moments_by(&method, &[], (frequency, duration), &motion);
        let [most, mean, greatest] = apart(&own, &moments_of_elements(frequency, &motion));
        assert!(greatest > 12.0 * BENT_BY, "{method:?}: {greatest}");
        assert!(most < within[0] * greatest, "{method:?}: {most} {greatest}");
        assert!(mean < within[1] * greatest, "{method:?}: {mean} {greatest}");
    }
}

/// The forces on a string that springs hold have those in them, which are taken back; its responses
/// too.
#[test]
fn val_springs_that_are_taken_back_bend_nothing() {
    let springs = [3e4, 0.0, 1e5, 2e4, 5e5, 0.0, 7e3, 1e5, 4e4];
    let (method, frequency, duration) = (Method::Quadrature, 1000.0, 6.0);
    let scene = turning(60.0, 0.3, duration);
    let [one, other] = [&[][..], &springs].map(|springs| {
        let motion = motion(&held_by(springs, &method, frequency, duration), &scene);
        moments_by(&method, springs, (frequency, duration), &motion)
    });
    let [most, _, greatest] = apart(&one, &other);
    assert!(most < 1e-6 * greatest, "{most} {greatest}");
}

/// What walls have stored, J.
fn stored(place: [f64; 2]) -> f64 {
    let pressed_in = (place[0].hypot(place[1]) - CLEARANCE).max(0.0);
    0.4 * STIFFNESS * pressed_in.powf(2.5)
}

/// Pushed off its wall from all sides, without friction: walls give back what they store, their forces
/// at rest included, and the string no more than it was given about its rest.
#[test]
fn val_a_string_that_is_pushed_off_its_low_side_balances_its_energy() {
    for method in [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(FiniteElement::default()),
    ] {
        let simulator = simulator(&method, 1000.0, 20.0);
        let mut scene = turning(0.0, 0.0, 20.0);
        let lateral = scene.lateral.as_mut().unwrap();
        let impulse = |number: u32| Impulse {
            site: (number as usize * 4 + 4) % 9,
            amount: 3000.0,
            start: 0.1 + f64::from(number),
            duration: 0.02,
            direction: 0.7 * f64::from(number),
        };
        lateral.impulses = (0..15).map(impulse).collect();
        let at_rest = lateral.lying.clone().unwrap();
        let mut motion = Trajectory::default();
        let simulated = simulator.simulate(&scene, Stopping::Full, Some(&mut motion));
        simulated.unwrap();
        let mut before = at_rest.positions.clone();
        let begun: f64 = before.iter().map(|place| stored(*place)).sum();
        let (mut by_walls, mut by_all, mut by_impulses) = (0.0, 0.0, 0.0);
        let mut steps: Vec<[f64; 2]> = Vec::new();
        let (mut most, mut in_the_air) = (0.0_f64, 0);
        let offset = method.collocation_offset();
        // Of a step by Newmark's scheme the energy is that of the mean of forces at its ends.
        let earlier_part = match method {
            Method::FiniteElement(_) => 0.5,
            _ => 0.0,
        };
        for step in 0..motion.positions[0].len() {
            for (site, place) in before.iter_mut().enumerate() {
                let (now, wall) = (motion.positions[site][step], motion.wall_forces[site][step]);
                in_the_air += usize::from(wall == [0.0; 2]);
                // What is known in the middle of a step moves straight on to its end.
                let end = [0, 1].map(|axis| (now[axis] - offset * place[axis]) / (1.0 - offset));
                for axis in 0..2 {
                    let moved = end[axis] - place[axis];
                    let (beyond_rest, at_rest) =
                        (motion.forces[axis][site][step], at_rest.forces[site][axis]);
                    by_walls += wall[axis] * moved;
                    let earlier = step.checked_sub(1);
                    let earlier = earlier.map_or(0.0, |it| motion.forces[axis][site][it]);
                    let force = beyond_rest + earlier_part * (earlier - beyond_rest);
                    by_all += force * moved;
                    by_impulses += (beyond_rest + at_rest - wall[axis]) * moved;
                }
                *place = end;
            }
            most = most.max(by_impulses);
            let in_walls: f64 = before.iter().map(|place| stored(*place)).sum();
            steps.push([by_walls + in_walls - begun, by_all]);
        }
        let name = method.name();
        assert!(in_the_air > 1000, "{name}: {in_the_air}");
        for (step, [made, given]) in steps.into_iter().enumerate() {
            assert!(made <= 1e-9 * most, "{name} {step}: {made} of {most}");
            assert!(given >= -1e-6 * most, "{name} {step}: {given} of {most}");
            // Walls lose nothing.
            if matches!(method, Method::Held) {
                assert!(made >= -1e-9 * most, "{name} {step}: {made} of {most}");
            }
        }
    }
}
