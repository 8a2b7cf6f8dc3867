//! All counts as CSV, tidy: a row for each set of axes, cell, method and regime; and Sobol's indices,
//! a row for each method, quantity and axis.

use std::fmt::Write;

use campaign::quantities::Axis;
use results::analysis::{Counts, MethodBlocks, count_rows, index_rows};

/// Columns of the counts.
pub const COUNTS: &str =
    "method,motion,regime,x,x_from,x_to,y,y_from,y_to,cases,of,fraction,low,high\n";

/// Columns of the indices.
pub const INDICES: &str =
    "method,quantity,axis,blocks,first,first_low,first_high,total,total_low,total_high\n";

/// The table; axes that a row is not counted over are empty.
pub fn counts_csv(all: &[Counts]) -> String {
    let mut text = COUNTS.to_owned();
    for row in count_rows(all) {
        let mut place: Vec<String> = (row.cell.iter())
            .flat_map(|(axis, [from, to])| [axis.name(), from.to_string(), to.to_string()])
            .collect();
        place.resize(6, String::new());
        let (method, motion, regime) = (row.method, row.motion.adjective(), row.regime.name());
        let (place, part) = (place.join(","), row.fraction);
        let (cases, of, value, low, high) = (row.cases, row.of, part.value, part.low, part.high);
        // A string takes all that is written into it.
        let _ = writeln!(
            text,
            "{method},{motion},{regime},{place},{cases},{of},{value},{low},{high}"
        );
    }
    text
}

/// The indices of what can be told, of first order and of all, each with its interval.
pub fn indices_csv(axes: &[Axis], methods: &[MethodBlocks]) -> String {
    let mut text = INDICES.to_owned();
    for row in index_rows(axes, methods) {
        let (method, quantity, axis) = (row.method, row.quantity, row.axis.name());
        let _ = write!(text, "{method},{quantity},{axis},{}", row.blocks);
        for interval in [row.first, row.total] {
            let (value, low, high) = (interval.value, interval.low, interval.high);
            let _ = write!(text, ",{value},{low},{high}");
        }
        text.push('\n');
    }
    text
}
