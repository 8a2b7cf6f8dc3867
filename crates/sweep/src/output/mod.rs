//! The files of a results folder.

mod about;
mod boundary;
mod cases;
mod column_words;
mod curves;
mod envelope;
mod failures;
mod forward_contact;
mod integrity;
mod label_rows;
mod manifest;
mod many_sites_limit;
mod records;
mod results;
mod sliding_together;
mod tables;
mod tally;
mod trace_summary;
mod whirl_limit;

pub use crate::files::write_atomically;
pub use about::About;
pub use boundary::{Boundary, StickSlipPoint, boundary, boundary_csv, exact_stick_slip_limit};
pub use campaign::labels::LabelTable;
pub use campaign::results::Certainty;
pub use cases::{CaseRows, read_cases, read_measured_cases};
pub use column_words::column_words;
pub use curves::Curve;
pub use envelope::Envelope;
pub use failures::FAILURES_HEADER;
pub use forward_contact::ForwardContact;
pub use integrity::{Damage, OF_TRACE, PAPER_MAP, PICTURES, TABLES};
pub use label_rows::{LabelColumns, LabelRow, label_rows, misfit_columns, read_labels};
pub use manifest::{Manifest, MethodRecord, differences, fingerprint};
pub use many_sites_limit::{MOST_SITES, many_sites_limit};
pub use records::{RECORDS, RecordWriter, read_records};
pub use results::TableWriter;
pub use tables::ResultTables;
pub use tally::Tally;
pub use trace_summary::{LimitSummary, TraceSummary};
pub use whirl_limit::{
    WhirlMotion, rolling_bound, rolling_envelope, rolling_whirls, whirl_from, whirl_limit,
};
