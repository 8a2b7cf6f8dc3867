//! Poles that are stepped against the taps of the same poles, whose convolution shares no line with them.

use linear::{
    Budget, Drillstring, Method, PolePlan, Request, Section, Sites, SurfaceSupport, responses,
};
use linear::{ChannelRequest, Responses};
use problems::academic::{self, BENDING, SAMPLING_FREQUENCY, tube};
use sim::{EccentricMass, Lateral, Scene, Simulator, Stopping, System, Timing, Trajectory, Wall};

const DURATION: f64 = 6.0;

/// Whirl of masses out of balance on five sites of jointed collars that are held by none, or by springs.
fn positions(simulator: &Simulator) -> Vec<Vec<[f64; 2]>> {
    let wall = Wall {
        clearance: 0.01,
        stiffness: 1e9,
        friction: 0.4,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    };
    let mass = |site| EccentricMass {
        site,
        mass: 200.0,
        offset: 0.05,
    };
    let scene: Scene = Scene {
        start: sim::Start::Rest,
        surface_speed: 15.0,
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: Some(Lateral {
            walls: vec![wall; 5],
            impulses: Vec::new(),
            eccentric_masses: vec![mass(1), mass(4)],
            lying: None,
            shocks: None,
        }),
        timing: Timing {
            duration: DURATION,
            closing_window: 2.0,
        },
    };
    let mut motion = Trajectory::default();
    let outcome = simulator
        .simulate(&scene, Stopping::Full, Some(&mut motion))
        .unwrap();
    assert!(outcome.lateral().unwrap().contact_fraction > 0.1);
    motion.positions
}

#[test]
fn val_poles_that_are_stepped_move_as_their_taps_do() {
    let section = Section {
        repeat: 6,
        parts: vec![tube(9.0, 0.1), tube(1.0, 0.12)],
    };
    let string = Drillstring::new(academic::string().material(), vec![section], 10.0).unwrap();
    let distances = [40.0, 30.0, 20.0, 9.0, 0.0];
    for springs in [0.0, 1e6] {
        let sites = Sites::new(&string, &distances).unwrap();
        let sites = match springs {
            0.0 => sites,
            spring => sites.held_by(vec![spring; 5]).unwrap(),
        };
        let support = SurfaceSupport::Pinned;
        let in_torsion = ChannelRequest::Torsion {
            torques: (0..5).collect(),
        };
        let in_bending = ChannelRequest::Bending {
            bending: BENDING,
            support,
        };
        let by = |channels: Vec<ChannelRequest>| -> Responses {
            let request = Request {
                sites: sites.clone(),
                channels,
                sampling_frequency: SAMPLING_FREQUENCY,
                longest_time: DURATION,
            };
            responses(&string, &Method::Poles, &request).unwrap()
        };
        let plan = PolePlan::new(&string, (&BENDING, support), &sites, SAMPLING_FREQUENCY);
        let poles = plan.unwrap().build(&Budget::unlimited()).unwrap();
        let turning = System::new(&by(vec![in_torsion.clone()])).unwrap();
        let stepped = Simulator::of(turning.bending_by_poles(&poles, &sites).unwrap());
        let by_taps = Simulator::new(&by(vec![in_torsion, in_bending])).unwrap();
        let [stepped, by_taps] = [positions(&stepped), positions(&by_taps)];
        // Contact makes much of rounding after a while.
        let early = (1.5 * SAMPLING_FREQUENCY) as usize;
        let mut most = 0.0f64;
        for (one, other) in stepped.iter().zip(&by_taps) {
            for ([x, y], [u, v]) in one.iter().zip(other).take(early) {
                most = most.max((x - u).hypot(y - v));
            }
        }
        assert!(most < 1e-9, "{springs}: {most} m");
    }
}
