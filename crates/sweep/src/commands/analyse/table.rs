//! All counts as CSV, tidy: a row for each set of axes, cell, method and regime; and Sobol's indices,
//! a row for each method, quantity and axis.

use std::fmt::Write;

use sim::{Label, TorsionRegime};

use campaign::quantities::Axis;
use results::analysis::{Counts, MethodBlocks, wilson};

const BISTABLE: Label = Label::Torsion(TorsionRegime::Bistable);

/// Columns of the counts.
pub const COUNTS: &str =
    "method,motion,regime,x,x_from,x_to,y,y_from,y_to,cases,of,fraction,low,high\n";

/// Columns of the indices.
pub const INDICES: &str =
    "method,quantity,axis,blocks,first,first_low,first_high,total,total_low,total_high\n";

/// The table; axes that a row is not counted over are empty.
pub fn counts_csv(all: &[Counts]) -> String {
    let mut text = COUNTS.to_owned();
    for counts in all {
        for (method, motion, group) in &counts.groups {
            for (cell, &of) in group.all.iter().enumerate() {
                let Some(place) = (of > 0).then(|| place(counts, cell)) else {
                    continue;
                };
                // Of a label that only cases with two starts have, where there are any.
                let is_listed =
                    |label: &Label| *label != BISTABLE || group.labels.contains_key(label);
                for label in Label::all(*motion).into_iter().filter(is_listed) {
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

/// The indices that can be estimated, of first order and total, each with its interval.
pub fn indices_csv(axes: &[Axis], methods: &[MethodBlocks]) -> String {
    let mut text = INDICES.to_owned();
    for of_method in methods {
        for (quantity, blocks) in &of_method.quantities {
            let found = blocks.indices(quantity.is_either()).unwrap_or_default();
            for (axis, indices) in axes.iter().zip(found) {
                let (method, quantity) = (&of_method.method, quantity.name());
                let (axis, count) = (axis.name(), blocks.count);
                let _ = write!(text, "{method},{quantity},{axis},{count}");
                for interval in [indices.first, indices.total] {
                    let (value, low, high) = (interval.value, interval.low, interval.high);
                    let _ = write!(text, ",{value},{low},{high}");
                }
                text.push('\n');
            }
        }
    }
    text
}
