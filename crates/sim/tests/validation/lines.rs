//! One scene by lines of different make: friction along the string, walls and a drive together.
//! Pieces that hand on waves, responses of the whole string and elements that are stepped share no
//! code that steps, and have the same motion where they are of one method.

use linear::estimates::torsional_travel_time;
use linear::method::FiniteElement;
use linear::{
    Cascade, ChannelRequest, Drillstring, Method, Request, Sites, SteppedString, SurfaceSupport,
    TopDrive, steady,
};
use problems::academic::{self, BENDING};
use problems::oracles::relative_difference;
use problems::wells::{Draw, Well};
use sim::{
    BitTorque, Ended, Impulse, Lateral, Outcome, PipeFriction, Scene, Simulator, Start, Stopping,
    SurfaceProfile, SurfaceTorque, System, Timing, TorsionRegime, Trajectory, Wall,
};

const FREQUENCY: f64 = 160.0;
const TIME: f64 = 30.0;
const SPEED: f64 = 6.0;
const PIECES: usize = 6;

/// Where there are walls, m from the bit: some so near to one another that they feel it within a
/// step.
const WALLS: [f64; 4] = [40.0, 2.0, 1.0, 0.0];

/// What of a scene there is.
#[derive(Debug, Clone, Copy)]
struct With {
    bit: bool,
    walls: bool,
    friction: bool,
    drive: bool,
}

impl With {
    fn string(self) -> Drillstring {
        let string = academic::damped_string(1.0);
        let drive = TopDrive {
            inertia: 2900.0,
            proportional_gain: 6000.0,
            integral_gain: 4000.0,
            delay: 0.0,
            late_inertia: 0.0,
        };
        match self.drive {
            true => string.with_top_drive(drive).unwrap(),
            false => string,
        }
    }

    /// Middles of equal pieces, and the places of walls.
    fn nodes(self, string: &Drillstring) -> Sites {
        let piece = string.length() / PIECES as f64;
        let middles = (0..PIECES).map(|index| (index as f64 + 0.5) * piece);
        Sites::new(string, &middles.chain(WALLS).collect::<Vec<_>>()).unwrap()
    }

    fn scene(self, nodes: &Sites) -> Scene {
        let friction = PipeFriction {
            torque_static: 900.0,
            torque_dynamic: 600.0,
            stribeck_speed: 1.0,
        };
        let rubs = |distance: &f64| (!WALLS.contains(distance)).then_some(friction);
        let of_nodes = nodes.distances_from_bit().iter().map(rubs);
        let wall = Wall {
            clearance: 0.015,
            stiffness: 1e7,
            friction: 0.6,
            dynamic_ratio: 1.0,
            stribeck_speed: 0.0,
            radius: 0.15,
        };
        let impulse = Impulse {
            site: 2,
            amount: 3000.0,
            start: 12.0,
            duration: 0.05,
            direction: 0.3,
        };
        Scene {
            surface_speed: SPEED,
            start: Start::Rest,
            bit: self.bit.then_some(BitTorque {
                torque_static: 4000.0,
                torque_dynamic: 3000.0,
                decay_speed: 0.0,
            }),
            friction: match self.friction {
                true => of_nodes.collect(),
                false => Vec::new(),
            },
            axial: None,
            lateral: self.walls.then(|| Lateral {
                walls: vec![wall; WALLS.len()],
                impulses: vec![impulse],
                eccentric_masses: Vec::new(),
                lying: None,
                shocks: None,
            }),
            timing: Timing {
                duration: TIME,
                closing_window: 5.0,
            },
        }
    }
}

/// Of both motions at sites, with torques at all of them.
fn request(sites: &Sites, channel: impl FnOnce(usize) -> ChannelRequest) -> Request {
    Request {
        channels: vec![channel(sites.len())],
        sites: sites.clone(),
        sampling_frequency: FREQUENCY,
        longest_time: TIME,
    }
}

fn in_torsion(sites: usize) -> ChannelRequest {
    ChannelRequest::Torsion {
        torques: (0..sites).collect(),
    }
}

fn in_bending(_: usize) -> ChannelRequest {
    ChannelRequest::Bending {
        bending: BENDING,
        support: SurfaceSupport::Free,
    }
}

fn with_walls(system: System, string: &Drillstring, method: &Method) -> Simulator {
    let sites = Sites::new(string, &WALLS).unwrap();
    let responses = linear::responses(string, method, &request(&sites, in_bending)).unwrap();
    Simulator::of(system.bending_by(&responses).unwrap())
}

/// By responses of the whole string.
fn whole(with: With, method: &Method) -> Simulator {
    let string = with.string();
    let nodes = with.nodes(&string);
    let responses = linear::responses(&string, method, &request(&nodes, in_torsion)).unwrap();
    let system = System::started(&responses, &SurfaceProfile::Rise(2.0)).unwrap();
    with_walls(system, &string, method)
}

