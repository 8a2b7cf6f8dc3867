//! What an analysis found, as `--json` has it: the rows of the tables of `--out` and `--indices`.

use serde::{Serialize, Serializer};
use sim::Label;

use crate::commands::document::ByColumn;
use results::analysis::{
    Analysis, COUNT_COLUMNS, CountRow, INDEX_COLUMNS, IndexRow, MethodBlocks, count_rows,
    index_rows, more_cases,
};
use results::folder::{ResultTables, SoFar};

/// Counts and indices, and of what.
#[derive(Serialize)]
pub struct AnalysisFound<'a> {
    name: &'a str,
    title: &'a str,
    /// How far the first folder is that is not finished.
    so_far: Option<SoFar>,
    simulations: usize,
    unanswered: usize,
    #[serde(serialize_with = "by_count_column")]
    counts: Vec<CountRow<'a>>,
    /// For intervals of the width asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    more_cases: Option<Vec<MoreCases<'a>>>,
    blocks: &'a [MethodBlocks],
    #[serde(serialize_with = "by_index_column")]
    indices: Vec<IndexRow<'a>>,
    /// What was written.
    files: Vec<String>,
}

/// How many more cases one regime needs.
#[derive(Serialize)]
struct MoreCases<'a> {
    method: &'a str,
    motion: &'static str,
    regime: Label,
    more_cases: usize,
}

impl<'a> AnalysisFound<'a> {
    /// Of the tables of at least one folder.
    pub fn new(
        tables: &'a [ResultTables],
        analysis: &'a Analysis,
        width: Option<f64>,
        files: Vec<String>,
    ) -> Self {
        let manifest = &tables[0].manifest;
        let in_all = &analysis.counts[..1];
        let more_cases = width.map(|width| {
            let rows = count_rows(in_all).into_iter();
            let of_row = |row: CountRow<'a>| MoreCases {
                method: row.method,
                motion: row.motion.adjective(),
                regime: row.regime,
                more_cases: more_cases(row.fraction.value, row.of, width),
            };
            rows.map(of_row).collect()
        });
        Self {
            name: &manifest.name,
            title: &manifest.title,
            so_far: tables.iter().find_map(|tables| tables.so_far),
            simulations: in_all[0].rows,
            unanswered: in_all[0].unanswered,
            counts: count_rows(&analysis.counts),
            more_cases,
            blocks: &analysis.blocks,
            indices: index_rows(&analysis.axes, &analysis.blocks),
            files,
        }
    }
}

fn by_count_column<S: Serializer>(rows: &[CountRow], serializer: S) -> Result<S::Ok, S::Error> {
    ByColumn {
        columns: &COUNT_COLUMNS,
        rows: rows.iter().map(CountRow::fields).collect(),
    }
    .serialize(serializer)
}

fn by_index_column<S: Serializer>(rows: &[IndexRow], serializer: S) -> Result<S::Ok, S::Error> {
    ByColumn {
        columns: &INDEX_COLUMNS,
        rows: rows.iter().map(IndexRow::fields).collect(),
    }
    .serialize(serializer)
}
