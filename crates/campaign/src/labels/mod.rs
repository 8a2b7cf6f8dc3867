//! What is told of a case by a method in a row of `labels.csv`.

mod certainty;
mod history;
mod motion;
mod table;

pub use certainty::{Certainty, CertifiedBy};
pub use history::{Column, history_columns};
pub use motion::{Labels, Motion, is_sustained};
pub use table::{
    FAILED, LATERAL_COLUMNS, LabelTable, TORSION_COLUMNS, shows_found, shows_string_torque,
    shows_surface, shows_torque, to_kn, to_mm, to_turns,
};
