//! From a sweep to its records: each distinct string's linear systems built once,
//! every case stepped against them on all cores.
//!
//! ```
//! use campaign::engine::Shard;
//!
//! // Parts of a sweep for several machines: each of nine cases of one string is in one of four.
//! let parts = ["0/4", "1/4", "2/4", "3/4"].into_iter().map(str::parse::<Shard>);
//! let parts = parts.collect::<Result<Vec<_>, _>>()?;
//! for case in 0..9 {
//!     let having = parts.iter().filter(|part| part.has(1, 0, 9, case));
//!     assert_eq!(having.count(), 1);
//! }
//! assert!("4/4".parse::<Shard>().is_err());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod along;
mod answer;
mod case;
mod case_error;
mod choice;
mod clearances;
mod dry_run;
mod finding;
mod finer;
mod follow;
mod front;
#[cfg(test)]
mod fuzz;
mod idle_axis;
mod instability;
mod limit;
mod limited;
mod longer;
mod memory;
mod nearby;
mod poles;
mod rubbing;
mod run_options;
mod shard;
mod simulation;
mod stepped;
mod stopwatch;
mod stress;
mod survey;
mod system_plan;
mod systems;
mod timing;
mod tools;
mod whole_string;

pub use answer::answer;
pub use case::Case;
pub use case_error::CaseError;
pub use choice::{CaseChoice, ChoiceError, ChosenCase, common_setting};
pub use clearances::{Beyond, Clearances};
pub use finer::finer_frequency;
pub use follow::FollowedMethod;
pub use idle_axis::unused_reason;
pub use instability::{Instability, is_unstable};
pub use limit::{LimitPoint, stick_slip_limit};
pub use memory::StringMemory;
pub use run_options::RunOptions;
pub use shard::Shard;
pub use simulation::Simulation;
pub use stopwatch::Stopwatch;
pub use survey::{Survey, longest_of_string, setting_of, survey};
pub use systems::{Basis, MethodSystem, Recipe, add_finer, compare_fronts};
pub use timing::is_by_rule;
pub use whole_string::{reconstructed, whole_string};

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use anyhow::Result;
use linear::parallel;

use crate::design::Design;
use crate::plan::Sweep;
use crate::records::{Failure, Record};

/// What becomes of a record.
pub type Keep<'a> = &'a (dyn Fn(Record) -> Result<()> + Sync);

/// The part of a sweep that is to be run.
pub struct Work<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    /// Which of its cases.
    pub shard: Shard,
    /// How its cases are simulated.
    pub options: RunOptions,
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
    let cases = (0..sweep.design.strings()).flat_map(|string| {
        let cases = sweep.design.cases_of_string(string);
        (0..cases).filter(move |&position| is_in(shard, &sweep.design, string, position))
    });
    cases.count() * sweep.methods.len()
}

/// Whether a part of a sweep has the case at a position among those of a string.
fn is_in(shard: Shard, design: &Design, string: usize, position: usize) -> bool {
    // Of a string that more cases do not change, so that each stays where it is.
    let strings = match design {
        Design::Sensitivity(_) if design.varies_string() => usize::MAX,
        _ => design.strings(),
    };
    shard.has(strings, string, design.cases_of_string(string), position)
}

/// Whether a part of a sweep has a case.
pub fn has_case(shard: Shard, design: &Design, case: usize) -> bool {
    if shard.is_whole() {
        return true;
    }
    let string = design.string_of(case);
    let mut positions = 0..design.cases_of_string(string);
    let position = positions.find(|&position| design.case_of_string(string, position) == case);
    position.is_some_and(|position| is_in(shard, design, string, position))
}

/// The linear system of each method for one string, or why it has none.
struct Built<'a> {
    string: usize,
    systems: Vec<Result<&'a MethodSystem, &'a CaseError>>,
}

