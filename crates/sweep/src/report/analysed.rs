//! How often each regime occurs, how sure that is and which axis decides, in words and tables.

use sim::Label;

use super::bars::interval_bars;
use super::deciding;
use super::document::{Block, Section, Table};
use super::phrases::capital;
use super::ranges::range_chart;
use campaign::quantities::Units;
use campaign::sweep_file::DesignKind;
use campaign::words::{counted, short};
use results::analysis::{Bins, Counts, Interval, MethodBlocks, more_cases, wilson};
use results::folder::Manifest;

/// The sections about counts: the first in all, then over each axis, then those asked for, which
/// are shown instead of the others; and of the axes, from blocks of cases if they are such.
pub fn analysed_sections(
    manifest: &Manifest,
    all: &[Counts],
    blocks: &[MethodBlocks],
    width: Option<f64>,
) -> Vec<Section> {
    let axes = manifest.axes.len();
    let shown = if all.len() > 1 + axes {
        &all[1 + axes..]
    } else {
        &all[1..]
    };
    let kind = manifest.sweep.design.as_ref().map(|design| design.kind);
    let mut in_all = regimes(&all[0], width);
    in_all.extend(notes(manifest, kind).map(|note| Block::Text(note.to_owned())));
    let mut sections = vec![("Regimes", in_all)];
    let units = manifest.sweep.units;
    let over: Vec<Block> = shown
        .iter()
        .flat_map(|counts| cells(counts, units))
        .collect();
    if !over.is_empty() {
        sections.push(("Where", over));
    }
    match kind {
        Some(DesignKind::MonteCarlo) if axes > 1 => {
            sections.push(("What decides", deciding::of_cases(manifest, &all[1..=axes])));
        }
        Some(DesignKind::Sensitivity) => {
            sections.push(("What decides", deciding::of_blocks(manifest, blocks)));
        }
        _ => {}
    }
    sections
}

/// What intervals that hold for independent cases say of these.
fn notes(manifest: &Manifest, kind: Option<DesignKind>) -> impl Iterator<Item = &'static str> {
    let is_random = kind.is_some_and(DesignKind::is_random);
    let not_random = "These cases were not drawn at random: intervals are those that as many \
                      random ones would have.";
    let of_blocks = "Only the two independent points of each block of cases are counted; the \
                     others repeat their values.";
    let even = "Sobol points are more even than independent ones, which these intervals hold \
                for: they are usually wider than need be.";
    [
        (!is_random, not_random),
        (kind == Some(DesignKind::Sensitivity), of_blocks),
        (manifest.sweep.has_sobol_points(), even),
    ]
    .into_iter()
    .filter_map(|(is_so, note)| is_so.then_some(note))
}

fn part(value: f64) -> String {
    format!("{:.1} %", 100.0 * value)
}

fn ends(interval: Interval) -> [String; 3] {
    [interval.value, interval.low, interval.high].map(part)
}

fn regimes(counts: &Counts, width: Option<f64>) -> Vec<Block> {
    let mut header = vec!["method", "regime", "cases", "part", "from", "to"];
    if width.is_some() {
        header.push("more cases");
    }
    let caption = "How often, with 95 % intervals";
    let mut table = Table::new(caption, header);
    let mut bars: Vec<(String, [f64; 3])> = Vec::new();
    for (method, motion, group) in &counts.groups {
        for label in Label::all(*motion) {
            let Some(count) = group.labels.get(&label).map(|cells| cells[0]) else {
                continue;
            };
            let Some(interval) = wilson(count, group.all[0]) else {
                continue;
            };
            let name = format!("{} by {method}", label.name().replace('_', " "));
            bars.push((
                capital(&name),
                [interval.value, interval.low, interval.high],
            ));
            let mut cells = vec![method.clone(), label.name().to_owned(), count.to_string()];
            cells.extend(ends(interval));
            cells.extend(
                width.map(|width| more_cases(interval.value, group.all[0], width).to_string()),
            );
            table.rows.push(cells);
        }
    }
    let unanswered = match counts.unanswered {
        0 => "every one has an answer".to_owned(),
        count => format!("{count} of them have no answer, and are not counted"),
    };
    let mut blocks = vec![
        Block::Text(format!(
            "{}; {unanswered}.",
            counted(counts.rows, "simulation")
        )),
        Block::Picture {
            html: interval_bars(caption, bars.iter().map(|(name, it)| (name.as_str(), *it))),
            table,
        },
    ];
    if let Some(width) = width {
        blocks.push(Block::Text(format!(
            "The last column is the number of further cases for an interval no wider than {}, at \
             the same fraction. A run \
             whose `cases` are raised continues from the existing ones.",
            part(width)
        )));
    }
    blocks
}

/// A table for each method and motion: over one axis in rows, over two in rows and columns.
fn cells(counts: &Counts, units: Units) -> Vec<Block> {
    let tables = counts.groups.iter().map(|(method, motion, group)| {
        let sustained = group.sustained();
        let description = format!("{} by {method}", motion.regimes()[0]);
        match &counts.bins[..] {
            [x, y] => Block::Table(over_two(&description, [x, y], &sustained, units)),
            [bins, ..] => Block::Picture {
                html: range_chart(method, *motion, bins, &sustained, units),
                table: over_one(&description, bins, &sustained, units),
            },
            [] => Block::Text(String::new()),
        }
    });
    tables.collect()
}

/// A range of an axis in some units.
fn range_text(bins: &Bins, [from, to]: [f64; 2], units: Units) -> String {
    let unit = bins.axis.unit(units);
    let [low, high] = [from, to].map(|end| short(unit.number(end)));
    if from == to {
        low
    } else {
        format!("{low} to {high}")
    }
}

fn over_one(description: &str, bins: &Bins, sustained: &[[usize; 2]], units: Units) -> Table {
    let caption = format!("{} over {}", capital(description), bins.axis.title(units));
    let mut table = Table::new(caption, ["range", "cases", "part", "from", "to"]);
    for (cell, range) in bins.ranges.iter().enumerate() {
        let [count, classified] = sustained[cell];
        let Some(interval) = wilson(count, classified) else {
            continue;
        };
        let mut cells = vec![range_text(bins, *range, units), classified.to_string()];
        cells.extend(ends(interval));
        table.rows.push(cells);
    }
    table
}

/// Cells are named by where they begin: their ends would not fit a line.
fn over_two(
    description: &str,
    [x, y]: [&Bins; 2],
    sustained: &[[usize; 2]],
    units: Units,
) -> Table {
    let [right, up] = [x, y].map(|bins| bins.axis.title(units));
    let caption = format!(
        "{}, fraction of the cases, in cells named by their lower ends; to the right {right}, \
         upwards {up}",
        capital(description)
    );
    let begin = |bins: &Bins, range: &[f64; 2]| short(bins.axis.unit(units).number(range[0]));
    let columns = x.ranges.iter().map(|range| begin(x, range));
    let mut table = Table::new(caption, std::iter::once(String::new()).chain(columns));
    for (row, range) in y.ranges.iter().enumerate().rev() {
        let parts = (0..x.ranges.len()).map(|column| {
            let [count, classified] = sustained[column * y.ranges.len() + row];
            let interval = wilson(count, classified);
            interval.map_or_else(|| "–".to_owned(), |it| format!("{:.0} %", 100.0 * it.value))
        });
        let cells = std::iter::once(begin(y, range)).chain(parts);
        table.rows.push(cells.collect());
    }
    table
}
