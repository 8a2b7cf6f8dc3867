//! The rounds of a traced design: which cases are wanted next follows from the labels of
//! those that are done, and from nothing else.

use std::sync::{Mutex, PoisonError};

use crate::design::TraceDesign;
use crate::records::Record;
use sim::{Labels, Motion, Outcome};

use crate::trace::{Class, Known, Lattice, Next, next};

/// What is known of a trace.
pub struct Rounds {
    seed: u64,
    known: Mutex<Known>,
}

impl Rounds {
    /// Nothing, of a trace by a number of methods.
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
        let labels = record
            .outcome
            .as_ref()
            .map(Outcome::labels)
            .unwrap_or_default();
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

/// Nothing is known yet of a trace by a number of methods.
pub fn nothing_known(lattice: Lattice, methods: usize) -> Known {
    Known::nothing(lattice, methods * Motion::ALL.len())
}

/// The layer of a motion by a method.
pub fn layer(method: usize, motion: Motion) -> usize {
    method * Motion::ALL.len() + motion as usize
}

/// Notes what a case is by a method.
pub fn note_labels(known: &mut Known, case: usize, method: usize, labels: Labels) {
    for motion in Motion::ALL {
        let class = match labels.is_sustained(motion) {
            Some(true) => Class::With,
            Some(false) => Class::Without,
            None => Class::Undetermined,
        };
        known.set(layer(method, motion), case, class);
    }
}
