//! What is tried, in the order of its cost.

use linear::Method;
use linear::method::{FiniteElement, Transform};

use crate::plan::Candidate;
use crate::studies::methods::Parameters;

/// Sampling frequencies, Hz. The last is for the reference alone.
pub const FREQUENCIES: [f64; 11] = [
    20.0, 40.0, 80.0, 160.0, 320.0, 640.0, 1280.0, 2560.0, 5120.0, 10240.0, 20480.0,
];

/// At one frequency, by the cost of building: the quadrature takes four samples of the
/// waves a tap; finite elements take a step of the whole mesh a tap; the digital
/// filter needs taps for as long as the response lasts twice, and memory for them in
/// every case.
pub fn methods() -> [Method; 5] {
    let elements = |elements_per_cell| {
        Method::FiniteElement(FiniteElement {
            elements_per_cell,
            ..FiniteElement::default()
        })
    };
    [
        Method::Quadrature,
        elements(2),
        elements(5),
        elements(20),
        Method::Hilbert(Transform::default()),
    ]
}

/// A method at a frequency, as it is told.
pub fn candidate(method: &Method, frequency: f64) -> Candidate {
    Candidate {
        method: method.name().to_owned(),
        elements_per_cell: Parameters::of(method).elements_per_cell,
        sampling_frequency_hz: frequency,
    }
}