/// In pieces.
fn pieces(with: With, method: &Method) -> Simulator {
    let string = with.string();
    let nodes = with.nodes(&string);
    let cascade = Cascade::new(&string, method, &nodes, FREQUENCY, TIME).unwrap();
    let system = System::in_pieces(&cascade, &SurfaceProfile::Rise(2.0), 0.0).unwrap();
    with_walls(system, &string, method)
}

fn motion(simulator: &Simulator, with: With) -> (Outcome, Trajectory) {
    let string = with.string();
    let scene = with.scene(&with.nodes(&string));
    let mut record = Trajectory::default();
    let outcome = simulator.simulate(&scene, Stopping::Full, Some(&mut record));
    (outcome.unwrap(), record)
}

/// By how much two motions differ, as parts of the largest speed and displacement.
fn difference(one: &Trajectory, other: &Trajectory) -> f64 {
    let speeds = one.speeds.iter().zip(&other.speeds);
    let speeds = speeds.map(|(one, other)| relative_difference(one, other));
    let along = |motion: &Trajectory| -> Vec<f64> {
        motion
            .positions
            .iter()
            .flatten()
            .flatten()
            .copied()
            .collect()
    };
    let (one, other) = (along(one), along(other));
    assert_eq!(one.len(), other.len());
    let bent = match one.is_empty() {
        true => 0.0,
        false => relative_difference(&one, &other),
    };
    speeds.fold(bent, f64::max)
}

const ALL: [With; 5] = {
    let none = With {
        bit: false,
        walls: false,
        friction: false,
        drive: false,
    };
    [
        With {
            bit: true,
            friction: true,
            ..none
        },
        With {
            bit: true,
            friction: true,
            drive: true,
            ..none
        },
        With {
            walls: true,
            ..none
        },
        With {
            walls: true,
            friction: true,
            ..none
        },
        With {
            bit: true,
            walls: true,
            friction: true,
            drive: true,
        },
    ]
};

#[test]
fn val_pieces_and_responses_of_the_whole_string_have_one_motion() {
    let methods = [
        Method::Quadrature,
        Method::FiniteElement(FiniteElement::default()),
    ];
    for (with, method) in ALL.iter().flat_map(|with| methods.map(|it| (*with, it))) {
        let (one, of_pieces) = motion(&pieces(with, &method), with);
        let (other, of_whole) = motion(&whole(with, &method), with);
        let off = difference(&of_pieces, &of_whole);
        println!("{with:?} {} {off:e}", method.name());
        assert!(off < 1e-6, "{with:?} {}: {off}", method.name());
        assert_eq!(
            one.torsion().map(|it| it.regime),
            other.torsion().map(|it| it.regime)
        );
        assert_eq!(
            one.lateral().map(|it| it.regime),
            other.lateral().map(|it| it.regime)
        );
        if with.walls {
            let touches = of_whole.touches.iter().flatten();
            let touching = touches.filter(|it| **it != sim::laws::contact::Touch::Free);
            assert!(touching.count() > 20, "the walls do nothing");
        }
    }
}

/// A string that turns steadily, or is held at the bit while it winds up: pieces begin with what
/// differs from that, too.
#[test]
fn val_pieces_begin_with_a_steady_motion_as_the_whole_string_does() {
    let with = With {
        bit: true,
        ..ALL[2]
    };
    let with = With {
        walls: false,
        ..with
    };
    let string = with.string();
    let nodes = with.nodes(&string);
    let rest = with.scene(&nodes);
    let bit = rest.bit.unwrap();
    let starts = [
        // Not at the torque at which it slips, or rounding would say in which step.
        steady::winding(&string, &nodes, SPEED, 0.99 * bit.torque_static),
        steady::rotation(&string, &nodes, SPEED, 0.9 * bit.torque_dynamic),
    ];
    let method = Method::Quadrature;
    let request = request(&nodes, in_torsion);
    let taps = linear::surface_torque(&string, &method, &request).unwrap();
    let responses = linear::responses(&string, &method, &request).unwrap();
    let profile = SurfaceProfile::default();
    let torque = SurfaceTorque::new(&responses, &taps, &profile, 0.0).unwrap();
    let cascade = Cascade::new(&string, &method, &nodes, FREQUENCY, TIME).unwrap();
    let simulators = [
        Simulator::in_pieces(&cascade, &profile, 0.0).unwrap(),
        Simulator::new(&responses).unwrap(),
    ];
    for start in starts {
        let scene = Scene {
            start: Start::Steady(start),
            ..rest.clone()
        };
        let [of_pieces, of_whole] = simulators.each_ref().map(|simulator| {
            let mut record = Trajectory::default();
            (simulator.simulate(&scene, Stopping::Full, Some(&mut record))).unwrap();
            record
        });
        let off = difference(&of_pieces, &of_whole);
        assert!(off < 1e-6, "{off}");
        let at_surface = torque.of(SPEED, &scene.start, &of_whole);
        let off = relative_difference(&of_pieces.surface_torque, &at_surface);
        assert!(off < 1e-6, "surface: {off}");
    }
}

