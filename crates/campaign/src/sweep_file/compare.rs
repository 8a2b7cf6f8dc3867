//! `[[compare]]`: the keys of what a simulation is held against.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A recorded quantity, and where the simulated one is held against it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareTable {
    /// What is simulated. The speed of the surface is followed with `[string_friction]` alone.
    /// The column is empty where a case ends before `to_s`.
    pub trace: TraceName,
    /// What was recorded: a CSV file or a workbook with a column of times, in the folder of the
    /// file that names it.
    pub file: String,
    /// Its column, in a unit of speed (`speed_rpm`, `RPM (rad/s)`) or of torque (`torque_knm`,
    /// `Torque (kft-lb)`).
    pub column: String,
    /// From when on.
    #[schemars(range(min = 0.0, max = 1e6))]
    pub from_s: f64,
    /// Until when.
    #[schemars(range(min = 0.0, max = 1e6))]
    pub to_s: f64,
    /// What the column of `labels.csv` is called, in letters, digits and `_`: `misfit_fit_nm`
    /// by the name `fit`. Left out, it is called after the trace, `misfit_surface_torque_nm`.
    #[schemars(regex(pattern = "^[A-Za-z0-9_]+$"))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Whether each sample is the least or greatest of a time around it; left out, it is
    /// neither.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub of: Option<Extreme>,
    /// That time.
    #[schemars(range(min = 0.001, max = 1e4))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub over_s: Option<f64>,
}

/// A simulated quantity over time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Extreme {
    /// The least.
    Least,
    /// The greatest.
    Greatest,
}
