//! A torque law given as a closure steps as the built-in one does.

use linear::{Drillstring, Material, Method, Section, Sites, TorsionRequest, Tube};
use sim::laws::bit::BitMotion;
use sim::{BitTorque, Scene, SimulationError, Stopping, System, Timing, Trajectory};

const DURATION: f64 = 20.0;

fn responses(torque_inputs: Vec<usize>) -> linear::TorsionResponses {
    let steel = Material {
        shear_modulus: 80e9,
        density: 7840.0,
    };
    let parts = vec![Tube {
        length: 10.0,
        inner_radius: 0.05,
        outer_radius: 0.1,
    }];
    let sections = vec![Section { repeat: 50, parts }];
    let string = Drillstring::new(steel, sections, 1.0).unwrap();
    let request = TorsionRequest {
        sites: Sites::bit(),
        torque_inputs,
        sampling_frequency: 640.0,
        longest_time: DURATION,
    };
    linear::torsion_responses(&string, &Method::Quadrature, &request).unwrap()
}

#[test]
fn the_built_in_law_as_a_closure_gives_the_built_in_motion() {
    let responses = responses(vec![0]);
    let law = BitTorque {
        torque_static: 1200.0,
        torque_dynamic: 1000.0,
    };
    for surface_speed in [0.01, 0.5] {
        let mut motion = BitMotion::Stuck;
        let speeds = sim::bit_speeds(&responses, surface_speed, DURATION, |line| {
            let step = law.meet(motion, line.free_speed, line.compliance);
            motion = step.motion;
            step.torque
        })
        .unwrap();
        let scene = Scene {
            surface_speed,
            bit: Some(law),
            lateral: None,
            timing: Timing {
                duration: DURATION,
                closing_window: 5.0,
            },
        };
        let mut record = Trajectory::default();
        let system = System::new(&responses, DURATION).unwrap();
        sim::simulate(&system, &scene, Stopping::Full, Some(&mut record)).unwrap();
        let expected = &record.speeds[0];
        assert_eq!(speeds.len(), expected.len());
        let largest = expected
            .iter()
            .fold(0.0, |most: f64, speed| most.max(speed.abs()));
        assert!(largest > surface_speed);
        for (found, expected) in speeds.iter().zip(expected) {
            assert!(
                (found - expected).abs() < 1e-9 * largest,
                "{found} {expected}"
            );
        }
    }
}

#[test]
fn what_cannot_be_stepped_is_an_error() {
    let free = responses(vec![]);
    let found = sim::bit_speeds(&free, 1.0, 1.0, |_| 0.0);
    assert_eq!(found, Err(SimulationError::NoTorqueInput));
    let broken = |line: sim::LoadLine| if line.time > 0.5 { f64::NAN } else { 0.0 };
    let found = sim::bit_speeds(&responses(vec![0]), 1.0, 1.0, broken);
    assert!(
        matches!(found, Err(SimulationError::NotFinite { site: 0, time }) if (time - 0.5).abs() < 0.01)
    );
}
