//! Strings that may touch at many sites: a mesh that is stepped against the taps of the same
//! elements, whose convolution shares no line with it.

use linear::method::FiniteElement;
use linear::{Drillstring, Method, Section, Sites, SteppedString, SurfaceSupport, responses};
use problems::academic::{self, BENDING, SAMPLING_FREQUENCY, tube};
use sim::{
    BitTorque, EccentricMass, Impulse, Lateral, Outcome, PipeFriction, Scene, Simulator, Stopping,
    SurfaceProfile, Timing, Trajectory, Wall,
};

const DURATION: f64 = 6.0;
const CLEARANCE: f64 = 0.015;

/// A string with both simulators, and how many sites it has.
struct Both {
    taps: Simulator,
    mesh: Simulator,
    sites: usize,
}

impl Both {
    fn new(string: &Drillstring, distances: &[f64], profile: &SurfaceProfile) -> Self {
        let parameters = FiniteElement::default();
        let request = academic::lateral_request(string, distances, DURATION);
        let built = responses(string, &Method::FiniteElement(parameters), &request).unwrap();
        let mesh = SteppedString::new(
            string,
            &BENDING,
            SurfaceSupport::Free,
            &Sites::new(string, distances).unwrap(),
            &parameters,
            SAMPLING_FREQUENCY,
        )
        .unwrap();
        let to_surface = mesh.responses(&[], DURATION).unwrap();
        Self {
            taps: Simulator::started(&built, profile).unwrap(),
            mesh: Simulator::stepped(&mesh, &to_surface, profile).unwrap(),
            sites: distances.len(),
        }
    }

    /// An impulse on each of these sites; their walls have a friction.
    fn scene(&self, disturbed: &[usize], friction: f64, bit: Option<BitTorque>) -> Scene {
        let wall = Wall {
            clearance: CLEARANCE,
            stiffness: 1e9,
            friction,
            dynamic_ratio: 1.0,
            stribeck_speed: 0.0,
            radius: 0.15,
        };
        let impulse = |&site: &usize| Impulse {
            site,
            amount: 1000.0,
            start: 0.5,
            duration: 0.02,
            direction: 0.3 * site as f64,
        };
        Scene {
            start: sim::Start::Rest,
            surface_speed: std::f64::consts::TAU,
            bit,
            friction: Vec::new(),
            axial: None,
            lateral: Some(Lateral {
                walls: vec![wall; self.sites],
                impulses: disturbed.iter().map(impulse).collect(),
                eccentric_masses: vec![EccentricMass {
                    site: 0,
                    mass: 20.0,
                    offset: 0.05,
                }],
                lying: None,
                shocks: None,
            }),
            timing: Timing {
                duration: DURATION,
                closing_window: 2.0,
            },
        }
    }

    fn followed(&self, scene: &Scene) -> [(Outcome, Trajectory); 2] {
        [&self.taps, &self.mesh].map(|simulator| {
            let mut motion = Trajectory::default();
            let outcome = simulator.simulate(scene, Stopping::Full, Some(&mut motion));
            (outcome.unwrap(), motion)
        })
    }
}

/// The largest difference of positions up to a time, over the clearance, and of speeds over
/// those of the surface.
fn apart(motions: [&Trajectory; 2], until: f64) -> [f64; 2] {
    let steps = (until * SAMPLING_FREQUENCY) as usize;
    let [one, other] = motions;
    let most = |differences: &mut dyn Iterator<Item = f64>| differences.fold(0.0, f64::max);
    let sites = one.positions.iter().zip(&other.positions);
    let mut positions = sites.flat_map(|(one, other)| {
        let steps = one.iter().zip(other).take(steps);
        steps.map(|([x, y], [u, v])| (x - u).hypot(y - v) / CLEARANCE)
    });
    let sites = one.speeds.iter().zip(&other.speeds);
    let mut speeds = sites.flat_map(|(one, other)| {
        let steps = one.iter().zip(other).take(steps);
        steps.map(|(one, other)| (one - other).abs() / std::f64::consts::TAU)
    });
    [most(&mut positions), most(&mut speeds)]
}

