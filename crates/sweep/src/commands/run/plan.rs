//! `sweep run --dry-run`: what would run, why, and what it would cost.

use anyhow::Result;

use super::complete::damage;
use super::task::Task;
use crate::commands::cost::{Cost, probe};
use crate::commands::folder::{Found, LOG, in_words};
use crate::engine::{LogView, pairs_of};
use crate::memory::{Purpose, admit};
use crate::words::{counted, short, together, wrapped};

/// A run that has not begun.
pub struct Plan<'a> {
    /// What was asked for.
    pub task: &'a Task<'a>,
    /// What is there.
    pub found: &'a Found,
}

impl Plan<'_> {
    /// What would run. A probe of what it costs ends sooner where it `stops`.
    ///
    /// # Errors
    /// Where it would take too much memory.
    pub fn describe(&self, stops: &dyn Fn() -> bool) -> Result<String> {
        let sweep = &self.task.sweep;
        let total = pairs_of(sweep, self.task.shard);
        let done = match self.found {
            Found::Complete(_) => total,
            Found::Unfinished { .. } => {
                let log = self.task.folder.join(LOG);
                LogView::open(&log, sweep.design.cases(), sweep.methods.len())?
                    .counts
                    .done
            }
            Found::Fewer(manifest) => manifest.tally.rows,
            Found::Nothing(_) => 0,
        };
        let left = total - done.min(total);
        let mut text = self.words(total, left)?;
        if left > 0 {
            text += &self.cost(left, stops)?.to_string();
        }
        Ok(text)
    }

    fn cost(&self, simulations: usize, stops: &dyn Fn() -> bool) -> Result<Cost> {
        let Task {
            arguments,
            sweep,
            survey,
            ..
        } = self.task;
        let limit = arguments.work.memory.limit();
        let setting = sweep.setting.for_labels();
        let memory = admit(sweep, &setting, survey, Purpose::Labels, &limit)?;
        Ok(Cost {
            memory,
            limit,
            time: probe(sweep, survey, arguments.options(), simulations, stops),
        })
    }

    fn words(&self, total: usize, left: usize) -> Result<String> {
        let sweep = &self.task.sweep;
        let mut text = wrapped(&format!("{}: {}", sweep.name, sweep.title), 0, 2);
        text += &self.what_runs(total);
        text += &self.what_is_left(total, left)?;
        if sweep.design.varies_string() {
            text += &self.strings();
        }
        text += &self.times();
        if let Some(choice) = &sweep.choice {
            text += &choice.lines(0);
        }
        Ok(text)
    }

    /// Cases, methods and folder.
    fn what_runs(&self, total: usize) -> String {
        let (sweep, shard) = (&self.task.sweep, self.task.shard);
        let methods: Vec<&str> = sweep.methods.iter().map(|method| method.name()).collect();
        let part = if shard.is_whole() {
            String::new()
        } else {
            let cases = counted(total / methods.len(), "case");
            format!(" (shard {shard}: {cases})")
        };
        let cases = counted(sweep.design.cases(), "case");
        let methods = format!("{} ({})", methods.len(), methods.join(", "));
        let folder = together(&self.task.folder.display().to_string());
        let would = format!("would run {cases} by {methods}{part}, into {folder}");
        wrapped(&would, 0, 2)
    }

    /// How much is to do, and why.
    fn what_is_left(&self, total: usize, left: usize) -> Result<String> {
        let why = match self.found {
            Found::Complete(_) => "complete already",
            Found::Unfinished { .. } => "a stopped run goes on",
            Found::Fewer(_) => "the sweep has more cases than are there",
            Found::Nothing(_) => "from the beginning",
        };
        let total = counted(total, "simulation");
        let mut text = format!("{left} of {total} left: {why}\n");
        if let Found::Complete(manifest) = self.found {
            let damage = damage(self.task, manifest)?;
            if !damage.is_empty() {
                text += &format!("would be made again: {}\n", in_words(&damage));
            }
        }
        Ok(text)
    }

    fn strings(&self) -> String {
        let strings = counted(self.task.sweep.design.strings(), "distinct string");
        let mut text = format!("{strings}, each built once\n");
        let impossible = self.task.survey.impossible_strings;
        if impossible > 0 {
            text += &format!("{impossible} of them cannot be: their cases will fail\n");
        }
        text
    }

    fn times(&self) -> String {
        let (sweep, survey) = (&self.task.sweep, &self.task.survey);
        format!(
            "simulated time {} s for each method, the longest case {} s, at {} Hz\n",
            short(survey.simulated),
            short(survey.longest),
            short(sweep.setting.sampling_frequency)
        )
    }
}
