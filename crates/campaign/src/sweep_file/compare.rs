//! `[[compare]]`: the keys of what a simulation is held against.

use serde::{Deserialize, Serialize};

/// A recorded quantity, and where the simulated one is held against it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CompareTable {
    /// What is simulated.
    pub trace: TraceName,
    /// CSV file or workbook of what was recorded, with a column of times.
    pub file: String,
    /// Its column, whose name ends in the unit.
    pub column: String,
    /// From when on, s.
    pub from_s: f64,
    /// Until when, s.
    pub to_s: f64,
    /// What its misfit is called. Default: the trace without its unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Whether the recording has the least or the greatest of a time around each sample, of so
    /// many seconds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub of: Option<Extreme>,
    /// That time, s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub over_s: Option<f64>,
}

/// A simulated quantity over time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TraceName {
    /// Speed of the bit.
    BitSpeedRpm,
    /// Speed of the surface.
    SurfaceSpeedRpm,
    /// Torque that turns the surface, of a top drive its motor's.
    SurfaceTorqueNm,
}

/// An end of a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Extreme {
    /// The least.
    Least,
    /// The greatest.
    Greatest,
}