/// Waves that are exact up to their sampling have that motion but for what quadrature smears.
#[test]
fn val_held_waves_have_the_motion_of_quadrature_where_it_is_smooth() {
    let with = ALL[0];
    let (one, _) = motion(&whole(with, &Method::Held), with);
    let (other, _) = motion(&pieces(with, &Method::Quadrature), with);
    let [one, other] = [one, other].map(|outcome| outcome.torsion().unwrap());
    assert_eq!(one.regime, other.regime);
    let slips = [one, other].map(|it| it.first_slip.unwrap());
    assert!((slips[0] / slips[1] - 1.0).abs() < 0.01, "{slips:?}");
    let speeds = [one, other].map(|it| it.closing_speed);
    assert!((speeds[0] / speeds[1] - 1.0).abs() < 0.02, "{speeds:?}");
}

/// Elements that are stepped, at every node walls and friction.
#[test]
fn val_a_stepped_mesh_rubs_as_pieces_of_elements_do() {
    let with = ALL[0];
    let string = with.string();
    let nodes = with.nodes(&string);
    let parameters = FiniteElement::default();
    let mesh = SteppedString::new(
        &string,
        &BENDING,
        SurfaceSupport::Free,
        &nodes,
        &parameters,
        FREQUENCY,
    )
    .unwrap();
    let responses = mesh.responses(&[], TIME).unwrap();
    let stepped = Simulator::stepped(&mesh, &responses, &SurfaceProfile::Rise(2.0)).unwrap();
    let (_, one) = motion(&stepped, with);
    let (_, other) = motion(&pieces(with, &Method::FiniteElement(parameters)), with);
    let off = difference(&one, &other);
    assert!(off < 1e-6, "{off}");
}

/// On random strings that rub, below slow and fast surfaces, with a bit and without: what has settled
/// has the label, and to a hundredth the torque at the surface, that it has at the end.
#[test]
fn val_strings_that_rub_and_end_early_have_the_labels_of_those_that_do_not() {
    let mut settled = [0; 2];
    let mut stepped = [0.0; 2];
    for number in 0..60 {
        let mut draw = Draw::new(number);
        let string = Well::draw(number, &mut draw).string;
        let pieces = 2 + number % 5;
        let piece = string.length() / pieces as f64;
        let middles = (0..pieces).map(|index| (index as f64 + 0.5) * piece);
        let nodes = Sites::new(&string, &middles.chain([0.0]).collect::<Vec<_>>()).unwrap();
        let total = draw.log_uniform(500.0, 20_000.0);
        let friction = PipeFriction {
            torque_static: total / pieces as f64,
            torque_dynamic: total / pieces as f64 * draw.uniform(0.5, 1.0),
            stribeck_speed: draw.uniform(0.1, 2.0),
        };
        let torque = draw.uniform(500.0, 4000.0);
        let bit = (number % 3 > 0).then_some(BitTorque {
            torque_static: torque * draw.uniform(1.1, 1.6),
            torque_dynamic: torque,
            decay_speed: 0.0,
        });
        let travel = torsional_travel_time(&string);
        let duration = 60.0 + 60.0 * travel;
        let scene = Scene {
            surface_speed: draw.log_uniform(1.0, 15.0),
            start: Start::Rest,
            bit,
            friction: std::iter::repeat_n(Some(friction), pieces)
                .chain([None])
                .collect(),
            axial: None,
            lateral: None,
            timing: Timing {
                duration,
                closing_window: 0.15 * duration,
            },
        };
        let frequency = (40.0 / travel).min(200.0);
        let cascade =
            Cascade::new(&string, &Method::Quadrature, &nodes, frequency, duration).unwrap();
        let simulator = Simulator::in_pieces(&cascade, &SurfaceProfile::Rise(2.0), 0.0).unwrap();
        let run = |stopping| simulator.simulate(&scene, stopping, None).unwrap();
        let (early, full) = (run(Stopping::Early), run(Stopping::Full));
        let regime = full.torsion().unwrap().regime;
        assert_eq!(early.torsion().unwrap().regime, regime, "{number}");
        stepped[0] += early.simulated;
        stepped[1] += full.simulated;
        if early.ended == Ended::Settled {
            settled[usize::from(regime == TorsionRegime::StickSlip)] += 1;
            let [one, other] = [early, full].map(|it| it.surface.unwrap().mean_torque);
            assert!((one / other - 1.0).abs() < 0.01, "{number}: {one} {other}");
        }
    }
    println!("settled {settled:?}, seconds stepped {stepped:?}");
    assert!(settled[0] > 5, "{settled:?}");
}
