//! All counts as CSV, tidy: a row for each set of axes, cell, method and regime.

use std::fmt::Write;

use crate::analysis::{Counts, wilson};

/// The table; axes that a row is not counted over are empty.
pub fn counts_csv(all: &[Counts]) -> String {
    let mut text =
        "method,motion,regime,x,x_from,x_to,y,y_from,y_to,cases,of,fraction,low,high\n".to_owned();
    for counts in all {
        for (method, motion, group) in &counts.groups {
            for (cell, &of) in group.all.iter().enumerate() {
                let Some(place) = (of > 0).then(|| place(counts, cell)) else {
                    continue;
                };
                for label in motion.labels() {
                    let in_cell = group.labels.get(&label).map_or(0, |cells| cells[cell]);
                    let Some(part) = wilson(in_cell, of) else {
                        continue;
                    };
                    let (motion, label) = (motion.adjective(), label.name());
                    let (value, low, high) = (part.value, part.low, part.high);
                    // A string takes all that is written into it.
                    let _ = writeln!(
                        text,
                        "{method},{motion},{label},{place},{in_cell},{of},{value},{low},{high}"
                    );
                }
            }
        }
    }
    text
}

/// The axes of a cell and its ends along them.
fn place(counts: &Counts, cell: usize) -> String {
    let ranges = counts.ranges(cell);
    let mut fields: Vec<String> = (counts.bins.iter().zip(ranges))
        .flat_map(|(bins, [from, to])| [bins.axis.name(), from.to_string(), to.to_string()])
        .collect();
    fields.resize(6, String::new());
    fields.join(",")
}
