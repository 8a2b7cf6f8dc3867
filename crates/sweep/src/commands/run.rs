//! `sweep run`: every case, every method, a results folder; from where the last
//! run of the same sweep stopped.

use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use anyhow::{Context, Result, anyhow, bail};
use linear::Method;

use super::folder::{Found, LOG, look};
use super::{
    Progress, Status, TELLS_JSON, UsageError, build_systems, complain, make_folder, read_sweep,
    results_folder, say, stop, survey_cases, use_threads, warn_of_unstable,
};
use crate::cli::{LogFormat, RunArguments};
use crate::engine::{
    Header, Log, MethodSystem, Record, Row, RowOutcome, Shard, Survey, Work, pairs_of,
};
use crate::output::{
    Boundary, Manifest, boundary, labels_row, meaning, write_atomically, write_boundary,
    write_tables,
};
use crate::spec::Sweep;

/// Runs a sweep.
pub fn run(arguments: &RunArguments) -> Result<Status> {
    let start = Instant::now();
    let tells_json = arguments.log == LogFormat::Json;
    TELLS_JSON.store(tells_json, std::sync::atomic::Ordering::Relaxed);
    use_threads(arguments.work.jobs)?;
    let sweep = read_sweep(
        &arguments.file,
        &arguments.work,
        arguments.full,
        arguments.quiet,
    )?;
    let shard = arguments.shard.unwrap_or(Shard::WHOLE);
    let survey = survey_cases(&arguments.file, &sweep)?;
    let mut folder = results_folder(arguments.out.as_ref(), &sweep);
    if arguments.out.is_none() && !shard.is_whole() {
        folder.push(format!("shard-{}-of-{}", shard.index, shard.of));
    }
    let header = Header::new(shard, meaning(&sweep, arguments.terms())?);
    let found = if arguments.fresh {
        Found::Nothing
    } else {
        look(&folder, &header, &sweep)?
    };
    if arguments.dry_run {
        say(&plan(&sweep, shard, &survey, &folder, &found)?)?;
        return Ok(Status::Complete);
    }
    if let Found::Complete(manifest) = found {
        return show_again(*manifest, &sweep, &folder, arguments.quiet);
    }
    let setting = sweep.setting.for_labels();
    let systems = build_systems(&arguments.file, &sweep, &setting, survey.longest)?;
    if !arguments.allow_unstable && !sweep.design.varies_string() {
        refuse_unstable(arguments, &sweep, &systems)?;
    }
    let limit = boundary(&sweep, &systems).map_err(UsageError)?;
    make_folder(&folder)?;
    let log = Arc::new(Log::open(
        &folder.join(LOG),
        &header,
        sweep.design.cases(),
        sweep.methods.len(),
        arguments.fresh,
    )?);
    if arguments.fresh {
        super::folder::clear(&folder)?;
    }
    tell_of_start(&log, &systems);
    let total = pairs_of(&sweep, shard);
    let progress = if tells_json {
        Progress::events(total, log.count())
    } else {
        Progress::new(total, log.count(), arguments.quiet)
    };
    let session = Session {
        arguments,
        sweep: &sweep,
        shard,
        systems: &systems,
        folder: &folder,
        start,
    };
    let place = folder.display().to_string();
    let so_far = move |done: usize| {
        format!(
            "{done} of {total} simulations are done and kept in {place}: the same command goes on"
        )
    };
    stop::before_end({
        let (log, progress, so_far) = (Arc::clone(&log), Arc::clone(&progress), so_far.clone());
        move || {
            progress.finish();
            log.close(|done| complain(&format!("stopped: {}", so_far(done))));
        }
    });
    let worked = session.simulate_open_cases(&log, &progress);
    progress.finish();
    let kept = log.sync();
    let with_so_far = |error: anyhow::Error| anyhow!("{error:#}; {}", so_far(log.count()));
    worked.map_err(with_so_far)?;
    kept.map_err(|error| with_so_far(error.into()))?;
    if log.count() < total
        && let Some(status) = stop::asked()
    {
        stop::end(status);
    }
    stop::before_end({
        let so_far = so_far(total);
        move || complain(&format!("stopped: {so_far}"))
    });
    session.finish(&limit, &log).map_err(with_so_far)
}