/// Nothing but rounding parts them until contacts that slide have made much of it.
#[test]
fn val_a_mesh_that_is_stepped_moves_as_its_taps_do() {
    let string = academic::string();
    let both = Both::new(
        &string,
        &[0.0, 3.0, 6.0, 50.0, 100.0],
        &SurfaceProfile::default(),
    );
    for (disturbed, friction) in [(&[4][..], 0.5), (&[4], 2.0), (&[1, 3, 4], 1.0)] {
        let [taps, mesh] = both.followed(&both.scene(disturbed, friction, None));
        let [positions, speeds] = apart([&taps.1, &mesh.1], 1.5);
        assert!(
            positions < 1e-6 && speeds < 1e-6,
            "{friction}: {positions} {speeds}"
        );
        let [one, other] = [&taps.0, &mesh.0].map(|outcome| outcome.lateral().unwrap());
        assert_eq!(one.regime, other.regime, "{friction}");
        let first = one.first_contact.unwrap();
        assert!(
            first < 1.5 && other.first_contact == Some(first),
            "{friction}"
        );
    }
}

/// A bit that cuts next to its wall, a surface that rises to its speed, a light string.
#[test]
fn val_so_it_does_where_the_bit_cuts_too() {
    let sections = vec![
        Section {
            repeat: 60,
            parts: vec![tube(9.0, 0.0635), tube(0.5, 0.084)],
        },
        Section {
            repeat: 8,
            parts: vec![tube(9.5, 0.1)],
        },
    ];
    let steel = academic::string().material();
    let string = Drillstring::new(steel, sections, 0.5).unwrap();
    let both = Both::new(&string, &[0.0, 9.5, 19.0, 28.5], &SurfaceProfile::Rise(2.0));
    let bit = BitTorque {
        torque_static: 1500.0,
        torque_dynamic: 1000.0,
        decay_speed: 0.0,
    };
    let [taps, mesh] = both.followed(&both.scene(&[2], 0.3, Some(bit)));
    let [positions, speeds] = apart([&taps.1, &mesh.1], 1.5);
    assert!(positions < 1e-6 && speeds < 1e-6, "{positions} {speeds}");
    let regimes = [&taps.0, &mesh.0].map(|outcome| outcome.torsion().unwrap().regime);
    assert_eq!(regimes[0], regimes[1]);
}

/// Below a top drive that the mesh is stepped with, where the string rubs along its well too.
#[test]
fn val_so_it_does_below_a_top_drive_and_with_friction_along_the_string() {
    let plain = academic::string();
    let drive = linear::controllers::soft_torque(&plain, 2000.0);
    let string = plain.with_top_drive(drive).unwrap();
    let distances = [0.0, 6.0, 50.0, 300.0, 700.0];
    let both = Both::new(&string, &distances, &SurfaceProfile::Rise(1.0));
    let bit = BitTorque {
        torque_static: 1500.0,
        torque_dynamic: 1000.0,
        decay_speed: 0.0,
    };
    let friction = PipeFriction {
        torque_static: 600.0,
        torque_dynamic: 400.0,
        stribeck_speed: 0.3,
    };
    for rubs in [false, true] {
        let scene = Scene {
            friction: match rubs {
                true => vec![Some(friction); distances.len()],
                false => Vec::new(),
            },
            ..both.scene(&[2], 0.3, Some(bit))
        };
        let [taps, mesh] = both.followed(&scene);
        let [positions, speeds] = apart([&taps.1, &mesh.1], 1.5);
        assert!(positions < 1e-6 && speeds < 1e-6, "{positions} {speeds}");
        let regimes = [&taps.0, &mesh.0].map(|outcome| outcome.torsion().unwrap().regime);
        assert_eq!(regimes[0], regimes[1]);
        assert!(mesh.1.bit_torque.iter().any(|torque| *torque == -1000.0));
    }
}
