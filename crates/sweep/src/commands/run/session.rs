//! A run of a sweep, or of a part of it, under way: its cases into the log, and the log
//! into the results.

use std::sync::Arc;
use std::time::Instant;

use anyhow::{Context, Result, anyhow, bail};

use super::systems::Systems;
use super::task::Task;
use crate::commands::drawing::{Drawing, draw_and_note};
use crate::commands::folder::{LOG, remove_page};
use crate::commands::outcome::{status_of, summary};
use crate::commands::progress::Progress;
use crate::commands::status::Status;
use crate::commands::stop;
use crate::commands::terminal::say;
use crate::commands::warnings::{warn_of_broken_lines, warn_of_fronts, warn_of_unstable};
use campaign::Run;
use campaign::dependence::{Sample, dependences};
use campaign::design::Design;
use campaign::records::Record;
use campaign::words::counted;
use limits::boundary_csv;
use results::files::write_with_checksum;
use results::folder::{About, Manifest, TableWriter};
use results::log::Log;
use results::traced::write_traced;

/// A run under way.
pub struct Session<'a> {
    task: &'a Task<'a>,
    systems: &'a Systems,
    log: Arc<Log>,
    about: About,
    so_far: SoFar,
    start: Instant,
}

/// What is said of a run that is stopped before its end.
#[derive(Clone)]
struct SoFar {
    /// Simulations in all, where that is known beforehand.
    total: Option<usize>,
    /// Where they are kept.
    place: String,
}

impl SoFar {
    /// The simulations that are kept, and how to continue, where any are.
    fn text(&self, kept: Option<usize>) -> String {
        let Self { total, place } = self;
        let Some(done) = kept else {
            return format!("nothing is kept in {place}: remove its {LOG} and begin anew");
        };
        let of = total.map_or_else(String::new, |total| format!(" of {total}"));
        format!("{done}{of} simulations are done and kept in {place}: the same command continues")
    }
}

impl<'a> Session<'a> {
    /// Opens the log of a folder that is held, and says what is worth knowing before the
    /// work. The run began at `start`.
    ///
    /// # Errors
    /// Where the log cannot be read or written.
    pub fn open(task: &'a Task, systems: &'a Systems, start: Instant) -> Result<Self> {
        let sweep = &task.campaign.sweep;
        let path = task.folder.join(LOG);
        let log = Log::open(&path, sweep.design.cases(), sweep.methods.len())?;
        let (file, options) = (&task.arguments.file, task.arguments.options());
        let about = About::new(sweep, file, &task.header, options, &systems.built.methods)?;
        log.describe(serde_json::to_string(&about)?)?;
        warn_of_unstable(&systems.built.methods, task.terminal);
        warn_of_fronts(sweep, &systems.built.methods, task.terminal);
        warn_of_broken_lines(&log, task.terminal);
        Ok(Self {
            log: Arc::new(log),
            so_far: SoFar {
                total: about.simulations,
                place: task.folder.display().to_string(),
            },
            about,
            task,
            systems,
            start,
        })
    }

    /// Simulates what is not in the log yet. A signal ends the program.
    ///
    /// # Errors
    /// Where the log cannot be written; with `--fail-fast`, where a case has no answer.
    pub fn simulate(&self) -> Result<()> {
        // Of a trace it is reported again with each round.
        let sweep = &self.task.campaign.sweep;
        let likely = || sweep.design.likely_cases() * sweep.methods.len();
        let total = self.so_far.total.unwrap_or_else(likely);
        let (quiet, terminal) = (self.task.arguments.quiet, self.task.terminal);
        let progress = Progress::new(total, self.log.counts().done, quiet, terminal);
        stop::before_end({
            let log = Arc::clone(&self.log);
            let (progress, so_far) = (Arc::clone(&progress), self.so_far.clone());
            move || {
                progress.finish();
                log.close(|kept| terminal.complain(&format!("stopped: {}", so_far.text(kept))));
            }
        });
        let worked = self.simulate_open_cases(&progress);
        progress.finish();
        let kept = self.log.sync();
        worked.map_err(|error| self.with_so_far(&error))?;
        kept.map_err(|error| self.with_so_far(&error.into()))?;
        let is_complete = self
            .so_far
            .total
            .is_some_and(|all| self.log.counts().done >= all);
        match stop::asked() {
            Some(status) if !is_complete => stop::end(status),
            _ => Ok(()),
        }
    }

