//! A rigid wall where a step moves straight on and its law is met in the middle: both
//! ends of the step are on the wall, its middle on the chord between them.
//!
//! Were the middle held on the wall instead, the ends would go in and out by turns. On the
//! chord the wall does no work, for its force is across it.

use super::contact::{Approach, Contact, ContactError};
use super::wall::Wall;

/// The chord has converged where its distance from the centre changes by no more than
/// this part of the clearance. Each turn leaves a small part of the change before.
const SAME: f64 = 1e-13;

/// Turns after which it is given up.
const MOST_TURNS: usize = 100;

impl Wall {
    /// One step along a rigid wall: as along one at the distance of the chord, which
    /// is that of the direction found.
    pub(super) fn meet_along_chord(&self, approach: &Approach) -> Result<Contact, ContactError> {
        let [x, y] = approach.end_of_step(approach.free_position);
        if (x * x + y * y).sqrt() <= self.clearance {
            return Contact::free(approach.free_position);
        }
        let mut distance = self.chord(approach, approach.free_position);
        for _ in 0..MOST_TURNS {
            let at_chord = Wall {
                clearance: distance,
                ..*self
            };
            let contact = at_chord.meet_at(approach)?;
            let next = self.chord(approach, contact.position);
            if (next - distance).abs() <= SAME * self.clearance {
                return Ok(contact);
            }
            distance = next;
        }
        Err(ContactError::Unsolved)
    }

    /// Distance from the centre at which the site is, in a direction, in a step that ends
    /// on the wall: r with |r e − m p| = (1 − m) c for the position p before and the part
    /// m of the step.
    fn chord(&self, approach: &Approach, [x, y]: [f64; 2]) -> f64 {
        let ([px, py], moment) = (approach.previous_position, approach.moment);
        let length = (x * x + y * y).sqrt();
        let along = moment * (px * x + py * y) / length;
        let across = moment * (px * y - py * x) / length;
        let reach = (1.0 - moment) * self.clearance;
        along + ((reach - across) * (reach + across)).max(0.0).sqrt()
    }
}
