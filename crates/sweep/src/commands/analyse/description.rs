//! What was counted, in words and tables.

use crate::analysis::{Bins, Counts, Group, Interval, cases_for, sensitivity, wilson};
use crate::output::{Manifest, is_sustained};
use crate::quantities::Units;
use crate::report::{Block, Section, Table};
use crate::sweep_file::DesignKind;
use crate::words::{counted, short};

/// The sections about counts: the first in all, then over each axis, then those asked for, which
/// are shown instead of the others.
pub fn sections(
    manifest: &Manifest,
    rows: usize,
    all: &[Counts],
    width: Option<f64>,
) -> Vec<Section> {
    let axes = manifest.axes.len();
    let shown = if all.len() > 1 + axes {
        &all[1 + axes..]
    } else {
        &all[1..]
    };
    let is_random = (manifest.sweep.design.as_ref())
        .is_some_and(|design| design.kind == DesignKind::MonteCarlo);
    let mut in_all = regimes(rows, &all[0], width);
    if !is_random {
        let note = "These cases were not drawn at random: intervals are those that as many random \
                    ones would have.";
        in_all.push(Block::Text(note.to_owned()));
    }
    let mut sections = vec![("Regimes", in_all)];
    let units = manifest.sweep.units;
    let over: Vec<Block> = shown
        .iter()
        .flat_map(|counts| cells(counts, units))
        .collect();
    if !over.is_empty() {
        sections.push(("Where", over));
    }
    if is_random && axes > 1 {
        sections.push(("What decides", deciding(manifest, &all[1..=axes])));
    }
    sections
}

/// How many of the rows in each cell have sustained vibration, of those long enough to tell.
fn sustained(group: &Group) -> Vec<[usize; 2]> {
    let mut cells = vec![[0; 2]; group.all.len()];
    for (label, counts) in &group.labels {
        let Some(is_sustained) = is_sustained(*label) else {
            continue;
        };
        for ([sustained, told], count) in cells.iter_mut().zip(counts) {
            *told += count;
            *sustained += if is_sustained { *count } else { 0 };
        }
    }
    cells
}

fn part(value: f64) -> String {
    format!("{:.1} %", 100.0 * value)
}

fn ends(interval: Interval) -> [String; 3] {
    [interval.value, interval.low, interval.high].map(part)
}

fn regimes(rows: usize, counts: &Counts, width: Option<f64>) -> Vec<Block> {
    let mut header = vec!["method", "regime", "cases", "part", "from", "to"];
    if width.is_some() {
        header.push("more cases");
    }
    let mut table = Table::new("How often, with 95 % intervals", header);
    for (method, motion, group) in &counts.groups {
        for label in motion.labels() {
            let Some(count) = group.labels.get(&label).map(|cells| cells[0]) else {
                continue;
            };
            let Some(interval) = wilson(count, group.all[0]) else {
                continue;
            };
            let mut cells = vec![method.clone(), label.name().to_owned(), count.to_string()];
            cells.extend(ends(interval));
            cells.extend(width.map(|width| {
                let needed = cases_for(interval.value, width);
                needed.saturating_sub(group.all[0]).to_string()
            }));
            table.rows.push(cells);
        }
    }
    let unanswered = match counts.unanswered {
        0 => "every one has an answer".to_owned(),
        count => format!("{count} of them have no answer, and are not counted"),
    };
    let mut blocks = vec![
        Block::Text(format!("{}; {unanswered}.", counted(rows, "simulation"))),
        Block::Table(table),
    ];
    if let Some(width) = width {
        blocks.push(Block::Text(format!(
            "So many more make an interval no wider than {}, if the part stays what it is. A run \
             whose `cases` are raised goes on from what is there.",
            part(width)
        )));
    }
    blocks
}