    /// Simulates the cases that are not in the log yet; a signal ends it sooner.
    fn simulate_open_cases(&self, progress: &Progress) -> Result<()> {
        let (arguments, campaign, log) = (self.task.arguments, &self.task.campaign, &self.log);
        if arguments.fail_fast && log.counts().failed > 0 {
            bail!(
                "{} without an answer already (--fail-fast)",
                counted(log.counts().failed, "simulation")
            );
        }
        let is_done = log.done();
        let keep = |record: Record| -> Result<()> {
            log.append(&record)?;
            progress.tick();
            match &record.outcome {
                Err(reason) if arguments.fail_fast => bail!(
                    "case {} by {} has no answer: {reason} (--fail-fast)",
                    record.case,
                    campaign.sweep.methods[record.method].name()
                ),
                _ => Ok(()),
            }
        };
        let run = Run {
            shard: self.task.header.shard,
            options: arguments.options(),
            is_done: &is_done,
            earlier: &|note| {
                log.in_order(|records| {
                    records.iter().for_each(note);
                    Ok(())
                })
            },
            expect: &|more| progress.expect(log.counts().done + more),
            stops: &|| stop::asked().is_some(),
        };
        campaign.run(&self.systems.built, &run, &keep)
    }

    /// From the log to the results. The log goes last: as long as it is there, the
    /// same command does this again.
    ///
    /// # Errors
    /// Where a file cannot be written.
    pub fn finish(&self) -> Result<Status> {
        stop::before_end({
            let (terminal, so_far) = (self.task.terminal, self.so_far.clone());
            let kept = self.log.kept();
            move || terminal.complain(&format!("stopped: {}", so_far.text(kept)))
        });
        let finished = self.write_results();
        finished.map_err(|error| self.with_so_far(&error))
    }

    fn write_results(&self) -> Result<Status> {
        let (arguments, folder) = (self.task.arguments, &self.task.folder);
        let mut manifest = self.write_tables()?;
        manifest.write(folder)?;
        remove_page(folder)?;
        let drawn = self.task.header.shard.is_whole()
            && draw_and_note(folder, &mut manifest, &Drawing::default())?;
        let path = folder.join(LOG);
        std::fs::remove_file(&path)
            .with_context(|| format!("{} cannot be removed", path.display()))?;
        if !arguments.quiet {
            say(&summary(&manifest, folder, drawn)?)?;
        }
        Ok(status_of(&manifest))
    }

    /// The tables of the run, and the manifest that speaks of them.
    fn write_tables(&self) -> Result<Manifest> {
        let (arguments, sweep, folder) = (
            self.task.arguments,
            &self.task.campaign.sweep,
            &self.task.folder,
        );
        let mut tables = TableWriter::create(&self.about, folder)?;
        let mut sample = Sample::of(sweep);
        self.log.in_order(|records| {
            records.iter().for_each(|record| sample.note(record));
            tables.add(records)
        })?;
        let (tally, files) = tables.finish()?;
        if let Some(all) = self.so_far.total.filter(|all| *all != tally.rows) {
            bail!("the tables have {} of {all} rows", tally.rows);
        }
        let limit = boundary_csv(&self.systems.limit);
        let limit = write_with_checksum(&folder.join("boundary.csv"), limit.as_bytes())?;
        let (shard, systems) = (self.task.header.shard, &self.systems.built.methods);
        let mut manifest = Manifest::new(sweep, &self.task.header, arguments.options(), systems)?;
        (manifest.tally, manifest.files) = (tally, files);
        if self.systems.built.memory.sees_dependences {
            let options = arguments.options();
            manifest.depends_on = dependences(sweep, shard, options, systems, &sample);
        }
        manifest.wall_seconds = self.start.elapsed().as_secs_f64();
        manifest.files.insert("boundary.csv".to_owned(), limit);
        if let Design::Trace(design) = &sweep.design {
            write_traced(folder, design, &mut manifest)?;
        }
        Ok(manifest)
    }

    fn with_so_far(&self, error: &anyhow::Error) -> anyhow::Error {
        anyhow!("{error:#}; {}", self.so_far.text(self.log.kept()))
    }
}
