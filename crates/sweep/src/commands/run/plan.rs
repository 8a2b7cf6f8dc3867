//! `sweep run --dry-run`: what would run, why, and what it would cost.

use std::path::Path;

use anyhow::Result;
use serde::Serialize;

use super::cheaper::cheaper;
use super::complete::damage;
use super::task::Task;
use crate::commands::cost::{WallTime, cost_lines, probe};
use crate::commands::folder::{FolderState, LOG, in_words};
use campaign::design::{Design, TraceDesign};
use campaign::engine::{finer_frequency, pairs_of};
use campaign::memory::{Estimate, Limit, Purpose, Size, admit};
use campaign::words::{counted, short, together, wrapped};
use results::folder::Damage;
use results::log::LogView;

/// What would run.
pub struct Plan<'a> {
    task: &'a Task<'a>,
    /// Simulations of all cases, or of the likely ones of a trace.
    total: usize,
    /// Those of them that are still to run.
    left: usize,
    /// Why that number.
    why: &'static str,
    /// What of a complete folder would be made again.
    damage: Vec<Damage>,
    /// None where nothing is left.
    cost: Option<Cost>,
}

/// What it would cost on this machine.
struct Cost {
    memory: Estimate,
    limit: Limit,
    time: WallTime,
}

impl<'a> Plan<'a> {
    /// What would run in a folder where this was `found`. A probe of what it costs ends sooner
    /// where it `stops`.
    ///
    /// # Errors
    /// Where it would take too much memory.
    pub fn of(task: &'a Task, found: &FolderState, stops: &dyn Fn() -> bool) -> Result<Self> {
        let sweep = &task.campaign.sweep;
        let total = if matches!(sweep.design, Design::Trace(_)) {
            sweep.design.likely_cases() * sweep.methods.len()
        } else {
            pairs_of(sweep, task.header.shard)
        };
        let (done, why) = match found {
            FolderState::Complete(manifest) => (total.max(manifest.tally.rows), "complete already"),
            FolderState::Unfinished { .. } => {
                let (cases, methods) = (sweep.design.cases(), sweep.methods.len());
                let log = LogView::open(&task.folder.join(LOG), cases, methods)?;
                (log.counts.done, "a stopped run continues")
            }
            FolderState::Fewer(manifest) => {
                let why = "the sweep has more cases than are there";
                (manifest.tally.rows, why)
            }
            FolderState::Nothing(_) => (0, "from the beginning"),
        };
        let left = total - done.min(total);
        let damage = match found {
            FolderState::Complete(manifest) => damage(task, manifest)?,
            _ => Vec::new(),
        };
        let cost = match left {
            0 => None,
            _ => Some(Cost::of(task, left, stops)?),
        };
        Ok(Self {
            task,
            total,
            left,
            why,
            damage,
            cost,
        })
    }

    /// In words.
    pub fn text(&self) -> String {
        let sweep = &self.task.campaign.sweep;
        let mut text = wrapped(&format!("{}: {}", sweep.name, sweep.title), 0, 2);
        text += &what_runs(self.task, self.total);
        let all = counted(self.total, "simulation");
        let is_trace = matches!(sweep.design, Design::Trace(_));
        let (left, why) = (self.left, self.why);
        let about = if is_trace && left > 0 { "perhaps " } else { "" };
        text += &format!("{about}{left} of {all} left: {why}\n");
        if !self.damage.is_empty() {
            text += &format!("would be made again: {}\n", in_words(&self.damage));
        }
        if sweep.design.varies_string() {
            text += &strings(self.task);
        }
        text += &times(self.task);
        if let Some(choice) = &sweep.choice {
            text += &choice.lines(0);
        }
        if let Some(Cost {
            memory,
            limit,
            time,
        }) = &self.cost
        {
            text += &(cost_lines(memory, limit, time) + &cheaper(sweep, time));
        }
        text
    }

    /// For programs.
    pub fn found(&self) -> PlanFound<'_> {
        let (sweep, survey) = (&self.task.campaign.sweep, &self.task.survey);
        let shard = self.task.header.shard;
        let cost = self.cost.as_ref();
        let time = cost.map(|cost| &cost.time);
        PlanFound {
            name: &sweep.name,
            title: &sweep.title,
            folder: &self.task.folder,
            methods: sweep.methods.iter().map(|method| method.name()).collect(),
            shard: (!shard.is_whole()).then(|| shard.to_string()),
            cases: sweep.design.cases(),
            likely_cases: sweep.design.likely_cases(),
            strings: sweep.design.strings(),
            invalid_strings: survey.impossible_strings,
            simulations: self.total,
            simulations_left: self.left,
            why: self.why,
            made_again: self.damage.iter().map(|it| &*it.words).collect(),
            sampling_frequency_hz: sweep.setting.sampling_frequency,
            simulated_time_s: simulated(self.task),
            longest_case_s: survey.longest,
            threads: linear::parallel::threads(),
            memory_bytes: cost.map(|cost| Size(cost.memory.bytes).whole_bytes()),
            memory_limit_bytes: cost.map(|cost| Size(cost.limit.bytes).whole_bytes()),
            wall_time_s: match time {
                Some(WallTime::About(seconds)) => Some(*seconds),
                _ => None,
            },
            never_finishes: match time {
                Some(WallTime::Refused(reason)) => Some(format!("{reason:#}")),
                _ => None,
            },
        }
    }
}

