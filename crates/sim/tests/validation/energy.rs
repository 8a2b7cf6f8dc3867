//! Energy in contact: what the wall gives back is no more than it took, and the
//! discrete string gives back no more than was fed in, however long it rattles.

use linear::method::FiniteElement;
use linear::{Bending, ChannelRequest, Method, Request, Sites, SurfaceSupport, responses};
use problems::{academic, pipes};
use sim::{Impulse, Lateral, Scene, Simulator, Stopping, Timing, Trajectory, Wall};

const SAMPLING_FREQUENCY: f64 = 640.0;
const STEPS: usize = 100_000;

/// Sixty pushes from all sides keep the string rattling.
fn impulse(index: u32) -> Impulse {
    Impulse {
        site: 0,
        amount: 500.0,
        start: 0.1 + 2.5 * f64::from(index),
        duration: 0.02,
        direction: 0.4 + 2.4 * f64::from(index),
    }
}

/// A short string without lateral damping.
fn rattle(method: &Method, wall: Wall, sampling_frequency: f64, steps: usize) -> Trajectory {
    let string = pipes::row(4, 10.0);
    let bending = Bending {
        damping: 0.0,
        ..academic::BENDING
    };
    let duration = steps as f64 / sampling_frequency;
    let support = SurfaceSupport::Pinned;
    let request = Request {
        sites: Sites::bit(),
        channels: vec![
            ChannelRequest::Torsion { torques: vec![0] },
            ChannelRequest::Bending { bending, support },
        ],
        sampling_frequency,
        longest_time: duration,
    };
    let simulator = Simulator::new(&responses(&string, method, &request).unwrap()).unwrap();
    let scene = Scene {
        start: sim::Start::Rest,
        surface_speed: 6.3,
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: Some(Lateral {
            walls: vec![wall],
            impulses: (0..60).map(impulse).collect(),
            eccentric_masses: vec![],
            lying: None,
            shocks: None,
        }),
        timing: Timing {
            duration,
            closing_window: 2.0,
        },
    };
    let mut trajectory = Trajectory::default();
    let simulated = simulator.simulate(&scene, Stopping::Full, Some(&mut trajectory));
    simulated.unwrap();
    trajectory
}

const WALL: Wall = Wall {
    clearance: 0.015,
    stiffness: 1e9,
    friction: 0.0,
    dynamic_ratio: 1.0,
    stribeck_speed: 0.0,
    radius: 0.15,
};

/// Positions at the ends of steps: where a step's motion is taken `offset` of it before its
/// end, it moves straight on to that.
fn ends(trajectory: &Trajectory, offset: f64) -> Vec<[f64; 2]> {
    let ends = trajectory.positions[0].iter().scan([0.0; 2], |end, now| {
        *end = [0, 1].map(|axis| (now[axis] - offset * end[axis]) / (1.0 - offset));
        Some(*end)
    });
    ends.collect()
}

/// Running sums of force times displacement between positions: by the wall on the string,
/// and by all forces on the string.
fn works(trajectory: &Trajectory, positions: &[[f64; 2]]) -> (Vec<f64>, Vec<f64>) {
    let (mut wall, mut all) = (0.0, 0.0);
    let mut before = [0.0; 2];
    (0..positions.len())
        .map(|step| {
            for axis in 0..2 {
                let moved = positions[step][axis] - before[axis];
                wall += trajectory.wall_forces[0][step][axis] * moved;
                all += trajectory.forces[axis][0][step] * moved;
            }
            before = positions[step];
            (wall, all)
        })
        .unzip()
}

fn touches(trajectory: &Trajectory) -> usize {
    let forces = &trajectory.wall_forces[0];
    forces
        .windows(2)
        .filter(|pair| pair[0] == [0.0; 2] && pair[1] != [0.0; 2])
        .count()
}

