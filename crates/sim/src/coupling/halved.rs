//! Turns of which half is taken, for ports that neither whole turns nor steps of Newton's method
//! bring together.
//!
//! Close together and with much friction, what a port answers to a change of another may be more than
//! that change, and against it: whole turns then go to and fro ever wider, where half of each comes
//! nearer. And a wall that a site meets from across the hole may have several answers (sliding one way,
//! the other, and rolling between them). Its law takes that nearest to where the site was before, and so
//! may jump from one to the other and back as the others answer in turn, each time with no answer left
//! where it was. Here a site keeps the answer that is nearest to its present one, which leads to the
//! folds between answers, from where Newton's method finds the one between.

use super::loads::Load;
use super::newton;
use super::ports::{Coupling, Free, Solved, Unloaded};
use crate::line::Torsion;

/// Turns after which ports that do not settle are given up.
const MOST_TURNS: usize = 600;

/// Turns from one attempt of Newton's method to the next.
const TURNS_BETWEEN: usize = 20;

/// Steps of an attempt.
const MOST_STEPS: usize = 30;

/// Continues from the loads so far. Gives whether the ports settled.
#[cold]
pub(super) fn settle<E>(
    coupling: &mut Coupling,
    torsion: &Torsion,
    free: Free,
    solve: &mut impl FnMut(usize, Unloaded) -> Result<Solved, E>,
) -> Result<bool, E> {
    coupling.keeps_answers = true;
    let settled = settle_keeping(coupling, torsion, free, solve);
    coupling.keeps_answers = false;
    settled
}

fn settle_keeping<E>(
    coupling: &mut Coupling,
    torsion: &Torsion,
    free: Free,
    solve: &mut impl FnMut(usize, Unloaded) -> Result<Solved, E>,
) -> Result<bool, E> {
    for turn in 1..=MOST_TURNS {
        for port in 0..coupling.pending.len() {
            let before = coupling.loads[port];
            let answer = solve(port, coupling.unloaded(port, free))?.load;
            coupling.replace(port, half_way(before, answer));
        }
        if turn % TURNS_BETWEEN != 0 {
            continue;
        }
        let begun = coupling.loads.clone();
        let mut steps = 0..MOST_STEPS;
        while steps.next().is_some() && newton::step(coupling, torsion, free, solve) {}
        if coupling.turn_all(free, solve)? {
            return Ok(true);
        }
        for (port, load) in begun.into_iter().enumerate() {
            coupling.set_load(port, load);
        }
    }
    Ok(false)
}

fn half_way(before: Load, answer: Load) -> Load {
    Load {
        force: [0, 1].map(|axis| 0.5 * (before.force[axis] + answer.force[axis])),
        torque: 0.5 * (before.torque + answer.torque),
    }
}
