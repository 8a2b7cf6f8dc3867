//! Cost of building responses of the paper's string: `cargo bench -p linear`.
#![allow(missing_docs, reason = "benchmarks are no interface")]

use divan::Bencher;
use linear::method::{FiniteElement, Transform};
use linear::{Method, Request, responses};
use problems::academic;

fn main() {
    divan::main();
}

const METHODS: [&str; 3] = ["quadrature", "hilbert", "finite-element"];

fn method(name: &str) -> Method {
    match name {
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