#[test]
fn val_rattling_for_ever_gains_no_energy() {
    for method in [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(FiniteElement::default()),
    ] {
        for stiffness in [1e9, f64::INFINITY] {
            let trajectory = rattle(
                &method,
                Wall { stiffness, ..WALL },
                SAMPLING_FREQUENCY,
                STEPS,
            );
            assert!(
                touches(&trajectory) > 100,
                "{}: {}",
                method.name(),
                touches(&trajectory)
            );
            let positions = ends(&trajectory, method.collocation_offset());
            let (wall, all) = works(&trajectory, &positions);
            let fed_in = all
                .iter()
                .zip(&wall)
                .map(|(all, wall)| all - wall)
                .fold(0.0, f64::max);
            for (step, (wall, all)) in wall.iter().zip(&all).enumerate() {
                let [x, y] = positions[step];
                let depth = (x.hypot(y) - WALL.clearance).max(0.0);
                let stored = if stiffness.is_finite() {
                    0.4 * stiffness * depth.powf(2.5)
                } else {
                    0.0
                };
                // The wall gives back at most what it took and does not store.
                assert!(wall + stored <= 1e-9 * fed_in, "{} {step}", method.name());
                // The string never gives out more than it was given.
                assert!(*all >= -1e-6 * fed_in, "{} {step}: {all}", method.name());
            }
        }
    }
}

/// The part of the energy of the first impact that does not come back.
fn lost_at_first_impact(sampling_frequency: f64) -> f64 {
    let steps = (0.5 * sampling_frequency) as usize;
    let soft = Wall {
        stiffness: 1e7,
        ..WALL
    };
    let trajectory = rattle(&Method::Quadrature, soft, sampling_frequency, steps);
    let (wall, _) = works(&trajectory, &trajectory.positions[0]);
    let mut forces = trajectory.wall_forces[0].iter();
    let touched = forces.position(|force| *force != [0.0; 2]).unwrap();
    let left = touched + forces.position(|force| *force == [0.0; 2]).unwrap();
    let deepest = wall[touched..=left].iter().copied().fold(0.0, f64::min);
    wall[left] / deepest
}

/// Nothing but the discretisation takes energy where nothing dissipates: the
/// smaller the step, the more of an impact comes back.
#[test]
fn val_what_leaves_the_string_at_an_impact_comes_back() {
    let lost = [640.0, 1280.0, 2560.0, 5120.0].map(lost_at_first_impact);
    assert!(lost.windows(2).all(|pair| pair[1] < pair[0]), "{lost:?}");
    assert!(lost[3] < 0.05 && lost[3] >= 0.0, "{lost:?}");
}

#[test]
fn val_friction_takes_energy_at_the_contact_and_gives_none() {
    for (dynamic_ratio, stribeck_speed) in [(1.0, 0.0), (0.3, 0.0), (0.3, 0.5)] {
        friction_takes_energy(Wall {
            friction: 0.6,
            dynamic_ratio,
            stribeck_speed,
            ..WALL
        });
    }
}

fn friction_takes_energy(wall: Wall) {
    let trajectory = rattle(&Method::Quadrature, wall, SAMPLING_FREQUENCY, 20_000);
    let mut before = [0.0; 2];
    let mut dissipated = 0.0;
    for (step, &position) in trajectory.positions[0].iter().enumerate() {
        let [x, y] = position;
        let radius = x.hypot(y);
        let force = trajectory.wall_forces[0][step];
        if force != [0.0; 2] {
            let tangent = [-y / radius, x / radius];
            let friction = force[0] * tangent[0] + force[1] * tangent[1];
            let moved =
                (position[0] - before[0]) * tangent[0] + (position[1] - before[1]) * tangent[1];
            let sliding = WALL.radius * trajectory.speeds[0][step] + moved * SAMPLING_FREQUENCY;
            let power = friction * sliding;
            let scale = friction.abs() * (WALL.radius * trajectory.speeds[0][step].abs() + 1.0);
            assert!(power <= 1e-9 * scale, "{step}: {power}");
            dissipated -= power;
        }
        before = position;
    }
    assert!(dissipated > 0.0);
}