/// A table for each method and motion: over one axis in rows, over two in rows and columns.
fn cells(counts: &Counts, units: Units) -> Vec<Block> {
    let tables = counts.groups.iter().map(|(method, motion, group)| {
        let sustained = sustained(group);
        let of_what = format!("{} by {method}", motion.regimes()[0]);
        Block::Table(match &counts.bins[..] {
            [x, y] => over_two(&of_what, [x, y], &sustained, units),
            _ => over_one(&of_what, &counts.bins[0], &sustained, units),
        })
    });
    tables.collect()
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
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

fn over_one(of_what: &str, bins: &Bins, sustained: &[[usize; 2]], units: Units) -> Table {
    let caption = format!("{} over {}", capital(of_what), bins.axis.title(units));
    let mut table = Table::new(caption, ["range", "cases", "part", "from", "to"]);
    for (cell, range) in bins.ranges.iter().enumerate() {
        let [count, told] = sustained[cell];
        let Some(interval) = wilson(count, told) else {
            continue;
        };
        let mut cells = vec![range_text(bins, *range, units), told.to_string()];
        cells.extend(ends(interval));
        table.rows.push(cells);
    }
    table
}

/// Cells are named by where they begin: their ends would not fit a line.
fn over_two(of_what: &str, [x, y]: [&Bins; 2], sustained: &[[usize; 2]], units: Units) -> Table {
    let [right, up] = [x, y].map(|bins| bins.axis.title(units));
    let caption = format!(
        "{}, part of the cases, in cells that begin at so much; to the right {right}, upwards {up}",
        capital(of_what)
    );
    let begin = |bins: &Bins, range: &[f64; 2]| short(bins.axis.unit(units).number(range[0]));
    let columns = x.ranges.iter().map(|range| begin(x, range));
    let mut table = Table::new(caption, std::iter::once(String::new()).chain(columns));
    for (row, range) in y.ranges.iter().enumerate().rev() {
        let parts = (0..x.ranges.len()).map(|column| {
            let [count, told] = sustained[column * y.ranges.len() + row];
            let interval = wilson(count, told);
            interval.map_or_else(|| "–".to_owned(), |it| format!("{:.0} %", 100.0 * it.value))
        });
        let cells = std::iter::once(begin(y, range)).chain(parts);
        table.rows.push(cells.collect());
    }
    table
}

fn deciding(manifest: &Manifest, of_axes: &[Counts]) -> Vec<Block> {
    let caption = "First-order indices of Sobol: the part of the variance that an axis explains \
                   alone, with 95 % intervals";
    let header = ["method", "motion", "axis", "index", "from", "to"];
    let mut table = Table::new(caption, header);
    let groups = of_axes.first().map_or(&[][..], |counts| &counts.groups);
    for (index, (method, motion, _)) in groups.iter().enumerate() {
        let mut rows: Vec<(f64, Vec<String>)> = Vec::new();
        for counts in of_axes {
            let (_, _, group) = &counts.groups[index];
            let Some(found) = sensitivity(&sustained(group)) else {
                continue;
            };
            let mut row = vec![
                method.clone(),
                motion.adjective().to_owned(),
                counts.bins[0].axis.name_in(manifest.sweep.units),
            ];
            row.extend([found.value, found.low, found.high].map(|it| format!("{it:.3}")));
            rows.push((found.value, row));
        }
        rows.sort_by(|one, other| other.0.total_cmp(&one.0));
        table.rows.extend(rows.into_iter().map(|(_, row)| row));
    }
    if table.rows.is_empty() {
        return vec![Block::Text("All cases are alike.".to_owned())];
    }
    let is_correlated =
        (manifest.sweep.design.as_ref()).is_some_and(|design| !design.correlations.is_empty());
    let note = if is_correlated {
        "Axes that are correlated explain what goes with them, too: their indices are not apart."
    } else {
        "What they lack to 1 in all is what axes do together, and what differs within a range."
    };
    vec![Block::Table(table), Block::Text(note.to_owned())]
}
