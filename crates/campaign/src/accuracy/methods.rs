//! What distinguishes methods.

use linear::Method;
use linear::method::Transform;

/// The digital filter by a transform of this length, s.
pub fn hilbert(seconds: f64) -> Method {
    Method::Hilbert(Transform {
        seconds: Some(seconds),
    })
}

/// The parameters of a method, where it has them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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
        match method {
            Method::FiniteElement(elements) => Self {
                gamma: Some(elements.gamma),
                elements_per_cell: Some(elements.elements_per_cell),
                transform_s: None,
            },
            Method::Hilbert(transform) | Method::DirectIdft(transform) => Self {
                transform_s: transform.seconds,
                ..Self::default()
            },
            _ => Self::default(),
        }
    }
}
