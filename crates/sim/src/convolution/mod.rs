//! The sum over past inputs (Eq. 17): nearly all the work of a simulation.
//!
//! [`Convolution`] is what simulations use; [`Kernel`] is the sum as it is written, the
//! reference that the other is held to.

mod direct;
mod kernels;
pub(crate) mod partition;
mod partitioned;
mod past;

pub use direct::Kernel;
pub use kernels::Kernels;
pub use partitioned::Convolution;
