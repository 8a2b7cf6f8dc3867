//! All ports in a row brought nearer at once.

use super::ports::{Coupling, Free};
use crate::line::Chain;

/// Turns after which ports are no longer brought nearer all at once: where some are about to
/// break loose or to be caught, that may throw them to and fro.
const MOST_CORRECTIONS: usize = 20;

/// A step of Newton's method for all ports that turn, as their laws fall with speed there:
/// equations of a port and its neighbours, solved from the surface down and back.
pub(super) fn correct(coupling: &mut Coupling, chain: &Chain, free: Free, turn: usize) {
    if turn > MOST_CORRECTIONS {
        return;
    }
    let (loads, row) = (&coupling.loads, &mut coupling.row);
    let mut above = (0.0, 0.0);
    for (port, load) in loads.iter().enumerate() {
        row.changes[port] = match row.falls[port] {
            None => (0.0, 0.0),
            Some(fall) => {
                let cross = if port > 0 { chain.next[port - 1] } else { 0.0 };
                let pivot = chain.own[port] - fall - cross * above.0;
                let left = free.turning[port] + load.torque - chain.taken(port, &row.speeds);
                let next = chain.next.get(port).copied().unwrap_or(0.0);
                (next / pivot, (left - cross * above.1) / pivot)
            }
        };
        above = row.changes[port];
    }
    let mut below = 0.0;
    for (speed, (share, own)) in row.speeds.iter_mut().zip(&row.changes).rev() {
        below = own - share * below;
        // What would turn round is left to its law.
        if below.is_finite() && (*speed + below) * *speed > 0.0 {
            *speed += below;
        }
    }
}
