//! What is found at places of a string that bends.

/// What is found at places along a string.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaceQuantity {
    /// Displacements, m.
    Displacement,
    /// Bending moments, N m, the linear string's own: M = EI u″, positive where the string is bent
    /// towards positive displacements.
    Moment,
}
