//! The files of a results folder.

mod about;
mod cases;
mod column_words;
mod failures;
mod integrity;
mod label_row;
mod label_rows;
mod manifest;
mod open;
mod recorded_rows;
mod records;
mod results;
mod tables;
mod tally;
mod trace_summary;
mod typed_rows;

pub use about::About;
pub use cases::{CaseRows, FoundByMethods, read_cases, read_measured_cases};
pub use column_words::column_words;
pub use failures::FAILURES_HEADER;
pub use integrity::{Damage, OF_TRACE, PAPER_MAP, PICTURES, TABLES};
pub use label_row::LabelRow;
pub use label_rows::{LabelColumns, label_rows, misfit_columns, read_labels};
pub use manifest::{Manifest, MethodRecord, differences, fingerprint};
pub use open::{LOG, MANIFEST, NoResults, damaged, refuse_empty};
pub use records::{RECORDS, RecordWriter, read_records};
pub use results::TableWriter;
pub use tables::{ResultTables, SoFar};
pub use tally::Tally;
pub use trace_summary::{LimitSummary, TraceSummary};
pub use typed_rows::{TypedColumns, TypedRow, typed_rows};
