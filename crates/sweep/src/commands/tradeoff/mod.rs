//! `sweep study tradeoff`: accuracy against speed, as a table, a chart, and in words.

mod chart;
mod description;
mod table;

use anyhow::{Context, Result, bail};

use super::drawing::save_picture;
use super::folder::make_folder;
use super::prepare::unique;
use super::progress::Progress;
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use crate::cli::TradeoffArguments;
use chart::chart;
use description::{describe_cheapest, describe_orders};
use results::files::write_atomically;
use studies::scenes::Loss;
use studies::tradeoff::{Measure, MeasureSubject, PaperSteps, configurations, study};
use table::table;

/// Ladders within these are sampled frequencies, Hz.
const LADDER_RANGE: std::ops::RangeInclusive<f64> = 10.0..=20_480.0;

/// Compares the methods.
pub fn tradeoff(arguments: &TradeoffArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.jobs, terminal)?;
    let ladder = ladder(&arguments.ladder)?;
    let loss = Loss::in_mud(arguments.in_mud);
    let has_reference =
        |measure: &Measure| loss == Loss::Constants || measure.subject() != MeasureSubject::Tube;
    let measures = if arguments.measures.is_empty() {
        Measure::all().into_iter().filter(has_reference).collect()
    } else {
        unique(&arguments.measures)
    };
    if let Some(measure) = measures.iter().find(|measure| !has_reference(measure)) {
        bail!(UsageError(format!(
            "--in-mud: {} has no reference in mud: leave it out",
            measure.name()
        )));
    }
    make_folder(&arguments.out)?;
    let configurations = configurations(&ladder);
    let progress = Progress::new(configurations.len(), 0, arguments.quiet, terminal);
    let studied = study(&configurations, &measures, loss, &|| progress.tick());
    progress.finish();
    let rows = studied?;
    write_atomically(&arguments.out.join("tradeoff.csv"), &table(&rows)?)?;
    save_picture(&arguments.out, "tradeoff", &chart(&rows))?;
    if !arguments.quiet {
        say(&[
            describe_orders(&rows)?,
            describe_cheapest(&rows, &PaperSteps::measure()?)?,
            format!(
                "\ntradeoff.csv, tradeoff.svg and tradeoff.png are in {}\n",
                arguments.out.display()
            ),
        ]
        .concat())?;
    }
    Ok(Status::Complete)
}

/// The ladder in order, every rung once.
fn ladder(given: &[f64]) -> Result<Vec<f64>> {
    let mut ladder = given.to_vec();
    ladder.sort_by(f64::total_cmp);
    ladder.dedup();
    let highest = ladder.last().copied().context("the ladder has a rung")?;
    for &rung in &ladder {
        let times = highest / rung;
        if !LADDER_RANGE.contains(&rung) || (times - times.round()).abs() > 1e-9 * times {
            bail!(UsageError(format!(
                "--ladder: {rung} Hz is not between {} and {} Hz, or {highest} Hz is not a \
                 multiple of it",
                LADDER_RANGE.start(),
                LADDER_RANGE.end()
            )));
        }
    }
    Ok(ladder)
}
