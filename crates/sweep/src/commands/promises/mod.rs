//! `sweep study promises`: how often an accuracy asked for is kept, or a label that is certain is
//! right, on strings drawn at random.

mod cutting;
mod growth;
mod labels;
mod limits;
mod table;

use anyhow::{Context, Result};
use linear::Method;
use linear::method::{FiniteElement, Transform};

use super::csv_table::csv_table;
use super::folder::make_folder;
use super::progress::Progress;
use super::status::Status;
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use crate::cli::PromisesArguments;
use results::files::write_atomically;
use studies::promises::{
    Motion, Wanted, cutting_labels, cutting_limits, cutting_promises, default_limits,
    onsets_of_growth, run, test_labels,
};
use table::{columns, summary};

/// Puts promises to the test and writes their table.
pub fn promises(arguments: &PromisesArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.jobs, terminal)?;
    make_folder(&arguments.out)?;
    let is_wanted =
        |motion: &Motion| arguments.motion.is_empty() || arguments.motion.contains(motion);
    let motions: Vec<Motion> = Motion::ALL.into_iter().filter(is_wanted).collect();
    let limit = arguments.memory.limit();
    let strings = arguments.strings as usize;
    let has_one_motion = arguments.limits || arguments.growth || arguments.cutting;
    let motions_of_table = if has_one_motion { 1 } else { motions.len() };
    let progress = Progress::new(motions_of_table * strings, 0, arguments.quiet, terminal);
    let tick = || progress.tick();
    let (name, table, text) = if arguments.limits {
        let known = arguments.known.as_deref().map(limits::known).transpose()?;
        let known = known.unwrap_or_default();
        let methods = wanted_methods(&arguments.methods)?;
        let of_string = |number: usize| known.get(&number).cloned();
        let wanted = Wanted {
            methods: &methods,
            begins: arguments.start,
            in_mud: arguments.in_mud,
        };
        let found = default_limits(wanted, strings, arguments.seed, &of_string, &tick);
        progress.finish();
        let found = found?;
        let table = csv_table(found.iter().map(limits::columns))?;
        ("limits.csv", table, limits::summary(&found))
    } else if arguments.cutting && arguments.labels {
        let found = cutting_labels(strings, arguments.seed, &tick);
        progress.finish();
        let cases = found?;
        let table = csv_table(cases.iter().map(cutting::label_columns))?;
        let text = cutting::label_summary(&cases);
        ("cutting_labels.csv", table, text)
    } else if arguments.accuracy {
        let found = cutting_promises(strings, arguments.seed, &limit, &tick);
        progress.finish();
        let promises = found?;
        let table = csv_table(promises.iter().map(cutting::promise_columns))?;
        let text = cutting::promise_summary(&promises);
        ("cutting_promises.csv", table, text)
    } else if arguments.cutting {
        let methods = wanted_methods(&arguments.methods)?;
        let found = cutting_limits(&methods, strings, arguments.seed, &tick);
        progress.finish();
        let limits = found?;
        let table = csv_table(limits.iter().map(cutting::columns))?;
        ("cutting_limits.csv", table, cutting::summary(&limits))
    } else if arguments.growth {
        let found = onsets_of_growth(strings, arguments.seed, &tick);
        progress.finish();
        let onsets = found?;
        let table = csv_table(onsets.iter().map(growth::columns))?;
        ("growth.csv", table, growth::summary(&onsets))
    } else if arguments.labels {
        let found = test_labels((&motions, arguments.start), strings, arguments.seed, &tick);
        progress.finish();
        let tested = found?;
        let table = csv_table(tested.iter().map(labels::columns))?;
        ("labels.csv", table, labels::summary(&tested))
    } else {
        let found = run(&motions, strings, arguments.seed, &limit, &tick);
        progress.finish();
        let promises = found?;
        let table = csv_table(promises.iter().map(columns))?;
        ("promises.csv", table, summary(&promises))
    };
    write_atomically(&arguments.out.join(name), &table)?;
    if !arguments.quiet {
        say(&text)?;
    }
    Ok(Status::Complete)
}

/// The methods of these names, with their usual parameters.
fn wanted_methods(names: &[String]) -> Result<Vec<Method>> {
    let of_name = |name: &String| {
        let known = [
            Method::Held,
            Method::Quadrature,
            Method::Hilbert(Transform::default()),
            Method::FiniteElement(FiniteElement::default()),
        ];
        let method = known.into_iter().find(|method| method.name() == name);
        method.with_context(|| format!("there is no method `{name}` to test limits by"))
    };
    names.iter().map(of_name).collect()
}
