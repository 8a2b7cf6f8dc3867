//! The sum over past inputs (Eq. 17): nearly all the work of a simulation.
//!
//! [`Convolution`] is what simulations use; [`Kernel`] is the sum as it is written, the
//! reference that the other is held to.
//!
//! By blocks of transforms or term by term, the sum is the same:
//!
//! ```
//! use sim::convolution::{Convolution, Kernel, Kernels};
//!
//! let taps: Vec<f64> = (0..500).map(|step| (-0.01 * f64::from(step)).exp()).collect();
//! let inputs: Vec<f64> = (0..500).map(|step| (0.3 * f64::from(step)).sin()).collect();
//! let (kernel, kernels) = (Kernel::new(&taps), Kernels::new(&[vec![taps]])?);
//! let mut convolution = Convolution::new(&kernels, 1, inputs.len());
//! for (step, input) in inputs.iter().enumerate() {
//!     let mut sum = [0.0];
//!     convolution.past(&mut sum)?;
//!     assert!((sum[0] - kernel.past_sum(&inputs[..step])).abs() < 1e-12);
//!     convolution.push(&[*input])?;
//! }
//! # Ok::<(), linear::ResponseError>(())
//! ```

mod direct;
mod kernels;
pub(crate) mod partition;
mod partitioned;
mod past;

pub use direct::Kernel;
pub use kernels::Kernels;
pub use partitioned::Convolution;
