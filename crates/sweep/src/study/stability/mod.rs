//! The atlas of failures: every method in settings that strain it, what its
//! positive-real margin foretells before anything is simulated, and what
//! simulations then show.
//!
//! Positive-realness is what makes a string stable against *every* passive load.
//! A margin below zero promises that some load draws energy from it, not that
//! each does. So every cell meets two kinds of load: ordinary scenes, a bit that
//! is held, stick-slip, whirl, and one oscillator without loss, tuned to where
//! the margin is smallest (`sim::oscillator`). A cell is unstable if any of them
//! shows a symptom; a cell foretold stable is right only if none does.

mod bending;
mod chart;
mod families;
mod scenes;
mod sticking;
mod table;
mod verdict;
mod whirl;

pub use chart::chart;
pub use families::{Approach, Cell, Family, cells};
pub use table::{Entry, summary, to_csv};
pub use verdict::Findings;

use anyhow::Result;
use rayon::prelude::*;

/// Runs cells on all cores; `done` is called after each.
///
/// # Errors
/// Where a scene or a linear system cannot be built.
pub fn run(cells: Vec<Cell>, done: &(dyn Fn() + Sync)) -> Result<Vec<Entry>> {
    let scenes = scenes::Scenes::read()?;
    let entries: Vec<Result<Entry>> = (cells.into_par_iter().with_max_len(1))
        .map(|cell| {
            let findings = examine(&scenes, &cell)?;
            done();
            Ok(Entry { cell, findings })
        })
        .collect();
    entries.into_iter().collect()
}

fn examine(scenes: &scenes::Scenes, cell: &Cell) -> Result<Findings> {
    match (cell.family, cell.approach) {
        (Family::Tail, Approach::Method(method)) => bending::tail(scenes, cell, method),
        (_, Approach::TransferProducts | Approach::JoinedStiffnesses) => {
            bending::chain(scenes, cell)
        }
        (Family::Stiffness | Family::Sites | Family::LongWhirl, Approach::Method(method)) => {
            whirl::examine(scenes, cell, method)
        }
        (_, Approach::Method(method)) => sticking::examine(scenes, cell, method),
    }
}