impl Work<'_> {
    /// Runs every open pair of case and method, in about the order of the cases,
    /// and hands the record to `keep`; its first error ends the work. `base` is the
    /// system of the string as the sweep file says it.
    ///
    /// # Errors
    /// What `keep` returned.
    pub fn run(&self, base: &[MethodSystem], keep: Keep) -> Result<()> {
        let strings = self.sweep.design.strings();
        if !self.sweep.design.varies_string() {
            let systems = base.iter().map(Ok).collect();
            return self.run_batch(&[Built { string: 0, systems }], keep);
        }
        let batch = self.strings_at_once;
        for first in (0..strings).step_by(batch) {
            let systems = parallel::map(batch.min(strings - first), 1, |place| {
                let string = first + place;
                (self.has_open_case(string)).then(|| (string, self.build(string, base)))
            });
            let built: Vec<Built> = (systems.iter().flatten())
                .map(|(string, systems)| Built {
                    string: *string,
                    systems: (0..self.sweep.methods.len())
                        .map(|method| systems.as_ref()?[method].as_ref())
                        .collect(),
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
        let design = &self.sweep.design;
        let is_open = |position| {
            let case = design.case_of_string(string, position);
            let mut methods = 0..self.sweep.methods.len();
            methods.any(|method| self.wants(string, position, case, method))
        };
        !(self.stops)() && (0..design.cases_of_string(string)).any(is_open)
    }

    fn wants(&self, string: usize, position: usize, case: usize, method: usize) -> bool {
        is_in(self.shard, &self.sweep.design, string, position) && (self.is_open)(case, method)
    }

    fn build(
        &self,
        string: usize,
        base: &[MethodSystem],
    ) -> Result<Vec<Result<MethodSystem, CaseError>>, CaseError> {
        let setting = setting_of(self.sweep, string)?;
        let longest = survey::of_string(self.sweep, &setting, string)?.longest;
        let systems = Recipe::build_each(self.sweep, &setting.for_labels(), longest, base);
        let finer = |(method, system): (usize, Result<MethodSystem>)| {
            let system = system.and_then(|system| system.with_finer(self.sweep, method, longest));
            system.map_err(CaseError::Responses)
        };
        Ok(systems.into_iter().enumerate().map(finer).collect())
    }

    /// Threads take the next pair each until none is left, so that no thread is
    /// idle while another has a queue.
    fn run_batch(&self, built: &[Built], keep: Keep) -> Result<()> {
        let methods = self.sweep.methods.len();
        let mut ends = Vec::with_capacity(built.len());
        let mut total = 0;
        for part in built {
            total += methods * self.sweep.design.cases_of_string(part.string);
            ends.push(total);
        }
        let next = AtomicUsize::new(0);
        let failure = OnceLock::new();
        parallel::on_each_thread(|| {
            while failure.get().is_none() && !(self.stops)() {
                let index = next.fetch_add(1, Ordering::Relaxed);
                if index >= total {
                    break;
                }
                let part = ends.partition_point(|&end| end <= index);
                let start = if part == 0 { 0 } else { ends[part - 1] };
                let (position, method) = ((index - start) / methods, (index - start) % methods);
                if let Err(error) = self.run_pair(&built[part], position, method, keep) {
                    // The first one is reported.
                    let _ = failure.set(error);
                }
            }
        });
        failure.into_inner().map_or(Ok(()), Err)
    }

    fn run_pair(&self, built: &Built, position: usize, method: usize, keep: Keep) -> Result<()> {
        let index = (self.sweep.design).case_of_string(built.string, position);
        if !self.wants(built.string, position, index, method) {
            return Ok(());
        }
        let record = match built.systems[method] {
            Ok(system) => Case::of(self.sweep, &system.setting, index)
                .map(|case| answer(system, &case, method, self.options, self.sweep))
                .map_err(Failure::new),
            Err(reason) => Err(Failure::new(reason)),
        };
        keep(record.unwrap_or_else(|reason| {
            let values = self.sweep.design.values(index);
            Record::failed(index, method, values, reason)
        }))
    }
}
