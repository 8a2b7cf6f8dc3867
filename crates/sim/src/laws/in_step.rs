//! The wall met in the middle of a step, through which the site moves straight on: the
//! force that does exactly the work which the wall stores (a discrete gradient: O. Gonzalez,
//! *Journal of Nonlinear Science* 6, 1996, 449–467).
//!
//! With V = ⅖ k_c δ^(5/2) the energy of an elastic wall and r₀, r₁ the distances from the
//! centre at both ends of the step, the force
//!
//! F_N = 2 r (V₁ − V₀)/(r₁² − r₀²)
//!
//! along the middle position, at distance r, does the work V₀ − V₁ on the site. A rigid wall
//! leaves the ends on it, the middle on the chord between them, and does none. Were the
//! depth of the middle taken instead, rattling would feed energy in, and along a rigid wall
//! the ends would go in and out in turn.
//!
//! The law is that of a wall met at the middle position itself, but closer to the centre:
//! how much so follows from the answer, and is found by the secant rule. Where that fails
//! the depth of the middle counts, and the step as ambiguous: it wants a higher f_s. Most steps continue
//! as the one before was; these are solved by Newton's method (`continued`).

mod continued;

use super::contact::{Approach, Contact, ContactError};
use super::wall::Wall;

/// The clearance of the wall in the place of this one has converged to this part of it.
const SAME: f64 = 1e-12;

/// Turns after which it is given up.
const MOST_TURNS: usize = 200;

impl Wall {
    /// One step of the site, the law met in its middle.
    pub(super) fn meet_in_step(&self, approach: &Approach) -> Result<Contact, ContactError> {
        let middle = approach.free_position;
        let is_free = length(approach.end_of_step(middle)) <= self.clearance;
        let came_free = length(approach.previous_position) <= self.clearance;
        if is_free && came_free {
            return Contact::free(middle);
        }
        if let Some(contact) = self.continues(approach) {
            return Ok(contact);
        }
        Ok(match self.work_of_wall(approach) {
            Some(contact) => contact,
            None => Contact {
                ambiguous: true,
                ..self.meet_at(approach)?
            },
        })
    }

    /// The answer whose force does the work of the wall; `None` where the secant rule does
    /// not find it, as where a step goes across the hole.
    fn work_of_wall(&self, approach: &Approach) -> Option<Contact> {
        let middle = approach.free_position;
        // As if both ends were as far out.
        let [x, y] = approach.previous_position;
        let along = (x * middle[0] + y * middle[1]) / length(middle);
        let mut clearance = self.clearance - length([x, y]) + along;
        let mut before: Option<(f64, f64)> = None;
        for _ in 0..MOST_TURNS {
            let (contact, next) = self.instead(approach, clearance).ok()?;
            let change = next - clearance;
            if change.abs() <= SAME * self.clearance {
                return Some(contact);
            }
            let secant = before.map(|(earlier, its_change)| {
                clearance - change * (clearance - earlier) / (change - its_change)
            });
            before = Some((clearance, change));
            clearance = secant.filter(|found| found.is_finite()).unwrap_or(next);
        }
        None
    }

    /// The answer with a wall of another clearance, and the clearance with which that wall
    /// would push as hard at this place as the law asks for.
    fn instead(&self, approach: &Approach, clearance: f64) -> Result<(Contact, f64), ContactError> {
        let contact = Wall { clearance, ..*self }.meet_at(approach)?;
        let radius = length(contact.position);
        let next = if self.stiffness == f64::INFINITY {
            self.chord(approach, contact.position)
        } else {
            let ends = [
                approach.previous_position,
                approach.end_of_step(contact.position),
            ];
            let force = self.mean_force(radius, ends.map(length));
            // The cube root takes less time than a power.
            radius - libm::cbrt(force / self.stiffness).powi(2)
        };
        Ok((contact, next))
    }

    /// F_N at a distance from the centre of the middle, from those of both ends, m.
    fn mean_force(&self, radius: f64, [before, after]: [f64; 2]) -> f64 {
        let depth = |end: f64| (end - self.clearance).max(0.0);
        let [one, other] = [depth(before).sqrt(), depth(after).sqrt()];
        // The difference of fifth powers over that of the squares, without cancellation.
        let steepness = if one > 0.0 && other > 0.0 {
            let fourths = one.powi(4) + other.powi(4);
            let mixed = one * other * (one * one + one * other + other * other);
            (fourths + mixed) / (one + other)
        } else if one == other {
            0.0
        } else {
            (other.powi(5) - one.powi(5)) / (after - before)
        };
        0.8 * self.stiffness * radius * steepness / (before + after)
    }

    /// Distance from the centre at which the site is, in a direction, in a step that ends
    /// on the wall: r with |r e − m p| = (1 − m) c for the position p before and the part
    /// m of the step that is still to go.
    fn chord(&self, approach: &Approach, [x, y]: [f64; 2]) -> f64 {
        let ([px, py], collocation_offset) = (
            approach.previous_position,
            approach.sampling.collocation_offset,
        );
        let length = length([x, y]);
        let along = collocation_offset * (px * x + py * y) / length;
        let across = collocation_offset * (px * y - py * x) / length;
        let reach = (1.0 - collocation_offset) * self.clearance;
        along + ((reach - across) * (reach + across)).max(0.0).sqrt()
    }
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests;
