//! From a sweep to its rows: each method's linear system built once, every
//! case stepped against it on all cores.

mod case;
mod systems;

pub use case::{Case, Row, RowOutcome};
pub use systems::{MethodSystem, is_unstable};

use rayon::prelude::*;

/// Runs every case with every method. Rows come in the order of `cases`, the
/// methods of a case together, whatever the number of threads. `tick` hears of
/// every one that is done.
pub fn run_cases(systems: &[MethodSystem], cases: &[Case], tick: impl Fn() + Sync) -> Vec<Row> {
    let methods = systems.len();
    (0..cases.len() * methods)
        .into_par_iter()
        .with_max_len(1)
        .map(|index| {
            let row = systems[index % methods].run(&cases[index / methods]);
            tick();
            row
        })
        .collect()
}
