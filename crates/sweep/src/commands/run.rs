//! `sweep run`: every case, every method, a results folder; from where the last
//! run of the same sweep stopped.

mod plan;

use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use anyhow::{Context, Result, anyhow, bail};
use linear::Method;

use super::complete::Again;
use super::folder::{Found, LOG, hold, look, remove_page};
use super::plot::draw_and_note;
use super::raise::{log_of_results, raise_log};
use super::{
    Progress, Status, TELLS_JSON, UsageError, build_systems, complain, make_folder, read_sweep,
    results_folder, say, stop, survey_cases, use_threads, warn_of_string, warn_of_unstable,
};
use crate::cli::{LogFormat, RunArguments};
use crate::engine::{Header, Log, MethodSystem, Record, Shard, Work, pairs_of};
use crate::files::write_with_checksum;
use crate::memory::{Purpose, admit};
use crate::output::{
    About, Boundary, Manifest, Repeat, Tally, boundary, fingerprint, write_boundary, write_tables,
};
use crate::sweep_file::Sweep;
use crate::words::{counted, together, wrapped};
use plan::Plan;

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
    if !arguments.quiet {
        warn_of_string(&sweep);
    }
    let shard = arguments.shard.unwrap_or(Shard::WHOLE);
    let survey = survey_cases(&arguments.file, &sweep)?;
    let mut folder = results_folder(arguments.out.as_ref(), &sweep);
    if arguments.out.is_none() && !shard.is_whole() {
        folder.push(format!("shard-{}-of-{}", shard.index, shard.of));
    }
    let header = Header::new(shard, fingerprint(&sweep, arguments.options())?);
    let again = Again {
        arguments,
        sweep: &sweep,
        survey: &survey,
        header: &header,
        folder: &folder,
    };
    let found = look(&folder, &header, &sweep, arguments.fresh)?;
    if arguments.dry_run {
        let plan = Plan {
            again: &again,
            shard,
            found: &found,
        };
        let text = plan.describe(&|| stop::asked().is_some())?;
        if let Some(status) = stop::asked() {
            return Ok(status);
        }
        say(&text)?;
        return Ok(Status::Complete);
    }
    if let Found::Complete(manifest) = found {
        return again.show(*manifest);
    }
    let setting = sweep.setting.for_labels();
    let most = arguments.work.memory.limit();
    let memory = admit(&sweep, &setting, &survey, Purpose::Labels, &most)?;
    let systems = build_systems(&arguments.file, &sweep, &setting, survey.longest)?;
    if !arguments.allow_unstable && !sweep.design.varies_string() {
        refuse_unstable(arguments, &sweep, &systems)?;
    }
    let limit = boundary(&sweep, &systems).map_err(UsageError)?;
    make_folder(&folder)?;
    let lock = hold(&folder, LOG)?;
    let log = folder.join(LOG);
    // Another run may have been there meanwhile.
    match look(&folder, &header, &sweep, arguments.fresh)? {
        Found::Nothing(ours) => {
            Log::begin(&log, &header)?;
            ours.remove_results(&folder)?;
        }
        Found::Unfinished { had_fewer: false } => {}
        Found::Unfinished { had_fewer: true } => raise_log(&log, &header, &sweep)?,
        Found::Fewer(manifest) => log_of_results(&folder, &manifest, &header, &sweep)?,
        Found::Complete(manifest) => {
            drop(lock);
            return again.show(*manifest);
        }
    }
    let log = Arc::new(Log::open(&log, sweep.design.cases(), sweep.methods.len())?);
    let about = About::new(
        &sweep,
        &arguments.file,
        shard,
        arguments.options(),
        &systems,
    )?;
    log.describe(about.text()?)?;
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
        strings_at_once: memory.strings_at_once,
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
    warn_of_broken_lines(log);
}

/// Says what of a log is lost.
pub fn warn_of_broken_lines(log: &Log) {
    if log.broken_lines() > 0 {
        complain(&format!(
            "warning: {} of the log not whole; those cases are run again",
            counted(log.broken_lines(), "line")
        ));
    }
}

/// A run of a sweep, or of a part of it, under way.
struct Session<'a> {
    arguments: &'a RunArguments,
    sweep: &'a Sweep,
    shard: Shard,
    systems: &'a [MethodSystem],
    strings_at_once: usize,
    folder: &'a Path,
    start: Instant,
}

