//! `Sweep.run`: every case by every method, as `sweep run` has them.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use anyhow::{Result, bail};
use campaign::design::Design;
use campaign::engine::{RunOptions, Shard, Survey, pairs_of};
use campaign::labels::LabelTable;
use campaign::memory::{Limit, Size};
use campaign::records::Record;
use campaign::run::{RunError, RunSystems};
use campaign::threads::{allotted_threads, asked_threads};
use campaign::{Campaign, NoRun, Run};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::ThreadPool;

use crate::errors::{refused, warn};
use crate::read::ReadSweep;
use crate::table::{Column, by_name, columns};
use crate::wait::{call_python, wait_for, watch};

/// What a row takes in addition to its values, bytes: its record, and its fields in the table.
const ROW: usize = size_of::<Record>() + 32 * size_of::<f64>();

/// How far a run is, for display.
#[derive(Default)]
struct Progress {
    done: AtomicUsize,
    /// How many are wanted; of a trace, so far.
    wanted: AtomicUsize,
    /// Whether to begin no further case.
    stops: AtomicBool,
}

impl Progress {
    fn counts(&self) -> (usize, usize) {
        let [done, wanted] = [&self.done, &self.wanted].map(|it| it.load(Ordering::Relaxed));
        (done, wanted)
    }
}

/// A run under way.
struct Running {
    campaign: Arc<Campaign>,
    systems: RunSystems,
    options: RunOptions,
    progress: Arc<Progress>,
}

/// Runs every case by every method, and gives the columns of `labels.csv` by name.
///
/// # Errors
/// Where the run does not begin, or is stopped.
pub fn run<'py>(
    py: Python<'py>,
    sweep: &ReadSweep,
    threads: Option<usize>,
    progress: Option<Bound<'py, PyAny>>,
    options: RunOptions,
    limit: Limit,
) -> PyResult<Bound<'py, PyDict>> {
    let pool = Arc::new(pool_of(py, threads)?);
    let campaign = Campaign::clone(&sweep.campaign).for_run(options);
    let campaign = Arc::new(campaign.map_err(|error| match error {
        NoRun::File(error) => sweep.lines.file_error(py, &error),
        NoRun::CertifiesNothing => refused(error),
    })?);
    let survey = sweep.look(py)?;
    let systems = {
        let (campaign, pool) = (Arc::clone(&campaign), Arc::clone(&pool));
        let build = move || pool.install(|| build(&campaign, &survey, options, &limit));
        wait_for(py, build)?.map_err(|error| not_begun(py, sweep, error))?
    };
    for instability in systems
        .methods
        .iter()
        .filter_map(|system| system.instability())
    {
        warn(py, instability)?;
    }
    for front in systems
        .methods
        .iter()
        .filter_map(|system| system.wrong_front())
    {
        warn(py, front.words(campaign.sweep.content.units))?;
    }
    let shared = Arc::new(Progress::default());
    let running = Running {
        campaign,
        systems,
        options,
        progress: Arc::clone(&shared),
    };
    let look = || match &progress {
        Some(progress) => call_python(|| progress.call1(shared.counts())).map(drop),
        None => Ok(()),
    };
    let made = watch(py, move || pool.install(|| running.table()), &look);
    // The caller does not wait any more.
    shared.stops.store(true, Ordering::Relaxed);
    let table = made?.map_err(|error| sweep.lines.any_error(py, &error))?;
    by_name(py, table)
}

/// What a run builds before its first case, where that and its table are within the limit.
fn build(
    campaign: &Campaign,
    survey: &Survey,
    options: RunOptions,
    limit: &Limit,
) -> Result<RunSystems, RunError> {
    let plan = &campaign.sweep;
    let rows = plan.design.likely_cases() * plan.methods.len();
    let table = (rows * (ROW + plan.design.axes().len() * 2 * size_of::<f64>())) as f64;
    if table > limit.bytes {
        let message = format!(
            "the table of {rows} rows would take {} of memory, more than {limit}; the command \
             `sweep run` writes it to a file",
            Size(table)
        );
        return Err(RunError::Memory(plan.source.error_of_file(message).into()));
    }
    let mut left = *limit;
    left.bytes -= table;
    campaign.build(survey, options, &left)
}

impl Running {
    /// The columns of all rows, in the order of cases and methods.
    fn table(&self) -> Result<Vec<(String, Column)>> {
        let (sweep, progress) = (&self.campaign.sweep, &self.progress);
        let expect = |more| {
            progress.wanted.fetch_add(more, Ordering::Relaxed);
        };
        if !matches!(sweep.design, Design::Trace(_)) {
            expect(pairs_of(sweep, Shard::WHOLE));
        }
        let run = Run {
            shard: Shard::WHOLE,
            options: self.options,
            is_done: &|_, _| false,
            earlier: &|_| Ok(()),
            expect: &expect,
            stops: &|| progress.stops.load(Ordering::Relaxed),
        };
        let kept = Mutex::new(Vec::new());
        self.campaign.run(&self.systems, &run, &|record| {
            // Pushed in one step.
            kept.lock()
                .unwrap_or_else(PoisonError::into_inner)
                .push(record);
            progress.done.fetch_add(1, Ordering::Relaxed);
            Ok(())
        })?;
        if progress.stops.load(Ordering::Relaxed) {
            bail!("stopped");
        }
        let mut records: Vec<Record> = kept.into_inner().unwrap_or_else(PoisonError::into_inner);
        records.sort_unstable_by_key(|record| (record.case, record.method));
        Ok(columns(&LabelTable::of(sweep), &records))
    }
}

/// Why a run does not begin, as an error of Python.
pub fn not_begun(py: Python<'_>, sweep: &ReadSweep, error: RunError) -> PyErr {
    match error {
        RunError::Memory(error) | RunError::Systems(error) => sweep.lines.any_error(py, &error),
        RunError::Unstable(error) => {
            let key = format!("methods[{}]", error.place);
            let error = sweep.campaign.sweep.source.error(&key, error.to_string());
            sweep.lines.file_error(py, &error)
        }
    }
}

/// As many threads as asked for, or as the command would use.
fn pool_of(py: Python<'_>, threads: Option<usize>) -> PyResult<ThreadPool> {
    let count = match threads {
        Some(threads) => asked_threads(threads)
            .map_err(|reason| refused(format_args!("threads {threads}: {reason}")))?,
        None => {
            let (count, ignored) = allotted_threads();
            for doubt in ignored {
                warn(py, doubt)?;
            }
            count
        }
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build();
    pool.map_err(refused)
}
