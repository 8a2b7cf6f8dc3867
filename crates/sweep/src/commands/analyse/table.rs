//! All counts as CSV, tidy: a row for each set of axes, cell, method and regime; and Sobol's indices,
//! a row for each method, quantity and axis. No field needs quotes: they are names and numbers.

use campaign::quantities::Axis;
use campaign::records::{Field, Kind};
use results::analysis::{
    COUNT_COLUMNS, Counts, INDEX_COLUMNS, MethodBlocks, count_rows, index_rows,
};

/// The first line of the counts.
pub fn counts_header() -> String {
    header(&COUNT_COLUMNS)
}

/// The first line of the indices.
pub fn indices_header() -> String {
    header(&INDEX_COLUMNS)
}

/// The table; axes that a row is not counted over are empty.
pub fn counts_csv(all: &[Counts]) -> String {
    let rows = count_rows(all);
    let lines = rows.iter().map(|row| line(&row.fields()));
    counts_header() + &lines.collect::<String>()
}

/// The indices that can be estimated, of first order and total, each with its interval.
pub fn indices_csv(axes: &[Axis], methods: &[MethodBlocks]) -> String {
    let rows = index_rows(axes, methods);
    let lines = rows.iter().map(|row| line(&row.fields()));
    indices_header() + &lines.collect::<String>()
}

fn header(columns: &[(&str, Kind)]) -> String {
    let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
    names.join(",") + "\n"
}

fn line(fields: &[Field]) -> String {
    let fields: Vec<String> = fields.iter().map(Field::to_string).collect();
    fields.join(",") + "\n"
}
