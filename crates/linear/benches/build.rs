//! Cost of building responses: `cargo bench -p drillstring-linear`.
#![allow(missing_docs, reason = "benchmarks are no interface")]

use divan::Bencher;
use linear::method::{FiniteElement, Transform};
use linear::{ChannelRequest, Drillstring, Method, Request, Section, Sites, Tube, responses};
use problems::academic;

fn main() {
    divan::main();
}

const METHODS: [&str; 4] = ["held", "quadrature", "hilbert", "finite-element"];

fn method(name: &str) -> Method {
    match name {
        "held" => Method::Held,
        "hilbert" => Method::Hilbert(Transform::default()),
        "finite-element" => Method::FiniteElement(FiniteElement::default()),
        _ => Method::Quadrature,
    }
}

/// From the torque at the bit, until it has decayed.
#[divan::bench(args = METHODS, sample_count = 5)]
fn torsion(bencher: Bencher, name: &str) {
    let (string, request) = (academic::string(), academic::bit_request(60.0));
    bencher.bench(|| responses(&string, &method(name), &request));
}

fn bending(bencher: Bencher, name: &str, distances: &[f64]) {
    let string = academic::string();
    let request = Request {
        channels: vec![academic::free_in_bending()],
        ..academic::lateral_request(&string, distances, 10.0)
    };
    bencher.bench(|| responses(&string, &method(name), &request));
}

/// Ten seconds of displacements at the bit.
#[divan::bench(args = METHODS, sample_count = 5)]
fn bending_one_site(bencher: Bencher, name: &str) {
    bending(bencher, name, &[0.0]);
}

/// Ten seconds of displacements at the three sites of Fig. 17.
#[divan::bench(args = METHODS, sample_count = 5)]
fn bending_three_sites(bencher: Bencher, name: &str) {
    bending(bencher, name, &[100.0, 50.0, 0.0]);
}

/// Three kilometres of jointed drillpipe and collars that ring for longer than the 16 s of a
/// case, as a sweep builds them anew for every case whose axes change the string.
fn light_string() -> Drillstring {
    let tube = |length, inner_radius, outer_radius| Tube {
        length,
        inner_radius,
        outer_radius,
    };
    let drillpipe = Section {
        repeat: 300,
        parts: vec![tube(9.05, 0.0543, 0.0635), tube(0.45, 0.0476, 0.0841)],
    };
    let collar = Section {
        repeat: 16,
        parts: vec![tube(9.5, 0.0381, 0.1143)],
    };
    let material = academic::string().material();
    Drillstring::new(material, vec![drillpipe, collar], 0.2)
        .unwrap_or_else(|error| unreachable!("{error}"))
}

const LIGHT_METHODS: [&str; 3] = ["held", "quadrature", "finite-element"];

/// Of such a string, on a separate thread.
fn light(bencher: Bencher, name: &str, channel: ChannelRequest) {
    let string = light_string();
    let request = Request {
        sites: Sites::bit(),
        channels: vec![channel],
        sampling_frequency: linear::estimates::sampling_frequency(&string),
        longest_time: 16.0,
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.unwrap_or_else(|error| unreachable!("{error}"));
    bencher.bench(|| pool.install(|| responses(&string, &method(name), &request)));
}

#[divan::bench(args = LIGHT_METHODS, sample_count = 9)]
fn light_string_in_torsion(bencher: Bencher, name: &str) {
    light(bencher, name, ChannelRequest::Torsion { torques: vec![0] });
}

#[divan::bench(args = LIGHT_METHODS, sample_count = 9)]
fn light_string_in_bending(bencher: Bencher, name: &str) {
    light(bencher, name, academic::free_in_bending());
}
