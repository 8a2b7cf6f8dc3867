//! How the limits of a traced design were found, in a manifest.

use serde::{Deserialize, Serialize};

/// How the limits of a design were traced.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TraceSummary {
    /// Cases that were simulated.
    pub simulated: usize,
    /// Cases of a grid as fine.
    pub cases_of_grid: usize,
    /// A step along the limits as a part of either axis, in the order of the columns.
    pub steps: [f64; 2],
    /// The limits of each motion that has labels by each method.
    pub limits: Vec<LimitSummary>,
}

/// What was found of the limits of a motion by a method.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LimitSummary {
    /// The method.
    pub method: String,
    /// The motion.
    pub motion: String,
    /// Lines in `limits.csv`.
    pub lines: usize,
    /// Tiles in `bands.csv`.
    pub tiles: usize,
    /// The fraction of the area of the design that they cover.
    pub ragged_part: f64,
}
