//! The rounds of a traced design: which cases are wanted next follows from the labels of
//! those that are done, and from nothing else.

use std::sync::{Mutex, PoisonError};

use crate::limits::{note_labels, nothing_known};
use crate::output::Labels;
use campaign::design::TraceDesign;
use campaign::engine::Record;
use campaign::trace::{Known, Next, next};

/// What is known of a trace.
pub struct Rounds {
    seed: u64,
    known: Mutex<Known>,
}

impl Rounds {
    /// Nothing, of a trace by so many methods.
    pub fn new(design: &TraceDesign, methods: usize) -> Self {
        Self {
            seed: design.seed,
            known: Mutex::new(nothing_known(design.lattice, methods)),
        }
    }

    fn known(&self) -> std::sync::MutexGuard<'_, Known> {
        // A class is set in one step.
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes a case that is done.
    pub fn note(&self, record: &Record) {
        let labels = record.outcome.as_ref().map(Labels::of).unwrap_or_default();
        note_labels(&mut self.known(), record.case, record.method, labels);
    }

    /// The cases that are wanted next, in ascending order; none where all is traced.
    pub fn wanted(&self) -> Option<Vec<usize>> {
        match next(&self.known(), self.seed) {
            Next::Wanted(cases) => Some(cases),
            Next::Done(_) => None,
        }
    }
}
