//! What methods are told apart by.

use linear::Method;
use linear::method::Transform;

/// The digital filter by a transform of this length, s.
pub fn hilbert(seconds: f64) -> Method {
    Method::Hilbert(Transform {
        seconds: Some(seconds),
    })
}

/// The parameters of a method, where it has them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// Newmark's γ.
    pub gamma: Option<f64>,
    /// Elements in one cell of a section.
    pub elements_per_cell: Option<usize>,
    /// Length of the transform, s, where one is given.
    pub transform_s: Option<f64>,
}

impl Parameters {
    /// Those of a method.
    pub fn of(method: &Method) -> Self {
        let elements = match method {
            Method::FiniteElement(elements) => Some(elements),
            _ => None,
        };
        Self {
            gamma: elements.map(|elements| elements.gamma),
            elements_per_cell: elements.map(|elements| elements.elements_per_cell),
            transform_s: match method {
                Method::Hilbert(transform) | Method::DirectIdft(transform) => transform.seconds,
                _ => None,
            },
        }
    }

    /// Those of what is no method that can simulate.
    pub fn none() -> Self {
        Self::of(&Method::Quadrature)
    }
}
