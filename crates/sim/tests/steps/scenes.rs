//! Plain scenes, one for each thing that a step may have to do: numbers of steps of each are compared, so
//! that a system is built for few.

use linear::{
    Budget, Cascade, ChannelRequest, Drillstring, GrowingTorque, Material, Method, PolePlan,
    Request, Section, Sites, SteadyMotion, SurfaceSupport, responses,
};
use problems::academic::{self, BENDING, tube};
use problems::dashpots::{BelowDashpots, pipe};
use sim::laws::rock::CuttingLaw;
use sim::{
    Axial, BitTorque, Blades, Cutting, EccentricMass, FlatContact, Lateral, PipeFriction, Scene,
    Start, SurfaceProfile, System, Timing, Wall,
};

/// s.
pub const LONGEST: f64 = 2.5;

/// Makes a scene and its system.
type Make = fn() -> (System, Scene);

/// Names, with what makes each.
pub const SCENES: [(&str, Make); 8] = [
    ("bit_alone", bit_alone),
    ("one_wall", || walls((1, 45.0), &Method::Quadrature)),
    ("three_walls", || walls((3, 45.0), &Method::Quadrature)),
    ("three_walls_held", || walls((3, 45.0), &Method::Held)),
    ("22_walls", || walls((22, 4.5), &Method::Quadrature)),
    ("22_walls_by_poles", || walls((22, 4.5), &Method::Poles)),
    ("cut", cut),
    ("pipe", pipe_friction),
];

/// A hundred metres of collars.
fn collars() -> Drillstring {
    let steel = Material {
        shear_modulus: 80e9,
        density: 7840.0,
    };
    let section = Section {
        repeat: 10,
        parts: vec![tube(10.0, 0.15)],
    };
    Drillstring::new(steel, vec![section], 10.0).unwrap()
}

fn scene(surface_speed: f64) -> Scene {
    Scene {
        surface_speed,
        start: Start::Rest,
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration: LONGEST,
            closing_window: 1.0,
        },
    }
}

/// It sticks and slips.
fn bit_alone() -> (System, Scene) {
    let request = academic::bit_request(LONGEST);
    let responses = responses(&academic::string(), &Method::Quadrature, &request).unwrap();
    let mut scene = scene(2.0);
    scene.bit = Some(BitTorque {
        torque_static: 4800.0,
        torque_dynamic: 4000.0,
        decay_speed: 0.0,
    });
    (System::new(&responses).unwrap(), scene)
}

/// Forward whirl of masses that press a number of sites outwards, so far apart, m.
fn walls((sites, apart): (usize, f64), method: &Method) -> (System, Scene) {
    let string = collars();
    let distances: Vec<f64> = (0..sites).map(|site| apart * site as f64).collect();
    let request = Request {
        sites: Sites::new(&string, &distances).unwrap(),
        channels: vec![
            ChannelRequest::Torsion {
                torques: (0..sites).collect(),
            },
            ChannelRequest::Bending {
                bending: BENDING,
                support: SurfaceSupport::Pinned,
            },
        ],
        sampling_frequency: 640.0,
        longest_time: LONGEST,
    };
    let system = match method {
        Method::Poles => by_poles(&string, request),
        _ => System::new(&responses(&string, method, &request).unwrap()).unwrap(),
    };
    let mut scene = scene(std::f64::consts::TAU);
    let wall = Wall {
        clearance: 0.015,
        stiffness: 1e9,
        friction: 0.2,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    };
    let mass = |site| EccentricMass {
        site,
        mass: 1000.0,
        offset: 0.1,
    };
    scene.lateral = Some(Lateral {
        walls: vec![wall; sites],
        impulses: vec![],
        eccentric_masses: (0..sites).map(mass).collect(),
        lying: None,
        shocks: None,
    });
    (system, scene)
}

/// Such a system that bends by poles.
fn by_poles(string: &Drillstring, mut request: Request) -> System {
    let (bends, sites) = ((&BENDING, SurfaceSupport::Pinned), request.sites.clone());
    let plan = PolePlan::new(string, bends, &sites, request.sampling_frequency).unwrap();
    let poles = plan.build(&Budget::unlimited()).unwrap();
    request.channels.truncate(1);
    let turning = System::new(&responses(string, &Method::Held, &request).unwrap()).unwrap();
    turning.bending_by_poles(&poles, &sites).unwrap()
}

/// A bit with uneven blades that cuts, kicked.
fn cut() -> (System, Scene) {
    let (speed, rate) = (4.0, 0.006);
    let below = BelowDashpots::new(&[pipe(2000.0)], [0.9, 0.3]);
    let request = Request {
        sites: Sites::bit(),
        channels: vec![
            ChannelRequest::Torsion { torques: vec![0] },
            ChannelRequest::Axial {
                rod: Box::new(below.rod.clone()),
                forces: vec![0],
            },
        ],
        sampling_frequency: 640.0,
        longest_time: LONGEST,
    };
    let responses = responses(&below.string, &Method::Held, &request).unwrap();
    let profile = SurfaceProfile::Rise(0.0);
    let system = System::started(&responses, &profile).unwrap();
    let system = system.moving_along(&responses, &profile).unwrap();
    let angles = [80f64, 100.0, 85.0, 95.0].map(f64::to_radians);
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
        blades: Blades::Uneven(angles.to_vec()),
        relief: 60f64.to_radians().tan(),
    };
    let advance = rate / speed * std::f64::consts::TAU / 4.0;
    let steady = |torque: f64| GrowingTorque { torque, rate: 0.0 };
    let torque = cutting.steady(advance)[0];
    let mut scene = scene(speed);
    scene.start = Start::Steady(SteadyMotion {
        speeds: vec![speed],
        at_bit: steady(-torque),
        at_surface: steady(torque),
    });
    scene.axial = Some(Axial {
        cutting,
        feed: rate,
        start_rate: rate,
        kick: None,
    });
    (system, scene)
}

/// Friction on twenty pieces of a string that begins to turn.
fn pipe_friction() -> (System, Scene) {
    let pieces = 20;
    let string = academic::damped_string(1.0);
    let piece = string.length() / pieces as f64;
    let middle = |index: usize| (index as f64 + 0.5) * piece;
    let distances: Vec<f64> = (0..pieces).map(middle).chain([0.0]).collect();
    let nodes = Sites::new(&string, &distances).unwrap();
    let cascade = Cascade::new(&string, &Method::Quadrature, &nodes, 640.0, LONGEST).unwrap();
    let system = System::in_pieces(&cascade, &SurfaceProfile::Rise(2.0), 0.0).unwrap();
    let law = PipeFriction {
        torque_static: 60_000.0 / pieces as f64,
        torque_dynamic: 30_000.0 / pieces as f64,
        stribeck_speed: 0.5,
    };
    let mut scene = scene(0.5 * std::f64::consts::TAU);
    let friction = std::iter::repeat_n(Some(law), pieces).chain([None]);
    scene.friction = friction.collect();
    (system, scene)
}
