//! The files of a results folder.

mod about;
mod cases;
mod column_words;
mod failures;
mod integrity;
mod label_rows;
mod manifest;
mod open;
mod records;
mod results;
mod tables;
mod tally;
mod trace_summary;

pub use about::About;
pub use cases::{CaseRows, read_cases, read_measured_cases};
pub use column_words::column_words;
pub use failures::FAILURES_HEADER;
pub use integrity::{Damage, OF_TRACE, PAPER_MAP, PICTURES, TABLES};
pub use label_rows::{LabelColumns, LabelRow, label_rows, misfit_columns, read_labels};
pub use manifest::{Manifest, MethodRecord, differences, fingerprint};
pub use open::{LOG, MANIFEST, NoResults, damaged, refuse_empty};
pub use records::{RECORDS, RecordWriter, read_records};
pub use results::TableWriter;
pub use tables::ResultTables;
pub use tally::Tally;
pub use trace_summary::{LimitSummary, TraceSummary};
