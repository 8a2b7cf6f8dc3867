//! Accuracy against speed in words: orders of convergence, and what is cheapest.

use std::fmt::Write;

use super::table::measures;
use campaign::words::wrapped;
use studies::tradeoff::{
    CASE_SECONDS, CASES, Cheapest, PaperRatio, PaperSteps, TradeoffRow, cheapest, orders,
};

/// Accuracies that the printed table answers for.
const ACCURACIES: [f64; 3] = [0.1, 0.01, 0.001];

/// The observed orders.
pub fn describe_orders(rows: &[TradeoffRow]) -> Result<String, std::fmt::Error> {
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
                order.title,
                order.order,
                hertz(order.highest)
            )?;
        }
    }
    Ok(text)
}

/// What is cheapest for some accuracies, and how the paper's own compare.
pub fn describe_cheapest(
    rows: &[TradeoffRow],
    steps: &PaperSteps,
) -> Result<String, std::fmt::Error> {
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
        return format!("  {:32}none", answer.measure.name());
    };
    let ratio = |paper: Option<PaperRatio>| match paper {
        Some(paper) => format!("×{:.1}", paper.stepped_here),
        None => "–".to_owned(),
    };
    let [filter, elements] = answer.paper;
    let configuration = &row.configuration;
    format!(
        "  {:32}{:>8.3} s   {:>6} {:>6}\n    {} at {} Hz",
        answer.measure.name(),
        row.cost(),
        ratio(filter),
        ratio(elements),
        configuration.title(),
        hertz(configuration.sampling_frequency)
    )
}

/// A frequency to a tenth of a hertz.
fn hertz(frequency: f64) -> f64 {
    (10.0 * frequency).round() / 10.0
}