impl Session<'_> {
    fn simulate_open_cases(&self, log: &Log, progress: &Progress) -> Result<()> {
        let (arguments, sweep) = (self.arguments, self.sweep);
        if arguments.fail_fast && log.failed() > 0 {
            bail!(
                "{} without an answer already (--fail-fast)",
                counted(log.failed(), "case")
            );
        }
        let is_done = log.done();
        let keep = |record: Record| -> Result<()> {
            log.append(&record)?;
            progress.tick();
            match record.reason() {
                Some(reason) if arguments.fail_fast => bail!(
                    "case {} by {} has no answer: {reason} (--fail-fast)",
                    record.case,
                    sweep.methods[record.method].name()
                ),
                _ => Ok(()),
            }
        };
        let work = Work {
            sweep,
            shard: self.shard,
            options: arguments.options(),
            strings_at_once: self.strings_at_once,
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
        let repeat = Repeat {
            sweep_file: &arguments.file,
            chooses_method: sweep.choice.is_some(),
            options: arguments.options(),
        };
        let tables = write_tables(sweep, repeat, log, folder)?;
        let limit = write_with_checksum(&folder.join("boundary.csv"), &write_boundary(limit)?)?;
        let seconds = self.start.elapsed().as_secs_f64();
        let mut manifest = Manifest::new(
            sweep,
            shard,
            arguments.options(),
            self.systems,
            tables.tally,
            seconds,
        )?;
        manifest.files = tables.files;
        manifest.files.insert("boundary.csv".to_owned(), limit);
        manifest.write(folder)?;
        remove_page(folder)?;
        let drawn = shard.is_whole() && draw_and_note(folder, &mut manifest)?;
        let path = folder.join(LOG);
        std::fs::remove_file(&path)
            .with_context(|| format!("{} cannot be removed", path.display()))?;
        if !arguments.quiet {
            say(&summary(&manifest, folder, drawn)?)?;
        }
        Ok(status_of(&manifest))
    }
}

/// How a run that has these results ends.
pub fn status_of(manifest: &Manifest) -> Status {
    if manifest.tally.failed > 0 {
        Status::SomeFailed
    } else {
        Status::Complete
    }
}

/// The labels of each method, in a paragraph for each motion.
fn label_counts(tally: &Tally) -> String {
    let mut text = String::new();
    for method in tally.labels.keys() {
        let lists = tally.by_motion(method);
        let has_two = lists.len() > 1;
        for (motion, labels) in lists {
            let counts = labels
                .iter()
                .map(|(label, count)| together(&format!("{count} {label}")));
            let counts: Vec<String> = counts.collect();
            let of = if has_two {
                format!(", {}", motion.adjective())
            } else {
                String::new()
            };
            text += &wrapped(&format!("{method}{of}: {}", counts.join(", ")), 2, 4);
        }
    }
    text
}

/// What came out, in a few lines.
pub fn summary(manifest: &Manifest, folder: &Path, drawn: bool) -> Result<String> {
    let mut text = String::new();
    let rows = manifest.tally.rows;
    writeln!(
        text,
        "{}: {} by {} in {:.2} s",
        manifest.name,
        counted(rows / manifest.methods.len().max(1), "case"),
        counted(manifest.methods.len(), "method"),
        manifest.wall_seconds
    )?;
    if let Some(choice) = &manifest.accuracy {
        text += &choice.lines(2);
    }
    text += &label_counts(&manifest.tally);
    if manifest.tally.failed > 0 {
        let failed = manifest.tally.failed;
        let rows = counted(rows, "row");
        writeln!(text, "  {failed} of {rows} failed: see failures.csv")?;
    }
    if manifest.tally.settled_wrong > 0 {
        let (wrong, checked) = (manifest.tally.settled_wrong, manifest.tally.settled_checked);
        let checked = counted(checked, "settled case");
        let words =
            format!("{wrong} of {checked} followed to the end changed the label: use --full");
        text += &wrapped(&words, 2, 4);
    }
    let map = if drawn { "map.svg, map.png, " } else { "" };
    writeln!(text, "{map}labels.csv and more are in {}", folder.display())?;
    Ok(text)
}
