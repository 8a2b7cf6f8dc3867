//! Which axis decides, in words and tables: from cases as they were drawn, or from blocks of them
//! that were made to tell.

use super::bars::interval_bars;
use super::document::{Block, Table};
use super::phrases::{capital, plain};
use campaign::words::counted;
use results::analysis::{
    Counts, DRAWN, IndexUnavailable, Indices, LEAST_BLOCKS, MethodBlocks, sensitivity,
};
use results::folder::Manifest;

/// From counts over each axis.
pub fn of_cases(manifest: &Manifest, of_axes: &[Counts]) -> Vec<Block> {
    let caption = "First-order indices of Sobol: the fraction of the variance that an axis \
                   explains \
                   alone, with 95 % intervals";
    let header = ["method", "motion", "axis", "index", "from", "to"];
    let mut table = Table::new(caption, header);
    let mut html = String::new();
    let units = manifest.sweep.units;
    let groups = of_axes.first().map_or(&[][..], |counts| &counts.groups);
    for (index, (method, motion, _)) in groups.iter().enumerate() {
        let mut rows: Vec<(f64, Vec<String>)> = Vec::new();
        let mut bars: Vec<(String, [f64; 3])> = Vec::new();
        for counts in of_axes {
            let (_, _, group) = &counts.groups[index];
            let Some(found) = sensitivity(&group.sustained()) else {
                continue;
            };
            let mut row = vec![
                method.clone(),
                motion.adjective().to_owned(),
                counts.bins[0].axis.name_in(manifest.sweep.units),
            ];
            row.extend([found.value, found.low, found.high].map(|it| format!("{it:.3}")));
            rows.push((found.value, row));
            let name = capital(&plain(counts.bins[0].axis, units));
            bars.push((name, [found.value, found.low, found.high]));
        }
        rows.sort_by(|one, other| other.0.total_cmp(&one.0));
        bars.sort_by(|one, other| other.1[0].total_cmp(&one.1[0]));
        let [regime, _] = motion.regimes();
        let caption = format!("What decides {regime} by {method}: variance explained alone");
        let bars = bars.iter().map(|(name, values)| (name.as_str(), *values));
        html += &interval_bars(&caption, bars);
        table.rows.extend(rows.into_iter().map(|(_, row)| row));
    }
    if table.rows.is_empty() {
        return vec![Block::Text("All cases are alike.".to_owned())];
    }
    let design = manifest.sweep.design.as_ref();
    let note = if design.is_some_and(|design| !design.correlations.is_empty()) {
        "Axes that are correlated explain what goes with them, too: their indices are not apart."
    } else {
        "What they lack to 1 in all is what axes do together, and what differs within a range."
    };
    vec![Block::Picture { html, table }, Block::Text(note.to_owned())]
}

/// From the blocks of a sensitivity design, for each method and quantity.
pub fn of_blocks(manifest: &Manifest, methods: &[MethodBlocks]) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut are_tables = false;
    for of_method in methods {
        blocks.push(Block::Text(blocks_text(of_method)));
        for (quantity, of_quantity) in of_method.different() {
            let name = format!("{} by {}", quantity.name(), of_method.method);
            match of_quantity.indices(quantity.is_either()) {
                Ok(found) => {
                    are_tables = true;
                    let name = match of_quantity.count == of_method.whole {
                        true => name,
                        false => format!("{name}, of {} that have it", of_quantity.count),
                    };
                    let html = in_bars(manifest, &name, &found);
                    let table = table(manifest, name, &found);
                    blocks.push(Block::Picture { html, table });
                }
                Err(IndexUnavailable::Rare(count)) => blocks.push(Block::Text(format!(
                    "{name}: {count} independent cases alone differ from the others, too few to \
                     tell."
                ))),
                Err(IndexUnavailable::Alike | IndexUnavailable::FewBlocks) => {}
            }
        }
    }
    if are_tables {
        let mut note = format!(
            "Of the variance of each, the fraction that an axis explains alone (first order, by \
             Saltelli 2010) and in all, with what it does together with others (by Jansen 1999), \
             with 95 % intervals from {DRAWN} draws of the blocks anew. What the first lack to 1 \
             together is what axes only do together; an axis that is 0 in all may be fixed."
        );
        if manifest.sweep.has_sobol_points() {
            note += " Blocks at Sobol points are not independent of one another: of a thousand or \
                     more these intervals are usually wider than need be, of few they may be too \
                     narrow.";
        }
        blocks.push(Block::Text(note));
    } else {
        let reason = format!("All cases are alike, or there are fewer than {LEAST_BLOCKS} blocks.");
        blocks.push(Block::Text(reason));
    }
    blocks
}

fn blocks_text(of_method: &MethodBlocks) -> String {
    let whole = counted(of_method.whole, "whole block");
    let mut text = format!("{whole} of cases by {}", of_method.method);
    if of_method.failed > 0 {
        let left_out = of_method.failed;
        text += &format!("; {left_out} left out, for a case of each has no answer");
    }
    if of_method.unfinished > 0 {
        text += &format!("; {} not finished", of_method.unfinished);
    }
    text + "."
}

/// What each axis explains in all, that first which explains most.
fn in_bars(manifest: &Manifest, name: &str, found: &[Indices]) -> String {
    let names = manifest.axes.iter();
    let names = names.map(|&axis| capital(&plain(axis, manifest.sweep.units)));
    let mut bars: Vec<(String, [f64; 3])> = names
        .zip(found)
        .map(|(name, indices)| {
            let total = indices.total;
            (name, [total.value, total.low, total.high])
        })
        .collect();
    bars.sort_by(|one, other| other.1[0].total_cmp(&one.1[0]));
    let bars = bars.iter().map(|(name, values)| (name.as_str(), *values));
    let caption = format!("{}: variance explained in all", capital(name));
    interval_bars(&caption, bars)
}

/// The axes of one quantity, that first which does most.
fn table(manifest: &Manifest, caption: String, found: &[Indices]) -> Table {
    let header = ["axis", "alone", "from", "to", "in all", "from", "to"];
    let mut table = Table::new(caption, header);
    let mut rows: Vec<_> = manifest.axes.iter().zip(found).collect();
    rows.sort_by(|one, other| other.1.total.value.total_cmp(&one.1.total.value));
    for (axis, indices) in rows {
        let mut row = vec![axis.name_in(manifest.sweep.units)];
        for interval in [indices.first, indices.total] {
            let numbers = [interval.value, interval.low, interval.high];
            row.extend(numbers.map(|it| format!("{it:.3}")));
        }
        table.rows.push(row);
    }
    table
}
