//! The linear systems of a run, and what follows from them alone.

use anyhow::{Result, bail};
use linear::Method;

use super::task::Task;
use crate::commands::prepare::build_systems;
use crate::commands::status::UsageError;
use crate::output::{Boundary, boundary};
use campaign::engine::{MethodSystem, add_finer, compare_fronts};
use campaign::memory::{Estimate, Purpose, admit};

/// What is built before the first case.
pub struct Systems {
    /// By method.
    pub methods: Vec<MethodSystem>,
    /// As many strings as memory allows are built at once.
    pub strings_at_once: usize,
    /// The analytic limit.
    pub limit: Boundary,
}

impl Systems {
    /// Builds them, within the memory that is allowed.
    ///
    /// # Errors
    /// Where they take more, or a method cannot treat the string.
    pub fn build(task: &Task) -> Result<Self> {
        let (arguments, sweep) = (task.arguments, &task.sweep);
        let (memory, methods) = build_admitted(task)?;
        let mut methods = add_finer(methods, sweep, task.survey.longest)?;
        // Where axes change the string, none stands for all.
        if !(sweep.design.varies_string() || arguments.allow_unstable) {
            refuse_unstable(task, &methods)?;
        }
        compare_fronts(&mut methods);
        Ok(Self {
            limit: boundary(sweep, &methods).map_err(|error| UsageError(error.to_string()))?,
            strings_at_once: memory.strings_at_once,
            methods,
        })
    }
}

/// The linear systems of the sweep, and what a run with them takes.
///
/// # Errors
/// Where that is more memory than is allowed, or a method cannot treat the string.
pub fn build_admitted(task: &Task) -> Result<(Estimate, Vec<MethodSystem>)> {
    let (arguments, sweep, survey) = (task.arguments, &task.sweep, &task.survey);
    let setting = sweep.setting.for_labels();
    let most = arguments.work.memory.limit();
    let memory = admit(sweep, &setting, survey, Purpose::Labels, &most)?;
    let methods = build_systems(&arguments.file, sweep, &setting, survey.longest)?;
    Ok((memory, methods))
}

/// Refuses a method that chatters where a site sticks. Where axes change the
/// string, each string's own margin counts, and its cases fail.
fn refuse_unstable(task: &Task, systems: &[MethodSystem]) -> Result<()> {
    let (arguments, sweep) = (task.arguments, &task.sweep);
    let mut found = systems.iter().enumerate();
    let first = found.find_map(|(index, system)| {
        let own = system.instability().map(|own| (own, None));
        let finer = || system.instability_of_finer().map(|(it, at)| (it, Some(at)));
        Some((index, system, own.or_else(finer)?))
    });
    let Some((index, system, (instability, at_shorter_steps))) = first else {
        return Ok(());
    };
    let remedy = match system.method {
        Method::Hilbert(_) => "take another method or a longer transform",
        Method::FiniteElement(_) => "take another method or a larger gamma",
        Method::Held | Method::Quadrature | Method::Trapezoidal | Method::DirectIdft(_) => {
            "take another method"
        }
    };
    let message = match at_shorter_steps {
        None => format!("{instability}; {remedy}, or give --allow-unstable"),
        Some(frequency) => {
            format!("{instability} at the {frequency} Hz that certify labels; {remedy}")
        }
    };
    if arguments.work.methods.is_empty() {
        let key = format!("methods[{index}]");
        bail!(sweep.source.error(&key, message));
    }
    bail!(UsageError(format!("--methods: {message}")))
}
