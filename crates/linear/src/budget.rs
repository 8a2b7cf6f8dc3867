//! Memory that is asked for before it is taken.
//!
//! A builder has two steps. Its plan knows every length, and asks a [`Budget`] for the bytes of its
//! buffers in one function; building asks in the same function, and then allocates. A dry run is
//! the first step alone: what it took of a budget at most is what building takes at most, for the
//! sizes are written once, next to the buffers that have them.
//!
//! Bytes are floating-point numbers: they do not overflow, however much is asked for.
//!
//! ```
//! use linear::budget::{Budget, What};
//!
//! let budget = Budget::new(1e6);
//! let cases = budget.reserve(8e5, What::Cases)?;
//! assert_eq!(budget.reserve(5e5, What::Responses).map_err(|it| it.left).err(), Some(2e5));
//! drop(cases);
//! assert!(budget.reserve(5e5, What::Responses).is_ok());
//! // A dry run asks for all that, and takes nothing: this is what it would have needed.
//! assert_eq!(budget.need().peak, 8e5);
//! # Ok::<(), linear::budget::OutOfBudget>(())
//! ```

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use thiserror::Error;

/// Bytes of a real number.
pub const REAL: f64 = 8.0;
/// Bytes of a complex number.
pub const COMPLEX: f64 = 16.0;

/// What memory is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum What {
    /// Impulse responses, and the spectra that they are made of.
    Responses,
    /// Responses of the pieces of a string.
    Pieces,
    /// Finite elements, and the motion of all of them.
    Elements,
    /// Spectra for the positive-real margin of responses.
    Margin,
    /// What the past of a case is summed with, and other series that all cases share.
    Simulator,
    /// Cases that are stepped, with what is recorded of them.
    Cases,
    /// The program itself, its tables and pictures.
    Program,
}

/// A builder asked for more than is left.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("{asked:.3e} bytes are needed for {what}, and {left:.3e} are left")]
pub struct OutOfBudget {
    /// What for.
    pub what: What,
    /// Bytes asked for.
    pub asked: f64,
    /// Bytes that were left.
    pub left: f64,
}

/// Memory that builders may take, and have taken. What they keep stays taken for as long as the
/// budget lasts.
#[derive(Debug)]
pub struct Budget {
    allowed: f64,
    /// Together with the budget that this is a part of.
    taken: Arc<Mutex<Taken>>,
    /// What is kept of this part.
    kept: Mutex<f64>,
}

#[derive(Debug, Clone, Copy, Default)]
struct Taken {
    now: f64,
    most: f64,
}

/// Memory that a piece of work takes, bytes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Need {
    /// The most while it is done, what it keeps included.
    pub peak: f64,
    /// What is left of it then.
    pub kept: f64,
}

/// Bytes taken of a budget, which are given back when this is dropped.
#[derive(Debug)]
#[must_use = "what is dropped is given back"]
pub struct Reserved<'a> {
    budget: &'a Budget,
    bytes: f64,
}

/// Memory of a piece of work that is being done: dropped before it is done, all is given back.
#[derive(Debug)]
#[must_use = "what is dropped is given back"]
pub struct Working<'a> {
    kept: Reserved<'a>,
    scratch: Reserved<'a>,
}

impl Budget {
    /// Of a number of bytes.
    pub fn new(allowed: f64) -> Self {
        Self {
            allowed,
            taken: Arc::default(),
            kept: Mutex::default(),
        }
    }

    /// Without a limit.
    pub fn unlimited() -> Self {
        Self::new(f64::INFINITY)
    }

    /// The same budget for what goes before all is done: what is kept of this part is given back
    /// when the part is dropped.
    #[must_use]
    pub fn part(&self) -> Self {
        Self {
            allowed: self.allowed,
            taken: Arc::clone(&self.taken),
            kept: Mutex::default(),
        }
    }

    /// Takes a number of bytes.
    ///
    /// # Errors
    /// Where they are more than is left.
    pub fn reserve(&self, bytes: f64, what: What) -> Result<Reserved<'_>, OutOfBudget> {
        let mut taken = self.lock();
        let left = self.allowed - taken.now;
        if bytes > left {
            let asked = bytes;
            return Err(OutOfBudget { what, asked, left });
        }
        taken.now += bytes;
        taken.most = taken.most.max(taken.now);
        Ok(Reserved {
            budget: self,
            bytes,
        })
    }

    /// Takes what a piece of work needs.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn begin(&self, need: Need, what: What) -> Result<Working<'_>, OutOfBudget> {
        let kept = self.reserve(need.kept, what)?;
        let scratch = self.reserve((need.peak - need.kept).max(0.0), what)?;
        Ok(Working { kept, scratch })
    }

    /// Takes what a piece of work needs for as long as it is done, and what it keeps from then on.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn pass(&self, need: Need, what: What) -> Result<(), OutOfBudget> {
        self.begin(need, what).map(Working::done)
    }

    /// The most that was taken so far, and what is taken now.
    pub fn need(&self) -> Need {
        let taken = self.lock();
        Need {
            peak: taken.most,
            kept: taken.now,
        }
    }

    fn lock(&self) -> MutexGuard<'_, Taken> {
        locked(&self.taken)
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Drop for Budget {
    fn drop(&mut self) {
        let kept = *locked(&self.kept);
        self.lock().now -= kept;
    }
}

