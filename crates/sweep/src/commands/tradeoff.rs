//! `sweep tradeoff`: accuracy against speed, as a table, a chart, and in words.

use std::fmt::Write;
use std::path::Path;

use anyhow::{Context, Result, bail};

use super::drawing::save_picture;
use super::folder::make_folder;
use super::progress::Progress;
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use crate::cli::TradeoffArguments;
use crate::output::write_atomically;
use crate::plot::{Axis, Points, ScatterGrid, ScatterPanel, scatter_grid};
use crate::study::tradeoff::{
    CASE_SECONDS, CASES, Cheapest, Measure, PaperRatio, PaperSteps, Row, cheapest, configurations,
    front, orders, study,
};
use crate::words::wrapped;

/// Accuracies that the printed table answers for.
const ACCURACIES: [f64; 3] = [0.1, 0.01, 0.001];

/// Smaller errors are drawn here: they are rounding.
const SMALLEST_DRAWN: f64 = 1e-9;

/// Ladders within these are sampled frequencies, Hz.
const LADDER_RANGE: std::ops::RangeInclusive<f64> = 10.0..=20_480.0;

/// Compares the methods.
pub fn tradeoff(arguments: &TradeoffArguments, terminal: Terminal) -> Result<Status> {
    use_threads(arguments.jobs, terminal)?;
    let ladder = ladder(&arguments.ladder)?;
    let measures = if arguments.measures.is_empty() {
        Measure::ALL.to_vec()
    } else {
        arguments.measures.clone()
    };
    make_folder(&arguments.out)?;
    let configurations = configurations(&ladder);
    let progress = Progress::new(configurations.len(), 0, arguments.quiet, terminal);
    let studied = study(&configurations, &measures, &|| progress.tick());
    progress.finish();
    let rows = studied?;
    write_atomically(&arguments.out.join("tradeoff.csv"), &table(&rows)?)?;
    draw(&rows, &arguments.out)?;
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

/// Measures that were studied, in order.
fn measures(rows: &[Row]) -> Vec<Measure> {
    let mut measures: Vec<Measure> = rows.iter().map(|row| row.measure).collect();
    measures.dedup();
    measures
}

fn table(rows: &[Row]) -> Result<Vec<u8>> {
    let fronts: Vec<&Row> = (measures(rows).into_iter())
        .flat_map(|measure| front(rows, measure))
        .map(|(row, _)| row)
        .collect();
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "measure",
        "method",
        "gamma",
        "elements_per_cell",
        "transform_s",
        "sampling_frequency_hz",
        "value",
        "reference",
        "reference_uncertainty",
        "relative_error",
        "build_s",
        "step_s_per_simulated_s",
        "cost_1000_cases_s",
        "on_front",
    ])?;
    let optional = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for row in rows {
        let (gamma, elements, transform) = row.configuration.parameters();
        let on_front = fronts.iter().any(|front| std::ptr::eq(*front, row));
        // Of a whole history there is no one value, nor a reference for it.
        let reference = row.value.map(|_| row.reference.value);
        writer.write_record([
            row.measure.name().to_owned(),
            row.configuration.method().to_owned(),
            optional(gamma),
            elements.map_or_else(String::new, |elements| elements.to_string()),
            optional(transform),
            row.configuration.sampling_frequency.to_string(),
            optional(row.value),
            optional(reference),
            row.reference.uncertainty.to_string(),
            optional(row.error),
            row.build_seconds.to_string(),
            row.step_seconds.to_string(),
            row.cost().to_string(),
            if on_front { "yes" } else { "no" }.to_owned(),
        ])?;
    }
    writer.into_inner().context("the table cannot be written")
}

fn draw(rows: &[Row], folder: &Path) -> Result<()> {
    let panels = (measures(rows).into_iter())
        .enumerate()
        .map(|(index, measure)| panel(rows, measure, index % 3 == 0));
    let picture = scatter_grid(&ScatterGrid {
        title: "Accuracy against speed: what each configuration costs, and how far off it is"
            .to_owned(),
        front: "nothing is both cheaper and better".to_owned(),
        floor: "the reference is no surer than this".to_owned(),
        rim: "the paper's own: 640 Hz, filters of 10 s or 20 elements".to_owned(),
        panels: panels.collect(),
    })?;
    save_picture(folder, "tradeoff", &picture)
}

