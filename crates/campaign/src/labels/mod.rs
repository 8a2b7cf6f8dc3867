//! `labels.csv`: the columns and rows of a sweep.

mod certified_by;
mod history;
mod table;

pub use certified_by::CertifiedBy;
pub use history::{HistoryColumn, history_columns};
pub use table::{LabelTable, shows_found, shows_string_torque, shows_surface, shows_torque};
