//! A sweep from its file to its records, as the command line, Python and the page take it: opened,
//! its method chosen, its linear systems built, its cases followed or run.

use std::path::Path;

use anyhow::Result;
use thiserror::Error;

use crate::accuracy::{self, SearchProgress};
use crate::design::{Design, TraceDesign};
use crate::engine::{
    CaseError, ChoiceError, Keep, RunOptions, Shard, Survey, Work, setting_of, survey,
};
use crate::follow::ChosenCases;
use crate::memory::Limit;
use crate::plan::Sweep;
use crate::quantities::Axis;
use crate::records::Record;
use crate::rounds::Rounds;
use crate::run::{RunError, RunSystems};
use crate::sweep_file::{MethodName, SweepFileError, TextOf};

/// A sweep that is open.
#[derive(Debug, Clone)]
pub struct Campaign {
    /// What its file says.
    pub sweep: Sweep,
}

/// Takes note of a record.
pub type NoteRecord<'a> = &'a dyn Fn(&Record);

/// How cases are run, and what is there of them.
pub struct Run<'a> {
    /// Which of the sweep's cases.
    pub shard: Shard,
    /// How they are simulated.
    pub options: RunOptions,
    /// Which pairs of case and method (by its place in the sweep's list) were done before.
    pub is_done: &'a (dyn Fn(usize, usize) -> bool + Sync),
    /// Gives the records of these: which cases a trace wants next follows from them.
    pub earlier: &'a dyn Fn(NoteRecord) -> Result<()>,
    /// Hears before each round of a trace how many simulations it wants.
    pub expect: &'a dyn Fn(usize),
    /// Whether to begin no further case.
    pub stops: &'a (dyn Fn() -> bool + Sync),
}

impl Campaign {
    /// Opens a sweep file, whose text and those of the files it names `text_of` gives, with these
    /// methods, if there are any, instead of the file's.
    ///
    /// # Errors
    /// Where it does not make sense.
    pub fn open(
        path: &Path,
        methods: &[MethodName],
        text_of: TextOf,
    ) -> Result<Self, SweepFileError> {
        let sweep = Sweep::read_from(path, methods, text_of)?;
        Ok(Self { sweep })
    }

    /// The same or, where it asks for an accuracy, with the cheapest method and sampling frequency
    /// that meet it. `tell` hears beforehand how long that takes, and of each attempt.
    ///
    /// # Errors
    /// Where none meets it within the memory.
    pub fn choose(
        self,
        full: bool,
        limit: &Limit,
        tell: &dyn Fn(SearchProgress),
    ) -> Result<Self, SweepFileError> {
        let sweep = match accuracy::choose(&self.sweep, full, limit, tell)? {
            Some((method, choice)) => self.sweep.with_choice(method, choice)?,
            None => self.sweep,
        };
        Ok(Self { sweep })
    }

    /// The same as a run has it, which certifies labels where it is asked to.
    ///
    /// # Errors
    /// Where the methods cannot, or may chatter.
    pub fn for_run(self, options: RunOptions) -> Result<Self, NoRun> {
        let sweep = self.sweep.for_run()?;
        if sweep.certifying.is_some() && options.allow_unstable {
            return Err(NoRun::CertifiesNothing);
        }
        Ok(Self { sweep })
    }

    /// A look at every case before any is run.
    ///
    /// # Errors
    /// Where a case is refused, an impulse of it is not felt, or the string of every case is invalid.
    pub fn survey(&self) -> Result<Survey, SurveyError> {
        let survey = survey(&self.sweep)?;
        if survey.impossible_strings == self.sweep.design.strings() {
            setting_of(&self.sweep, 0)?;
        }
        if let Some((case, end)) = survey.first_end {
            self.sweep.impulses_are_felt(case, end)?;
        }
        Ok(survey)
    }

    /// Builds the linear systems of a run.
    ///
    /// # Errors
    /// As [`RunSystems::build`].
    pub fn build(
        &self,
        survey: &Survey,
        options: RunOptions,
        limit: &Limit,
    ) -> Result<RunSystems, RunError> {
        RunSystems::build(&self.sweep, survey, options, limit)
    }

    /// Cases by their numbers, with some quantities set to other values, by the methods at these
    /// places of the sweep's list; [`ChosenCases::follow`] follows them to the end of their time.
    ///
    /// # Errors
    /// As [`ChosenCases::of`].
    pub fn cases(
        &self,
        cases: &[usize],
        set: &[(Axis, f64)],
        methods: &[usize],
    ) -> Result<Result<ChosenCases, Vec<Record>>, ChoiceError> {
        ChosenCases::of(&self.sweep, cases, set, methods)
    }

    /// Runs every case that is open, and hands its record to `keep`, whose first error ends the
    /// work; of a trace the cases that it wants, round by round.
    ///
    /// # Errors
    /// What `keep` returned.
    pub fn run(&self, systems: &RunSystems, run: &Run, keep: Keep) -> Result<()> {
        if let Design::Trace(design) = &self.sweep.design {
            return self.run_rounds(design, systems, run, keep);
        }
        let is_open = |case: usize, method: usize| !(run.is_done)(case, method);
        self.run_open(systems, run, &is_open, keep)
    }

    fn run_rounds(
        &self,
        design: &TraceDesign,
        systems: &RunSystems,
        run: &Run,
        keep: Keep,
    ) -> Result<()> {
        let methods = self.sweep.methods.len();
        let rounds = Rounds::new(design, methods);
        (run.earlier)(&|record| rounds.note(record))?;
        let mut has_run = vec![false; self.sweep.design.cases()];
        let next = || (!(run.stops)()).then(|| rounds.wanted()).flatten();
        while let Some(mut wanted) = next() {
            wanted.retain(|case| !std::mem::replace(&mut has_run[*case], true));
            let is_open = |case: usize, method: usize| {
                wanted.binary_search(&case).is_ok() && !(run.is_done)(case, method)
            };
            let pairs = wanted
                .iter()
                .flat_map(|&case| (0..methods).map(move |it| (case, it)));
            (run.expect)(
                pairs
                    .filter(|&(case, method)| is_open(case, method))
                    .count(),
            );
            self.run_open(systems, run, &is_open, &|record| {
                rounds.note(&record);
                keep(record)
            })?;
        }
        Ok(())
    }

    fn run_open(
        &self,
        systems: &RunSystems,
        run: &Run,
        is_open: &(dyn Fn(usize, usize) -> bool + Sync),
        keep: Keep,
    ) -> Result<()> {
        let work = Work {
            sweep: &self.sweep,
            shard: run.shard,
            options: run.options,
            strings_at_once: systems.memory.strings_at_once,
            is_open,
            stops: run.stops,
        };
        work.run(&systems.methods, keep)
    }
}

/// Why a sweep is not run.
#[derive(Debug, Error)]
pub enum NoRun {
    /// Its methods cannot certify labels.
    #[error(transparent)]
    File(#[from] SweepFileError),
    /// Methods that chatter are allowed to certify labels.
    #[error(
        "--allow-unstable: methods that chatter certify nothing; leave it out, or `certify` in the \
         sweep file"
    )]
    CertifiesNothing,
}

/// Why cases are not run.
#[derive(Debug, Error)]
pub enum SurveyError {
    /// One makes no sense.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// An impulse is not felt, or no case has a valid string.
    #[error(transparent)]
    File(#[from] SweepFileError),
}