fn panel(rows: &[Row], measure: Measure, is_first: bool) -> ScatterPanel {
    let point = |row: &Row| Some((row.cost(), row.error?.max(SMALLEST_DRAWN)));
    let known = || rows.iter().filter(|row| row.measure == measure);
    let mut kinds: Vec<Points> = Vec::new();
    for row in known() {
        let name = row.configuration.family();
        let kind = match kinds.iter().position(|kind| kind.name == name) {
            Some(kind) => kind,
            None => {
                kinds.push(Points {
                    name: name.to_owned(),
                    points: Vec::new(),
                });
                kinds.len() - 1
            }
        };
        kinds[kind].points.extend(point(row));
    }
    let uncertainty = known().map(|row| row.reference.uncertainty).next();
    let log_axis = |label: &str| Axis {
        label: label.to_owned(),
        logarithmic: true,
    };
    ScatterPanel {
        title: measure.title().to_owned(),
        x: log_axis(&format!("Time for {CASES} cases of {CASE_SECONDS} s (s)")),
        y: log_axis(if is_first { "Relative error" } else { "" }),
        kinds,
        front: (front(rows, measure).into_iter())
            .map(|(row, error)| (row.cost(), error.max(SMALLEST_DRAWN)))
            .collect(),
        rims: known()
            .filter(|row| row.configuration.paper().is_some())
            .filter_map(point)
            .collect(),
        floor: uncertainty.filter(|part| *part > 0.0),
    }
}

fn describe_orders(rows: &[Row]) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    writeln!(text, "observed orders of convergence in 1/f_s")?;
    for measure in measures(rows) {
        let orders = orders(rows, measure);
        if !orders.is_empty() {
            writeln!(text, "  {}", measure.name())?;
        }
        for order in orders {
            writeln!(
                text,
                "    {:42}{:5.2} up to {} Hz",
                order.title, order.order, order.highest
            )?;
        }
    }
    Ok(text)
}

fn describe_cheapest(rows: &[Row], steps: &PaperSteps) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    for accuracy in ACCURACIES {
        let heading = format!(
            "cheapest within {} %: time for {CASES} cases of {CASE_SECONDS} s, and how many times \
             dearer the paper's filters and elements are",
            100.0 * accuracy
        );
        text += &format!("\n{}", wrapped(&heading, 0, 2));
        let answers: Vec<Cheapest> = (measures(rows).into_iter())
            .map(|measure| cheapest(rows, steps, measure, accuracy))
            .collect();
        for answer in &answers {
            writeln!(text, "{}", line(answer))?;
        }
        for (index, paper) in ["filters of 10 s", "20 elements"].iter().enumerate() {
            let tenfold = |ratio: fn(PaperRatio) -> f64| {
                let ratios = answers.iter().filter_map(|answer| answer.paper[index]);
                ratios.filter(|paper| ratio(*paper) >= 10.0).count()
            };
            let words = format!(
                "ten times cheaper than the paper's {paper} at 640 Hz: {} of {} stepped as \
                 here, {} in the paper's own way",
                tenfold(|paper| paper.stepped_here),
                answers.len(),
                tenfold(|paper| paper.own_way)
            );
            text += &wrapped(&words, 2, 4);
        }
    }
    Ok(text)
}

/// One measure: cost, how many times dearer the paper's filters and its elements are,
/// stepped as here, and below them the configuration.
fn line(answer: &Cheapest) -> String {
    let Some(row) = answer.row else {
        return format!("  {:25}none", answer.measure.name());
    };
    let ratio = |paper: Option<PaperRatio>| match paper {
        Some(paper) => format!("×{:.1}", paper.stepped_here),
        None => "–".to_owned(),
    };
    let [filter, elements] = answer.paper;
    let configuration = &row.configuration;
    format!(
        "  {:25}{:>8.3} s   {:>6} {:>6}\n    {} at {} Hz",
        answer.measure.name(),
        row.cost(),
        ratio(filter),
        ratio(elements),
        configuration.title(),
        configuration.sampling_frequency
    )
}
