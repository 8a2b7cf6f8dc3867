//! Cases of a list, run for their labels alone: those of a reference, and their neighbours.

use std::path::Path;

use anyhow::Result;

use super::prepare::{build_systems, survey_cases};
use super::progress::Progress;
use super::terminal::Terminal;
use super::warnings::warn_of_unstable;
use campaign::Campaign;
use campaign::design::{Design, List};
use campaign::engine::{Keep, MethodSystem, RunOptions, Shard, Work};
use campaign::memory::{Limit, Purpose, admit};
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::records::Record;

/// A sweep with a list of cases, and what they are run with.
pub struct Listed {
    /// The sweep.
    pub sweep: Sweep,
    /// The linear system of each of its methods.
    pub systems: Vec<MethodSystem>,
    strings_at_once: usize,
}

impl Listed {
    /// A sweep with other cases, `listed` in a file, along its own axes.
    ///
    /// # Errors
    /// Where a case is refused, or they take more memory than the limit.
    pub fn new(
        sweep: Sweep,
        cases: Vec<Vec<f64>>,
        listed: &Path,
        limit: &Limit,
        terminal: Terminal,
    ) -> Result<Self> {
        let axes = sweep.design.axes().to_vec();
        let weight_pushes = sweep.changes_string(Axis::WeightOnBitKn);
        let campaign = Campaign {
            sweep: Sweep {
                design: Design::List(List::new(axes, cases, weight_pushes)),
                ..sweep
            },
        };
        let survey = survey_cases(listed, &campaign)?;
        let Campaign { sweep } = campaign;
        let setting = sweep.setting.for_labels();
        let memory = admit(&sweep, &setting, &survey, Purpose::Labels, limit)?;
        let systems = build_systems(sweep.source.file(), &sweep, &setting, survey.longest)?;
        warn_of_unstable(&systems, terminal);
        Ok(Self {
            strings_at_once: memory.strings_at_once,
            sweep,
            systems,
        })
    }

    /// Runs the pairs of case and method that are open when their turn comes.
    ///
    /// # Errors
    /// What `keep` returned.
    pub fn run(
        &self,
        is_open: &(dyn Fn(usize, usize) -> bool + Sync),
        keep: Keep,
        terminal: Terminal,
    ) -> Result<()> {
        let pairs = self.sweep.design.cases() * self.systems.len();
        let progress = Progress::new(pairs, 0, false, terminal);
        let work = Work {
            sweep: &self.sweep,
            shard: Shard::WHOLE,
            options: RunOptions {
                full: false,
                allow_unstable: true,
            },
            strings_at_once: self.strings_at_once,
            is_open,
            stops: &|| false,
        };
        let kept = |record: Record| {
            progress.tick();
            keep(record)
        };
        work.run(&self.systems, &kept)?;
        progress.finish();
        Ok(())
    }
}
