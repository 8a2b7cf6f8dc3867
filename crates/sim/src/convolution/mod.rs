//! The sum over past inputs (Eq. 17): nearly all the work of a simulation.
//!
//! [`partitioned`] is what simulations use; [`direct`] is the sum as it is
//! written, the reference that the other is held to.

pub mod direct;
pub mod partition;
pub mod partitioned;

pub use direct::Kernel;
pub use partitioned::{Convolution, Kernels};
