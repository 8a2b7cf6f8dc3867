//! What was chosen for the accuracy that a sweep asks for.

use serde::{Deserialize, Serialize};

use crate::sweep_file::{Accuracy, Source, SweepFileError, per_cent};
use crate::words::{short, wrapped};

/// Errors this small drown in the settling of motions, and ones so large mean
/// nothing.
const LEAST: f64 = 1e-4;
const MOST: f64 = 0.5;

/// Refuses an accuracy that none could be chosen for.
///
/// # Errors
/// Where it is that.
pub fn check(source: &Source, accuracy: Accuracy) -> Result<(), SweepFileError> {
    let message = format!(
        "{accuracy} is not between {} and {}; write \"1 %\" or 0.01 for one per cent",
        Accuracy(LEAST),
        Accuracy(MOST)
    );
    source.refuse_if(!(LEAST..=MOST).contains(&accuracy.0), "accuracy", message)
}

/// What was chosen, and why: `accuracy` of the manifest. Errors are parts of one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Choice {
    /// The largest error wanted.
    pub asked: f64,
    /// The estimated error, the reference's uncertainty included.
    pub delivered: f64,
    /// What was chosen.
    pub chosen: Candidate,
    /// Islands of the other regime beyond the limits, by what was chosen; none where no limit is
    /// known, or where a bit cuts.
    #[serde(default)]
    pub islands: Option<Islands>,
    /// The method of the reference.
    pub reference_method: String,
    /// Its sampling frequency, Hz.
    pub reference_hz: f64,
    /// By how much its answers may be wrong: their change from half and a quarter of that
    /// frequency, and what its linear responses are off from the exact ones.
    pub reference_uncertainty: f64,
    /// The method of another family whose answers counted in that too; none where its
    /// linear responses are not near enough to the exact ones for its answers to tell
    /// anything.
    #[serde(default)]
    pub reference_seconded_by: Option<String>,
    /// Cases that were simulated to compare.
    pub probes: Vec<usize>,
    /// Everything tried, the chosen last.
    pub tried: Vec<Tried>,
}

/// A method at a sampling frequency.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Candidate {
    /// Its name.
    pub method: String,
    /// Elements in one cell, of finite elements.
    pub elements_per_cell: Option<usize>,
    /// Sampling frequency, Hz.
    pub sampling_frequency_hz: f64,
}

/// Labels of cases near the limits, further from them than the accuracy asked for and within 30 %,
/// that are those of the other side: where there are any, a limit is ragged.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Islands {
    /// Labels examined.
    pub labels: usize,
    /// How many of them are those of the other side.
    pub others: usize,
    /// How far from its limit the furthest of those is, a part of it; 0 without any.
    pub furthest: f64,
}

/// A candidate and its error.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Tried {
    /// The candidate.
    #[serde(flatten)]
    pub candidate: Candidate,
    /// Its error from the reference, where it is known.
    pub error: Option<f64>,
    /// What the error is of, or why there is none.
    pub of: String,
}

impl std::fmt::Display for Candidate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.method)?;
        if let Some(elements) = self.elements_per_cell {
            write!(f, " ({elements} elements a cell)")?;
        }
        write!(f, " at {} Hz", short(self.sampling_frequency_hz))
    }
}

impl Choice {
    /// What was chosen and by which reference, in lines for people.
    pub fn lines(&self, indent: usize) -> String {
        let chosen = format!(
            "accuracy {} %: {}, estimated error {} %",
            per_cent(self.asked),
            self.chosen,
            per_cent(self.delivered)
        );
        let second = (self.reference_seconded_by.as_ref())
            .map_or_else(String::new, |method| format!(", {method} included"));
        let reference = format!(
            "(reference: {} at {} Hz, uncertain by {} %{second})",
            self.reference_method,
            short(self.reference_hz),
            per_cent(self.reference_uncertainty)
        );
        let later = indent + 2;
        let islands = self
            .islands
            .as_ref()
            .map(|islands| islands.words(self.asked));
        let mut text = wrapped(&chosen, indent, later) + &wrapped(&reference, later, later);
        if let Some(islands) = islands {
            text += &wrapped(&islands, later, later);
        }
        text
    }
}

impl Islands {
    /// How far the limit is ragged, or what was examined.
    fn words(&self, asked: f64) -> String {
        let Self { labels, others, .. } = self;
        let asked = per_cent(asked);
        match others {
            0 => format!(
                "(none of {labels} labels further than {asked} % from a limit is that of its other \
                 side; what lies between them is not seen)"
            ),
            _ => format!(
                "a limit is ragged: labels further than {asked} % from one are those of its other side \
                 in {others} of {labels} places, up to {} % from it",
                per_cent(self.furthest)
            ),
        }
    }
}
