//! The layers of what is known of a trace: a motion by a method each.

use crate::output::{Labels, Motion};
use campaign::trace::{Class, Known, Lattice};

/// Nothing is known yet of a trace by so many methods.
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
            None => Class::Untold,
        };
        known.set(layer(method, motion), case, class);
    }
}
