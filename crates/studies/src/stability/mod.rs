//! The atlas of failures: every method in settings that strain it, what its
//! positive-real margin predicts before anything is simulated, and what
//! simulations then show.
//!
//! Positive-realness is what makes a string stable against *every* passive load.
//! A margin below zero promises that some load draws energy from it, not that
//! each does. So every cell meets two kinds of load: ordinary scenes, a bit that
//! is held, stick-slip, whirl, and one oscillator without loss, tuned to where
//! the margin is smallest (`sim::oscillator`). A cell is unstable if any of them
//! shows a symptom; a cell predicted stable is right only if none does.

mod bending;
mod families;
mod joints;
mod loads;
mod sticking;
mod verdict;
mod whirl;

pub use families::{Cell, Family, cells};
pub use verdict::{Findings, Symptom, explanation};

use anyhow::{Context, Result};
use rayon::prelude::*;

use crate::scenes::Loss;
use families::Approach;
use joints::Joints;

/// A cell and what it shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The cell.
    pub cell: Cell,
    /// What it shows.
    pub findings: Findings,
}

/// Runs cells on all cores; `done` is called after each.
///
/// # Errors
/// Where a scene or a linear system cannot be built.
pub fn run(cells: &[Cell], loss: Loss, done: &(dyn Fn() + Sync)) -> Result<Vec<Entry>> {
    let has_joints = cells.iter().any(|cell| cell.family == Family::Joints);
    let joints = has_joints.then(|| Joints::new(loss)).transpose()?;
    let groups: Vec<&[Cell]> = cells.chunk_by(Cell::shares_responses).collect();
    let found: Vec<Result<Vec<Findings>>> = (groups.par_iter().with_max_len(1))
        .map(|group| {
            let findings = examine(group, loss, joints.as_ref())?;
            group.iter().for_each(|_| done());
            Ok(findings)
        })
        .collect();
    let found = found.into_iter().collect::<Result<Vec<_>>>()?.concat();
    let entries = cells.iter().copied().zip(found);
    Ok(entries
        .map(|(cell, findings)| Entry { cell, findings })
        .collect())
}

/// Cells of the same responses.
fn examine(group: &[Cell], loss: Loss, joints: Option<&Joints>) -> Result<Vec<Findings>> {
    let Approach::Method(method) = group[0].approach else {
        return group.iter().map(bending::chain).collect();
    };
    match group[0].family {
        Family::Stiffness | Family::Sites | Family::LongWhirl => {
            whirl::examine(group, method, loss)
        }
        Family::Tail => (group.iter())
            .map(|cell| bending::tail(cell, method, loss))
            .collect(),
        Family::Joints => {
            let joints = joints.context("the string with joints is there")?;
            (group.iter())
                .map(|cell| joints.examine(cell, method))
                .collect()
        }
        _ => (group.iter())
            .map(|cell| sticking::examine(cell, method, loss))
            .collect(),
    }
}
