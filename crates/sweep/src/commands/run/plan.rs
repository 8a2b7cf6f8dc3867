//! `sweep run --dry-run`: what would run, why, and what it would cost.

use anyhow::Result;

use super::cheaper::cheaper;
use super::complete::damage;
use super::task::Task;
use crate::commands::cost::{cost_lines, probe};
use crate::commands::folder::{FolderState, LOG, in_words};
use campaign::design::{Design, TraceDesign};
use campaign::engine::{finer_frequency, pairs_of};
use campaign::memory::{Purpose, admit};
use campaign::words::{counted, short, together, wrapped};
use results::log::LogView;

/// What would run in a folder where so much was `found`. A probe of what it costs ends
/// sooner where it `stops`.
///
/// # Errors
/// Where it would take too much memory.
pub fn describe(task: &Task, found: &FolderState, stops: &dyn Fn() -> bool) -> Result<String> {
    let sweep = &task.campaign.sweep;
    let is_trace = matches!(sweep.design, Design::Trace(_));
    let total = if is_trace {
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
    let mut text = wrapped(&format!("{}: {}", sweep.name, sweep.title), 0, 2);
    text += &what_runs(task, total);
    let all = counted(total, "simulation");
    let about = if is_trace && left > 0 { "perhaps " } else { "" };
    text += &format!("{about}{left} of {all} left: {why}\n");
    if let FolderState::Complete(manifest) = found {
        let damage = damage(task, manifest)?;
        if !damage.is_empty() {
            text += &format!("would be made again: {}\n", in_words(&damage));
        }
    }
    if sweep.design.varies_string() {
        text += &strings(task);
    }
    text += &times(task);
    if let Some(choice) = &sweep.choice {
        text += &choice.lines(0);
    }
    if left > 0 {
        text += &cost(task, left, stops)?;
    }
    Ok(text)
}

fn cost(task: &Task, simulations: usize, stops: &dyn Fn() -> bool) -> Result<String> {
    let (arguments, sweep, survey) = (task.arguments, &task.campaign.sweep, &task.survey);
    let limit = arguments.work.memory.limit();
    let setting = sweep.setting.for_labels();
    let memory = admit(sweep, &setting, survey, Purpose::Labels, &limit)?;
    let time = probe(sweep, survey, arguments.options(), simulations, stops);
    Ok(cost_lines(&memory, &limit, &time) + &cheaper(sweep, &time))
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

fn times(task: &Task) -> String {
    let (sweep, survey) = (&task.campaign.sweep, &task.survey);
    let design = &sweep.design;
    let part = design.likely_cases() as f64 / design.cases() as f64;
    let frequency = sweep.setting.sampling_frequency;
    let certifying = sweep.certifying.map_or_else(String::new, |places| {
        let [one, other] = places.map(|place| {
            let method = &sweep.methods[place];
            let finer = short(finer_frequency(&sweep.setting, method));
            format!("{} at {finer} Hz", method.name())
        });
        format!(", and by {one} and {other}, to certify labels")
    });
    let words = format!(
        "simulated time {} s for each method, the longest case {} s, at {} Hz{certifying}",
        short(part * survey.simulated),
        short(survey.longest),
        short(frequency)
    );
    wrapped(&words, 0, 2)
}
