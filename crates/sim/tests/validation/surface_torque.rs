//! What turns the surface while walls and rock hold the string back: against masses and springs,
//! which know of no response and no reciprocity.

use linear::{ChannelRequest, Method, Request, Sites};
use problems::masses::MassesAndSprings;
use problems::pipes;
use sim::{SurfaceProfile, SurfaceTorque, Trajectory};

const LENGTH: f64 = 1000.0;
const DAMPING: f64 = 0.5;
const TIME: f64 = 12.0;

/// Speed of the surface, and the time in which it is reached.
const SPEED: f64 = 8.0;
const RISE: f64 = 3.0;

/// Where torques act, m from the bit, and which, N m: pulses of a second that do not end at none.
const LOADED: [f64; 3] = [700.0, 250.0, 0.0];

fn torque_at(site: usize, time: f64) -> f64 {
    let (size, begin) = [(-900.0, 2.0), (500.0, 4.0), (-1500.0, 6.0)][site];
    0.5 * size * (1.0 + (4.0 * (time - begin)).tanh())
}

/// A uniform row as masses and springs in small steps; the torque at the surface at the times of a
/// sampling frequency.
fn masses_and_springs(frequency: f64) -> Vec<f64> {
    let (masses, substeps) = (800, (16_384.0 / frequency) as usize);
    let step = 1.0 / (frequency * substeps as f64);
    let mut row = MassesAndSprings::new(LENGTH, masses, step);
    let (inertia, drag) = (row.inertia, DAMPING * row.piece);
    let loads = LOADED.map(|from_bit| {
        let index = ((LENGTH - from_bit) / row.piece) as usize;
        index.min(masses - 1)
    });
    let (mut torques, mut angle) = (Vec::new(), 0.0);
    for index in 0..(frequency * TIME) as usize * substeps {
        let time = step * index as f64;
        let inside = row.torques(angle);
        if index % substeps == 0 {
            torques.push(inside[0]);
        }
        row.step(&inside, |mass, speed, torque| {
            let at_mass = (0..3).filter(|&site| loads[site] == mass);
            let loaded: f64 = at_mass.map(|site| torque_at(site, time)).sum();
            speed + step * (torque + loaded - drag * speed) / inertia
        });
        angle += step * SPEED * ((time + 0.5 * step) / RISE).min(1.0);
    }
    torques
}

/// R.m.s. error at a sampling frequency, in parts of the r.m.s. torque.
fn error(method: Method, frequency: f64) -> f64 {
    let string = pipes::row(100, DAMPING);
    let sites = Sites::new(&string, &LOADED).unwrap();
    let request = Request {
        sites,
        channels: vec![ChannelRequest::Torsion {
            torques: vec![0, 1, 2],
        }],
        sampling_frequency: frequency,
        longest_time: TIME,
    };
    let responses = linear::responses(&string, &method, &request).unwrap();
    let taps = linear::surface_torque(&string, &method, &request).unwrap();
    let profile = SurfaceProfile::Rise(RISE);
    let surface = SurfaceTorque::new(&responses, &taps, &profile, 0.0).unwrap();
    let times: Vec<f64> = (0..(frequency * TIME) as usize)
        .map(|step| (step as f64 + method.collocation_offset()) / frequency)
        .collect();
    let of_site = |site| times.iter().map(|&time| torque_at(site, time)).collect();
    // Of a wall that touches at the bit, too, half of the torque.
    let halved = |torques: Vec<f64>| -> Vec<f64> { torques.iter().map(|it| 0.5 * it).collect() };
    let motion = Trajectory {
        bit_torque: halved(of_site(2)),
        wall_torques: vec![of_site(0), of_site(1), halved(of_site(2))],
        times: times.clone(),
        ..Trajectory::default()
    };
    let found = surface.of(SPEED, &sim::Start::Rest, &motion);
    let fine = 1024.0;
    let exact = masses_and_springs(fine);
    let squares = times.iter().zip(found).map(|(time, found)| {
        let exact = exact[((time * fine) as usize).min(exact.len() - 1)];
        [(found - exact).powi(2), exact.powi(2)]
    });
    let [off, all] = squares.fold([0.0, 0.0], |[off, all], [a, b]| [off + a, all + b]);
    (off / all).sqrt()
}

#[test]
fn val_torques_along_the_string_turn_the_surface_as_masses_and_springs_say() {
    let methods = [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(Default::default()),
    ];
    for method in methods {
        let [coarse, fine] = [64.0, 256.0].map(|frequency| error(method, frequency));
        println!("{}: {coarse:.2e} {fine:.2e}", method.name());
        assert!(
            fine < 0.01 && fine < 0.6 * coarse,
            "{}: {coarse} {fine}",
            method.name()
        );
    }
}