impl Need {
    /// What is taken and kept.
    pub fn lasting(bytes: f64) -> Self {
        Self {
            peak: bytes,
            kept: bytes,
        }
    }

    /// What is taken and given back.
    pub fn passing(bytes: f64) -> Self {
        Self {
            peak: bytes,
            kept: 0.0,
        }
    }

    /// A number of such pieces of work at the same time.
    pub fn times(self, count: usize) -> Self {
        Self {
            peak: count as f64 * self.peak,
            kept: count as f64 * self.kept,
        }
    }

    /// Both pieces of work at the same time.
    pub fn and(self, other: Self) -> Self {
        Self {
            peak: self.peak + other.peak,
            kept: self.kept + other.kept,
        }
    }

    /// This, and then the other.
    pub fn then(self, other: Self) -> Self {
        Self {
            peak: self.peak.max(self.kept + other.peak),
            kept: self.kept + other.kept,
        }
    }
}

impl Reserved<'_> {
    /// Keeps it for as long as the budget lasts.
    pub fn keep(mut self) {
        *locked(&self.budget.kept) += self.bytes;
        self.bytes = 0.0;
    }

    /// Both together, of one budget.
    pub(crate) fn and(mut self, mut other: Self) -> Self {
        self.bytes += std::mem::take(&mut other.bytes);
        self
    }

    /// Gives back what is more than a number of bytes.
    fn shrink(&mut self, bytes: f64) {
        let less = (self.bytes - bytes).max(0.0);
        self.budget.lock().now -= less;
        self.bytes -= less;
    }
}

impl Drop for Reserved<'_> {
    fn drop(&mut self) {
        self.budget.lock().now -= self.bytes;
    }
}

impl<'a> Working<'a> {
    /// The work is done: its scratch is given back.
    pub fn done(self) {
        self.kept.keep();
    }

    /// What is kept, which is no more than was thought; scratch is given back.
    pub fn kept(self, bytes: f64) -> Reserved<'a> {
        let Self { mut kept, scratch } = self;
        drop(scratch);
        kept.shrink(bytes);
        kept
    }
}

impl std::fmt::Display for What {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Responses => "impulse responses",
            Self::Pieces => "the pieces of the string",
            Self::Elements => "finite elements",
            Self::Margin => "the margin of responses",
            Self::Simulator => "what all cases share",
            Self::Cases => "the cases",
            Self::Program => "the program",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scratch_is_given_back_and_what_is_kept_stays() {
        let budget = Budget::new(100.0);
        let need = |peak, kept| Need { peak, kept };
        budget.pass(need(90.0, 30.0), What::Responses).unwrap();
        assert_eq!(budget.need(), need(90.0, 30.0));
        let working = budget.begin(need(60.0, 20.0), What::Pieces).unwrap();
        let refused = budget.reserve(11.0, What::Margin).unwrap_err();
        let expected = OutOfBudget {
            what: What::Margin,
            asked: 11.0,
            left: 10.0,
        };
        assert_eq!(refused, expected);
        working.kept(5.0).keep();
        assert_eq!(budget.need(), need(90.0, 35.0));
    }

    /// Nothing of it stays taken.
    #[test]
    fn work_that_fails_gives_all_back() {
        let budget = Budget::new(100.0);
        drop(budget.begin(Need::lasting(70.0), What::Elements));
        let too_large = Need {
            peak: 120.0,
            kept: 50.0,
        };
        assert!(budget.begin(too_large, What::Elements).is_err());
        assert_eq!(budget.need().kept, 0.0);
        budget.reserve(100.0, What::Cases).unwrap().keep();
        assert_eq!(budget.need(), Need::lasting(100.0));
    }

    #[test]
    fn what_is_kept_of_a_part_is_given_back_with_it() {
        let budget = Budget::new(100.0);
        budget.reserve(10.0, What::Pieces).unwrap().keep();
        let part = budget.part();
        part.pass(Need::lasting(60.0), What::Responses).unwrap();
        assert!(budget.reserve(40.0, What::Margin).is_err());
        drop(part);
        let (peak, kept) = (70.0, 10.0);
        assert_eq!(budget.need(), Need { peak, kept });
    }
}
