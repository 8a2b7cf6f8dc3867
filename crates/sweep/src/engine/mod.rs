//! From a sweep to its rows: each distinct string's linear systems built once,
//! every case stepped against them on all cores.

mod case;
mod log;
mod memory;
mod shard;
mod survey;
mod systems;
mod terms;

pub use case::{Case, Row, RowOutcome};
pub use log::{Header, Log, LogError, LogView, Place, Record, log_place, read_about, read_header};
pub use memory::StringMemory;
pub use shard::Shard;
pub use survey::{Survey, setting_of, survey};
pub use systems::{MethodSystem, is_unstable};
pub use terms::Terms;

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use anyhow::Result;
use rayon::prelude::*;
use sim::Stopping;

use crate::spec::Sweep;

/// One case in so many is followed to its end even if it settles, to count how
/// often that was wrong.
const CHECKED_PART: usize = 16;

/// The part of a sweep that is to be run.
pub struct Work<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    /// Which of its cases.
    pub shard: Shard,
    /// On which terms.
    pub terms: Terms,
    /// Distinct strings that are built at once.
    pub strings_at_once: usize,
    /// Which pairs of case and method (by its place in the sweep's list) are
    /// not done yet.
    pub is_open: &'a (dyn Fn(usize, usize) -> bool + Sync),
    /// Whether to begin no further case.
    pub stops: &'a (dyn Fn() -> bool + Sync),
}

/// How many pairs of case and method a part of a sweep has.
pub fn pairs_of(sweep: &Sweep, shard: Shard) -> usize {
    let strings = sweep.design.strings();
    let cases = (0..strings).map(|string| {
        let cases = sweep.design.cases_of_string(string).len();
        (0..cases)
            .filter(|&position| shard.has(strings, string, cases, position))
            .count()
    });
    cases.sum::<usize>() * sweep.methods.len()
}

/// The linear systems of one string, or why it has none.
struct Built<'a> {
    string: usize,
    systems: Result<&'a [MethodSystem], &'a str>,
}

impl Work<'_> {
    /// Runs every open pair of case and method, in about the order of the cases,
    /// and hands each row to `keep`; its first error ends the work. `base` is
    /// the system of the string as the sweep file says it.
    ///
    /// # Errors
    /// What `keep` returned.
    pub fn run(
        &self,
        base: &[MethodSystem],
        keep: &(dyn Fn(Row) -> Result<()> + Sync),
    ) -> Result<()> {
        let strings = self.sweep.design.strings();
        if !self.sweep.design.varies_string() {
            let systems = Ok(base);
            return self.run_batch(&[Built { string: 0, systems }], keep);
        }
        let batch = self.strings_at_once;
        for first in (0..strings).step_by(batch) {
            let systems: Vec<_> = (first..strings.min(first + batch))
                .into_par_iter()
                .filter(|&string| self.has_open_case(string))
                .map(|string| (string, self.build(string)))
                .collect();
            let built: Vec<Built> = (systems.iter())
                .map(|(string, systems)| Built {
                    string: *string,
                    systems: systems.as_deref().map_err(String::as_str),
                })
                .collect();
            self.run_batch(&built, keep)?;
            if (self.stops)() {
                break;
            }
        }
        Ok(())
    }

    fn has_open_case(&self, string: usize) -> bool {
        let cases = self.sweep.design.cases_of_string(string);
        !(self.stops)()
            && (0..cases.len()).any(|position| {
                let methods = 0..self.sweep.methods.len();
                methods
                    .into_iter()
                    .any(|method| self.wants(string, position, cases.get(position), method))
            })
    }

    fn wants(&self, string: usize, position: usize, case: usize, method: usize) -> bool {
        let design = &self.sweep.design;
        let (strings, cases) = (design.strings(), design.cases_of_string(string).len());
        self.shard.has(strings, string, cases, position) && (self.is_open)(case, method)
    }

    fn build(&self, string: usize) -> Result<Vec<MethodSystem>, String> {
        let setting = survey::setting_of(self.sweep, string).map_err(|error| error.to_string())?;
        let longest = survey::of_string(self.sweep, &setting, string)?.longest;
        MethodSystem::build_all(self.sweep, &setting.for_labels(), longest)
            .map_err(|error| format!("{error:#}"))
    }

    /// Threads take the next pair each until none is left, so that no thread is
    /// idle while another has a queue.
    fn run_batch(&self, built: &[Built], keep: &(dyn Fn(Row) -> Result<()> + Sync)) -> Result<()> {
        let methods = self.sweep.methods.len();
        let mut ends = Vec::with_capacity(built.len());
        let mut total = 0;
        for part in built {
            total += methods * self.sweep.design.cases_of_string(part.string).len();
            ends.push(total);
        }
        let next = AtomicUsize::new(0);
        let failed = AtomicBool::new(false);
        let failure = Mutex::new(None);
        rayon::broadcast(|_| {
            while !failed.load(Ordering::Relaxed) && !(self.stops)() {
                let index = next.fetch_add(1, Ordering::Relaxed);
                if index >= total {
                    break;
                }
                let part = ends.partition_point(|&end| end <= index);
                let start = if part == 0 { 0 } else { ends[part - 1] };
                let (position, method) = ((index - start) / methods, (index - start) % methods);
                if let Err(error) = self.run_pair(&built[part], position, method, keep) {
                    failed.store(true, Ordering::Relaxed);
                    if let Ok(mut failure) = failure.lock() {
                        failure.get_or_insert(error);
                    }
                }
            }
        });
        match failure.into_inner() {
            Ok(Some(error)) => Err(error),
            _ => Ok(()),
        }
    }

    /// Of the cases that may stop when they have settled, some are followed to
    /// the end.
    fn stopping(&self, case: usize) -> Stopping {
        if self.terms.full {
            Stopping::Full
        } else if case.is_multiple_of(CHECKED_PART) {
            Stopping::Checked
        } else {
            Stopping::Early
        }
    }

    fn run_pair(
        &self,
        built: &Built,
        position: usize,
        method: usize,
        keep: &(dyn Fn(Row) -> Result<()> + Sync),
    ) -> Result<()> {
        let index = self
            .sweep
            .design
            .cases_of_string(built.string)
            .get(position);
        if !self.wants(built.string, position, index, method) {
            return Ok(());
        }
        let row = built
            .systems
            .map_err(str::to_owned)
            .and_then(|systems| {
                let system = &systems[method];
                if let (Some(instability), false) =
                    (system.instability(), self.terms.allow_unstable)
                {
                    return Err(format!("{instability} (--allow-unstable simulates it)"));
                }
                let case = Case::of(self.sweep, &system.setting, index)?;
                Ok(system.run(&case, self.stopping(index)))
            })
            .unwrap_or_else(|reason| Row {
                case: index,
                method: self.sweep.methods[method].name(),
                values: self.sweep.design.values(index),
                torque_dynamic_nm: None,
                site_from_bit_m: None,
                outcome: RowOutcome::Failed(reason),
            });
        keep(row)
    }
}
