//! What a run builds before its first case: the linear systems, within the memory that it
//! may take, and by no method that would chatter.

use linear::Method;
use thiserror::Error;

use crate::engine::{
    Instability, MethodSystem, Recipe, RunOptions, Survey, add_finer, compare_fronts,
};
use crate::memory::{Estimate, Limit, Purpose, admit};
use crate::plan::Sweep;

/// What is built before the first case.
pub struct RunSystems {
    /// By method.
    pub methods: Vec<MethodSystem>,
    /// What the run takes.
    pub memory: Estimate,
}

impl RunSystems {
    /// Builds them, within a limit of memory.
    ///
    /// # Errors
    /// Where they take more, a method cannot treat the string, or one would chatter.
    pub fn build(
        sweep: &Sweep,
        survey: &Survey,
        options: RunOptions,
        limit: &Limit,
    ) -> Result<Self, RunError> {
        let Self { methods, memory } = Self::admitted(sweep, survey, limit)?;
        let finer = add_finer(methods, sweep, survey.longest);
        let mut methods = finer.map_err(RunError::Systems)?;
        // Where axes change the string, each string's own margin counts, and its cases fail.
        if !(sweep.design.varies_string() || options.allow_unstable) {
            refuse_unstable(&methods)?;
        }
        if memory.compares_fronts {
            compare_fronts(&mut methods);
        }
        Ok(Self { methods, memory })
    }

    /// Those of the string as the file says it, however stable they are.
    ///
    /// # Errors
    /// Where a run takes more memory, or a method cannot treat the string.
    pub fn admitted(sweep: &Sweep, survey: &Survey, limit: &Limit) -> Result<Self, RunError> {
        let setting = sweep.setting.for_labels();
        let memory = admit(sweep, &setting, survey, Purpose::Labels, limit);
        let memory = memory.map_err(RunError::Memory)?;
        let methods = Recipe::build_each(sweep, &setting, survey.longest, &[]);
        let methods: Result<_, _> = methods.into_iter().collect();
        Ok(Self {
            methods: methods.map_err(RunError::Systems)?,
            memory,
        })
    }
}

/// Why a run does not begin.
#[derive(Debug, Error)]
pub enum RunError {
    /// It would take too much memory.
    #[error("{0:#}")]
    Memory(anyhow::Error),
    /// A method cannot treat the string.
    #[error("{0:#}")]
    Systems(anyhow::Error),
    /// A method chatters where a site sticks.
    #[error(transparent)]
    Unstable(#[from] UnstableMethod),
}

/// A method that chatters where a site sticks.
#[derive(Debug, Error)]
#[error("{}", self.words())]
pub struct UnstableMethod {
    /// Its place in the sweep's list.
    pub place: usize,
    method: Method,
    instability: Instability,
    /// The sampling frequency, Hz, where only at that of certificates it does.
    of_certificates: Option<f64>,
}

impl UnstableMethod {
    fn words(&self) -> String {
        let remedy = match self.method {
            Method::Hilbert(_) => "take another method or a longer transform",
            Method::FiniteElement(_) => "take another method or a larger gamma",
            _ => "take another method",
        };
        let instability = &self.instability;
        match self.of_certificates {
            None => format!("{instability}; {remedy}, or give --allow-unstable"),
            Some(frequency) => {
                format!("{instability} at the {frequency} Hz that certify labels; {remedy}")
            }
        }
    }
}

fn refuse_unstable(systems: &[MethodSystem]) -> Result<(), UnstableMethod> {
    let mut found = systems.iter().enumerate();
    let first = found.find_map(|(place, system)| {
        let own = system.instability().map(|own| (own, None));
        let finer = || system.instability_of_finer().map(|(it, at)| (it, Some(at)));
        let (instability, of_certificates) = own.or_else(finer)?;
        Some(UnstableMethod {
            place,
            method: system.method,
            instability,
            of_certificates,
        })
    });
    first.map_or(Ok(()), Err)
}
