//! What became of a case by a method: typed, until it is written into a table.

use serde::{Deserialize, Serialize};
use sim::Outcome;

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
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub torque_dynamic_nm: Option<f64>,
    /// The site that decides the lateral label, m from the bit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub site_from_bit_m: Option<f64>,
    /// What came out, or why nothing did.
    pub outcome: Result<Outcome, String>,
}

impl Record {
    /// Of a case without an answer; the reason is a line of text.
    pub fn failed(case: usize, method: usize, values: Vec<f64>, reason: &str) -> Self {
        Self {
            case,
            method,
            values,
            torque_dynamic_nm: None,
            site_from_bit_m: None,
            outcome: Err(reason.replace(|letter: char| letter.is_control(), " ")),
        }
    }

    /// Why there is no answer.
    pub fn reason(&self) -> Option<&str> {
        self.outcome.as_ref().err().map(String::as_str)
    }
}
