//! What became of a case by a method: typed, until it is written into a table.

use std::fmt::Display;

use serde::{Deserialize, Serialize};
use sim::Outcome;
use thiserror::Error;

/// Why a case has no answer, in a line of text. It is no enum: most of it are the words
/// of a linear method, of the simulator or of the sweep file, and a log is read long after
/// the errors themselves are gone.
#[derive(Debug, Clone, PartialEq, Eq, Error, Serialize, Deserialize)]
#[serde(transparent)]
#[error("{0}")]
pub struct Failure(String);

impl Failure {
    /// In the words of an error or of a table.
    pub fn new(reason: impl Display) -> Self {
        Self((reason.to_string()).replace(|letter: char| letter.is_control(), " "))
    }

    /// The line.
    pub fn text(&self) -> &str {
        &self.0
    }
}

/// A case done by one method.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Number of the case.
    pub case: usize,
    /// The method's place in the sweep's list.
    pub method: usize,
    /// The case's values along the axes.
    pub values: Vec<f64>,
    /// T_d, N m, where the bit is modelled.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque_dynamic_nm: Option<f64>,
    /// How far above the analytic limit of stick-slip (Eq. 74) the surface turns, rad/s, below
    /// where negative; none where there is none, or where the bit is not all that rubs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub above_limit: Option<f64>,
    /// The site that decides the lateral label, m from the bit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub site_from_bit_m: Option<f64>,
    /// How far it is from what was recorded, in the order of the comparisons; none where it does
    /// not reach that.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub misfits: Vec<Option<f64>>,
    /// What came out, or why nothing did.
    pub outcome: Result<Outcome, Failure>,
}

impl Record {
    /// Of a case without an answer.
    pub fn failed(case: usize, method: usize, values: Vec<f64>, reason: Failure) -> Self {
        Self {
            case,
            method,
            values,
            torque_dynamic_nm: None,
            above_limit: None,
            site_from_bit_m: None,
            misfits: Vec::new(),
            outcome: Err(reason),
        }
    }
}