/// Refuses a method that chatters where a site sticks. Where axes change the
/// string, each string's own margin counts, and its cases fail.
fn refuse_unstable(
    arguments: &RunArguments,
    sweep: &Sweep,
    systems: &[MethodSystem],
) -> Result<()> {
    let found = systems.iter().enumerate();
    let first = found
        .filter_map(|(index, system)| Some((index, system, system.instability()?)))
        .next();
    let Some((index, system, instability)) = first else {
        return Ok(());
    };
    let remedy = match system.method {
        Method::Hilbert(_) => "take another method or a longer transform",
        Method::FiniteElement(_) => "take another method or a larger gamma",
        Method::Quadrature | Method::Trapezoidal | Method::DirectIdft(_) => "take another method",
    };
    let message = format!("{instability}; {remedy}, or give --allow-unstable");
    if arguments.work.methods.is_empty() {
        let key = format!("methods[{index}]");
        bail!(sweep.source.error(&key, message));
    }
    bail!(UsageError(format!("--methods: {message}")))
}

/// Says what is worth knowing before the work.
fn tell_of_start(log: &Log, systems: &[MethodSystem]) {
    warn_of_unstable(systems);
    if log.broken_lines() > 0 {
        complain(&format!(
            "warning: {} lines of the log were not whole; their cases are run again",
            log.broken_lines()
        ));
    }
}

/// A run of a sweep, or of a part of it, under way.
struct Session<'a> {
    arguments: &'a RunArguments,
    sweep: &'a Sweep,
    shard: Shard,
    systems: &'a [MethodSystem],
    folder: &'a Path,
    start: Instant,
}

impl Session<'_> {
    fn simulate_open_cases(&self, log: &Log, progress: &Progress) -> Result<()> {
        let (arguments, sweep) = (self.arguments, self.sweep);
        if arguments.fail_fast && log.failed() > 0 {
            bail!(
                "{} cases have no answer already (--fail-fast)",
                log.failed()
            );
        }
        let is_done = log.done();
        let places: Vec<&str> = sweep.methods.iter().map(|method| method.name()).collect();
        let keep = |row: Row| -> Result<()> {
            let reason = match &row.outcome {
                RowOutcome::Done(_) => None,
                RowOutcome::Failed(reason) => Some(reason.clone()),
            };
            log.append(&Record {
                case: row.case,
                method: places
                    .iter()
                    .position(|name| *name == row.method)
                    .unwrap_or(0),
                row: labels_row(sweep, &row),
                reason: reason.clone(),
            })?;
            progress.tick();
            match reason {
                Some(reason) if arguments.fail_fast => bail!(
                    "case {} by {} has no answer: {reason} (--fail-fast)",
                    row.case,
                    row.method
                ),
                _ => Ok(()),
            }
        };
        let work = Work {
            sweep,
            shard: self.shard,
            terms: arguments.terms(),
            is_open: &|case, method| !is_done(case, method),
            stops: &|| stop::asked().is_some(),
        };
        work.run(self.systems, &keep)
    }

    /// From the log to the results. The log goes last: as long as it is there, the
    /// same command does this again.
    fn finish(&self, limit: &Boundary, log: &Log) -> Result<Status> {
        let (arguments, sweep, shard, folder) =
            (self.arguments, self.sweep, self.shard, self.folder);
        let tally = write_tables(sweep, &arguments.file, log, folder)?;
        write_atomically(&folder.join("boundary.csv"), &write_boundary(limit)?)?;
        let seconds = self.start.elapsed().as_secs_f64();
        let manifest = Manifest::new(
            sweep,
            shard,
            arguments.terms(),
            self.systems,
            tally,
            seconds,
        )?;
        manifest.write(folder)?;
        let drawn = shard.is_whole() && super::plot::draw_map(folder)?;
        let path = folder.join(LOG);
        std::fs::remove_file(&path)
            .with_context(|| format!("{} cannot be removed", path.display()))?;
        if !arguments.quiet {
            say(&summary(&manifest, folder, drawn)?)?;
        }
        Ok(status_of(&manifest))
    }
}

