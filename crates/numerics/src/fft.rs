//! Plans of Fourier transforms of real sequences.
//!
//! The sines of a plan take nearly as long as a transform. A thread keeps its last plans, for
//! strings that change from case to case ask for the same lengths again.
//!
//! ```
//! use numerics::fft;
//!
//! let plan = fft::forward(8);
//! let mut samples = vec![1.0; 8];
//! let mut spectrum = plan.make_output_vec();
//! plan.process(&mut samples, &mut spectrum)?;
//! assert_eq!(spectrum[0].re, 8.0);
//! assert!(spectrum[1..].iter().all(|it| it.norm() < 1e-12));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::cell::RefCell;
use std::collections::VecDeque;
use std::sync::Arc;

use realfft::RealFftPlanner;
pub use realfft::{ComplexToReal, RealToComplex};

/// The samples of all plans that a thread keeps, in each direction: some ten megabytes.
const MOST_KEPT: usize = 1 << 19;

/// The last plans of a thread in one direction, by their lengths, the latest first.
struct Kept<T: ?Sized>(VecDeque<(usize, Arc<T>)>);

impl<T: ?Sized> Kept<T> {
    const fn none() -> RefCell<Self> {
        RefCell::new(Self(VecDeque::new()))
    }

    /// The plan of a length, made where it is not kept.
    fn of(&mut self, length: usize, plan: impl FnOnce() -> Arc<T>) -> Arc<T> {
        let known = self.0.iter().position(|(kept, _)| *kept == length);
        let latest = known.and_then(|place| self.0.remove(place));
        let (_, plan) = latest.unwrap_or_else(|| (length, plan()));
        self.0.push_front((length, Arc::clone(&plan)));
        let mut samples = 0;
        self.0.retain(|(length, _)| {
            samples += length;
            samples <= MOST_KEPT
        });
        plan
    }
}

thread_local! {
    static FORWARD: RefCell<Kept<dyn RealToComplex<f64>>> = const { Kept::none() };
    static INVERSE: RefCell<Kept<dyn ComplexToReal<f64>>> = const { Kept::none() };
}

/// The transform of a number of real values; not scaled.
pub fn forward(length: usize) -> Arc<dyn RealToComplex<f64>> {
    let plan = || RealFftPlanner::new().plan_fft_forward(length);
    FORWARD.with_borrow_mut(|kept| kept.of(length, plan))
}

/// Its inverse, `length` times too large.
pub fn inverse(length: usize) -> Arc<dyn ComplexToReal<f64>> {
    let plan = || RealFftPlanner::new().plan_fft_inverse(length);
    INVERSE.with_borrow_mut(|kept| kept.of(length, plan))
}
