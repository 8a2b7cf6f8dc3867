//! Methods that a test is made for.

use linear::Method;

/// Those that step in time, as anyone has them.
pub fn in_time() -> [Method; 3] {
    [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(Default::default()),
    ]
}