/// A folder that is complete: nothing to run, but a title or a map may have
/// changed.
fn show_again(mut manifest: Manifest, sweep: &Sweep, folder: &Path, quiet: bool) -> Result<Status> {
    let shown = (&manifest.title, &manifest.map, &manifest.sweep);
    if shown != (&sweep.title, &sweep.map, &sweep.content) {
        manifest.title.clone_from(&sweep.title);
        manifest.map.clone_from(&sweep.map);
        manifest.sweep = sweep.content.clone();
        manifest.write(folder)?;
        if manifest.shard().is_whole() {
            super::plot::draw_map(folder)?;
        }
    }
    if !quiet {
        let text = summary(&manifest, folder, manifest.map.is_some())?;
        say(&format!("complete already, nothing to run\n{text}"))?;
    }
    Ok(status_of(&manifest))
}

fn status_of(manifest: &Manifest) -> Status {
    if manifest.tally.failed > 0 {
        Status::SomeFailed
    } else {
        Status::Complete
    }
}

fn plan(
    sweep: &Sweep,
    shard: Shard,
    survey: &Survey,
    folder: &Path,
    found: &Found,
) -> Result<String> {
    let mut text = String::new();
    let methods: Vec<&str> = sweep.methods.iter().map(|method| method.name()).collect();
    let total = pairs_of(sweep, shard);
    let done = match found {
        Found::Complete(_) => total,
        Found::Unfinished { done } => *done,
        Found::Nothing => 0,
    };
    writeln!(text, "{}: {}", sweep.name, sweep.title)?;
    let part = if shard.is_whole() {
        String::new()
    } else {
        format!(" (shard {shard}: {} cases)", total / methods.len())
    };
    writeln!(
        text,
        "would run {} cases by {} ({}){part}, into {}",
        sweep.design.cases(),
        methods.len(),
        methods.join(", "),
        folder.display()
    )?;
    let why = match found {
        Found::Complete(_) => "complete already",
        Found::Unfinished { .. } => "a stopped run goes on",
        Found::Nothing => "from the beginning",
    };
    writeln!(
        text,
        "{} of {total} simulations left: {why}",
        total - done.min(total)
    )?;
    if sweep.design.varies_string() {
        let strings = sweep.design.strings();
        writeln!(text, "{strings} distinct strings, each built once")?;
        if survey.impossible_strings > 0 {
            let impossible = survey.impossible_strings;
            writeln!(
                text,
                "{impossible} of them cannot be: their cases will fail"
            )?;
        }
    }
    writeln!(
        text,
        "simulated time {:.1} s for each method, the longest case {:.1} s, at {} Hz",
        survey.simulated, survey.longest, sweep.setting.sampling_frequency
    )?;
    if let Some(choice) = &sweep.choice {
        writeln!(text, "{choice}")?;
    }
    Ok(text)
}

/// What came out, in a few lines.
pub fn summary(manifest: &Manifest, folder: &Path, drawn: bool) -> Result<String> {
    let mut text = String::new();
    let rows = manifest.tally.rows;
    writeln!(
        text,
        "{}: {} cases by {} methods in {:.2} s",
        manifest.name,
        rows / manifest.methods.len().max(1),
        manifest.methods.len(),
        manifest.wall_seconds
    )?;
    if let Some(choice) = &manifest.accuracy {
        writeln!(text, "  {choice}")?;
    }
    for (method, labels) in &manifest.tally.labels {
        let counts: Vec<String> = labels
            .iter()
            .map(|(label, count)| format!("{count} {label}"))
            .collect();
        writeln!(text, "  {method}: {}", counts.join(", "))?;
    }
    if manifest.tally.failed > 0 {
        let failed = manifest.tally.failed;
        writeln!(text, "  {failed} of {rows} rows failed: see failures.csv")?;
    }
    if manifest.tally.settled_wrong > 0 {
        let (wrong, checked) = (manifest.tally.settled_wrong, manifest.tally.settled_checked);
        writeln!(
            text,
            "  {wrong} of {checked} settled cases that were followed to the end changed their \
             label: use --full"
        )?;
    }
    let map = if drawn { "map.svg, map.png, " } else { "" };
    writeln!(text, "{map}labels.csv and more are in {}", folder.display())?;
    Ok(text)
}
