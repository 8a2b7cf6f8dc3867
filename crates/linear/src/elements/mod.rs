//! Finite elements of the string and their time integration (Section 3 of the
//! paper): a model that shares no equation with [`crate::waves`] beyond the
//! material's constants.

pub(crate) mod beam;
pub(crate) mod fading;
pub(crate) mod mesh;
mod moments;
pub mod newmark;
pub mod reconstruction;
pub(crate) mod recurrence;
pub mod reduction;
pub mod stepped;
pub(crate) mod torsion;

pub use crate::distributed_loss::error_of_drag;