/// What would run, for programs; what it costs is null where nothing is left.
#[derive(Serialize)]
pub struct PlanFound<'a> {
    name: &'a str,
    title: &'a str,
    folder: &'a Path,
    methods: Vec<&'static str>,
    /// None of a whole sweep.
    shard: Option<String>,
    /// Of the whole sweep; of a trace, those of its grid.
    cases: usize,
    /// Of a trace, how many it may take; else, all.
    likely_cases: usize,
    strings: usize,
    invalid_strings: usize,
    /// By all methods, of the shard; of a trace, those of its likely cases.
    simulations: usize,
    simulations_left: usize,
    why: &'static str,
    /// What of a complete folder is missing or damaged.
    made_again: Vec<&'a str>,
    sampling_frequency_hz: f64,
    /// By each method.
    simulated_time_s: f64,
    longest_case_s: f64,
    threads: usize,
    /// At most.
    memory_bytes: Option<u64>,
    memory_limit_bytes: Option<u64>,
    /// None where the probe did not end in its time, too.
    wall_time_s: Option<f64>,
    /// Why the run would not finish.
    never_finishes: Option<String>,
}

impl Cost {
    fn of(task: &Task, simulations: usize, stops: &dyn Fn() -> bool) -> Result<Self> {
        let (arguments, sweep, survey) = (task.arguments, &task.campaign.sweep, &task.survey);
        let limit = arguments.work.memory.limit();
        let setting = sweep.setting.for_labels();
        Ok(Self {
            memory: admit(sweep, &setting, survey, Purpose::Labels, &limit)?,
            limit,
            time: probe(sweep, survey, arguments.options(), simulations, stops),
        })
    }
}

/// Cases, methods and folder.
fn what_runs(task: &Task, total: usize) -> String {
    let (sweep, shard) = (&task.campaign.sweep, task.header.shard);
    let methods: Vec<&str> = sweep.methods.iter().map(|method| method.name()).collect();
    let part = if shard.is_whole() {
        String::new()
    } else {
        let cases = counted(total / methods.len(), "case");
        format!(" (shard {shard}: {cases})")
    };
    let cases = match &sweep.design {
        Design::Trace(design) => traced(design),
        design => counted(design.cases(), "case"),
    };
    let methods = format!("{} ({})", methods.len(), methods.join(", "));
    let folder = together(&task.folder.display().to_string());
    let would = format!("would run {cases} by {methods}{part}, into {folder}");
    wrapped(&would, 0, 2)
}

/// What a trace chooses its cases from.
fn traced(design: &TraceDesign) -> String {
    let [x, y] = design.lattice.size();
    let scanned = design.lattice.places(0).count();
    format!(
        "a trace (from {scanned} cases on, perhaps {} of a grid of {x} × {y})",
        design.likely_cases()
    )
}

fn strings(task: &Task) -> String {
    let strings = counted(task.campaign.sweep.design.strings(), "distinct string");
    let mut text = format!("{strings}, each built once\n");
    let impossible = task.survey.impossible_strings;
    if impossible > 0 {
        text += &format!(
            "{impossible} strings are invalid; their cases will be recorded as \
                          failed\n"
        );
    }
    text
}

/// Time simulated by each method, s.
fn simulated(task: &Task) -> f64 {
    let design = &task.campaign.sweep.design;
    let part = design.likely_cases() as f64 / design.cases() as f64;
    part * task.survey.simulated
}

fn times(task: &Task) -> String {
    let (sweep, survey) = (&task.campaign.sweep, &task.survey);
    let certifying = sweep.certifying.map_or_else(String::new, |places| {
        let [one, other] = places.map(|place| {
            let method = &sweep.methods[place];
            let finer = short(finer_frequency(&sweep.setting.by(method), method));
            format!("{} at {finer} Hz", method.name())
        });
        format!(", and by {one} and {other}, to certify labels")
    });
    let words = format!(
        "simulated time {} s for each method, the longest case {} s, at {}{certifying}",
        short(simulated(task)),
        short(survey.longest),
        sweep.frequencies_in_words()
    );
    wrapped(&words, 0, 2)
}
