//! The linear systems of the chosen string, and every case by each of them.

use std::path::Path;

use anyhow::Result;

use crate::cli::SimulateArguments;
use crate::commands::prepare::build_systems;
use crate::commands::terminal::Terminal;
use crate::commands::warnings::warn_of_unstable;
use campaign::engine::ChosenCase;
use campaign::engine::{FollowedMethod, Simulation};
use campaign::engine::{MethodSystem, RunOptions};
use campaign::plan::Sweep;
use campaign::records::{Failure, Record};

/// The row of every case and method, as a run has it, and the motion of each that has
/// an answer.
///
/// # Errors
/// Where a method cannot treat the string, or a case has no answer at its end.
pub fn simulate_all(
    sweep: &Sweep,
    arguments: &SimulateArguments,
    cases: &[ChosenCase],
    terminal: Terminal,
) -> Result<(Vec<Record>, Vec<Simulation>)> {
    let options = run_options(sweep, arguments);
    // By the time (s) they are built for.
    let mut built: Vec<(f64, Vec<Result<FollowedMethod, Failure>>)> = Vec::new();
    let (mut rows, mut simulations) = (Vec::new(), Vec::new());
    for ChosenCase { case, longest } in cases {
        if !built.iter().any(|(time, _)| time == longest) {
            let systems = build(&arguments.file, sweep, options, *longest, terminal)?;
            let followed = systems.into_iter().map(|system| match system {
                Ok(system) => FollowedMethod::new(sweep, system, *longest).map(Ok),
                Err(reason) => Ok(Err(reason)),
            });
            built.push((*longest, followed.collect::<Result<_>>()?));
        }
        let systems = built.iter().filter(|(time, _)| time == longest);
        for (method, system) in systems.flat_map(|(_, systems)| systems).enumerate() {
            match system {
                Ok(system) => {
                    let is_alone = cases.len() == 1;
                    let (row, simulation) =
                        system.simulate(sweep, case, method, options, is_alone)?;
                    rows.push(row);
                    simulations.extend(simulation);
                }
                Err(reason) => {
                    let values = case.values.clone();
                    rows.push(Record::failed(case.index, method, values, reason.clone()));
                }
            }
        }
    }
    Ok((rows, simulations))
}

/// How a run steps these cases.
pub fn run_options(sweep: &Sweep, arguments: &SimulateArguments) -> RunOptions {
    RunOptions {
        full: arguments.full,
        // Where all cases share a string, a run refuses the method before any row:
        // what it would do can be seen here.
        allow_unstable: arguments.allow_unstable || !sweep.design.varies_string(),
    }
}

/// The linear systems of the chosen string for a time (s), or why a method has none.
///
/// # Errors
/// Where all cases share the string, and a method cannot treat it.
pub fn build(
    file: &Path,
    sweep: &Sweep,
    options: RunOptions,
    longest: f64,
    terminal: Terminal,
) -> Result<Vec<Result<MethodSystem, Failure>>> {
    let setting = sweep.setting.for_labels();
    let systems: Vec<Result<MethodSystem>> = if sweep.design.varies_string() {
        MethodSystem::build_each(sweep, &setting, longest, &[])
    } else {
        // A run would not begin.
        let systems = build_systems(file, sweep, &setting, longest)?;
        systems.into_iter().map(Ok).collect()
    };
    if options.allow_unstable {
        warn_of_unstable(systems.iter().flatten(), terminal);
    }
    let failed = |error| Failure::new(format_args!("{error:#}"));
    Ok(systems
        .into_iter()
        .map(|system| system.map_err(failed))
        .collect())
}
