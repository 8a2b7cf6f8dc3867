//! What became of a case by a method: typed, until it is written into a table.

use std::fmt::Display;

use serde::{Deserialize, Serialize};
use sim::{Motion, Outcome, TorsionRegime};
use thiserror::Error;

use super::verdict::{Certified, Verdict, certified_by, verdict};
use super::wall_push::WallPush;

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

/// The sites that were found for a case in addition to those of the file.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Found {
    /// Their distances from the bit, m, from the bit up.
    pub sites: Vec<f64>,
    /// How often the case was run again.
    pub rounds: usize,
}

/// How the bit of a case turns that begins in two ways.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct ByStart {
    /// With the bit held.
    pub stuck: TorsionRegime,
    /// In smooth rotation.
    pub smooth: TorsionRegime,
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
    /// How far above the one-slip estimate of stick-slip (Eq. 74) the surface turns, rad/s, below
    /// where negative; none where there is none, or where the bit is not all that rubs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub above_limit: Option<f64>,
    /// The site that decides the lateral label, m from the bit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub site_from_bit_m: Option<f64>,
    /// The site of the greatest acceleration sideways, m from the bit, where that is measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shock_from_bit_m: Option<f64>,
    /// The hardest push into a wall, where there was one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wall_push: Option<WallPush>,
    /// How far it is from what was recorded, in the order of the comparisons; none where it does
    /// not reach that.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub misfits: Vec<Option<f64>>,
    /// What the method says of it at [`FINER`](super::FINER) times the sampling frequency, where
    /// that is to certify its label, and has an answer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub finer: Option<Verdict>,
    /// Whether the bit has the same label at surface speeds up to 10 % off, where that is to certify
    /// it and shorter steps agree with it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub agrees_nearby: Option<bool>,
    /// How the bit turns from each start of a case that begins both ways.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub by_start: Option<ByStart>,
    /// Where it was found to touch its wall, where that is looked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub found: Option<Found>,
    /// What came out, or why nothing did.
    pub outcome: Result<Outcome, Failure>,
}

impl Record {
    /// What it says of the case; nothing where it has no answer.
    pub fn verdict(&self) -> Verdict {
        let outcome = self.outcome.as_ref();
        outcome.map_or_else(|_| Verdict::default(), |it| verdict(it, self.above_limit))
    }

    /// Refuses values that are not one for each axis of the design, as no run writes them.
    ///
    /// # Errors
    /// Which case it is.
    pub fn check_values(&self, axes: usize) -> Result<(), Failure> {
        let (case, values) = (self.case, self.values.len());
        if values == axes {
            return Ok(());
        }
        Err(Failure::new(format!(
            "case {case} has {values} values, and the number of axes is {axes}"
        )))
    }

    /// Of a case without an answer.
    pub fn failed(case: usize, method: usize, values: Vec<f64>, reason: Failure) -> Self {
        Self {
            case,
            method,
            values,
            torque_dynamic_nm: None,
            above_limit: None,
            site_from_bit_m: None,
            shock_from_bit_m: None,
            wall_push: None,
            misfits: Vec::new(),
            finer: None,
            agrees_nearby: None,
            by_start: None,
            found: None,
            outcome: Err(reason),
        }
    }
}

/// What is certain of a case by the records of the methods at two places: each has one verdict
/// and one by shorter steps, and one that is missing certifies nothing; nor does a label of the bit
/// that changes at nearby speeds.
pub fn certified(case: &[Record], places: [usize; 2]) -> Certified {
    let records = places.map(|place| case.iter().find(|record| record.method == place));
    let verdicts = records.map(|record| {
        let verdict = record.map(Record::verdict).unwrap_or_default();
        let finer = record.and_then(|record| record.finer).unwrap_or_default();
        [verdict, finer]
    });
    let mut certified = certified_by(verdicts.as_flattened());
    let changes = |record: &Record| record.agrees_nearby == Some(false);
    if records.into_iter().flatten().any(changes) {
        certified.labels[Motion::Torsion] = None;
    }
    certified
}

#[cfg(test)]
mod tests {
    use sim::Ended;

    use super::super::verdict::MotionVerdict;
    use super::*;

    const SMOOTH: TorsionRegime = TorsionRegime::Smooth;

    /// A record of a method that drills smoothly at 5 and, by shorter steps, 5.5 rad/s above
    /// the limit.
    fn record(method: usize) -> Record {
        let outcome = serde_json::json!({
            "simulated": 9.0,
            "ended": Ended::End,
            "torsion": {
                "regime": SMOOTH,
                "first_slip": 1.0,
                "sticks": 0,
                "peak_speed": 9.0,
                "closing_speed": 6.0,
            },
        });
        Record {
            above_limit: Some(5.0),
            finer: Some(Verdict::only(
                Motion::Torsion,
                MotionVerdict::Torsion {
                    regime: SMOOTH,
                    above_limit: Some(5.5),
                },
            )),
            outcome: Ok(serde_json::from_value(outcome).unwrap()),
            ..Record::failed(3, method, Vec::new(), Failure::new(""))
        }
    }

    #[test]
    fn a_case_is_certain_by_both_methods_and_both_frequencies() {
        let all = [record(0), record(1), record(2)];
        let found = certified(&all, [0, 2]).labels[Motion::Torsion];
        assert_eq!(found, Some(SMOOTH.into()));
        // What the other method says does not matter; what one of the two lacks does.
        let without_other = [record(0), record(2)];
        assert_eq!(
            certified(&without_other, [0, 2]).labels[Motion::Torsion],
            found
        );
        assert_eq!(certified(&all[..2], [0, 2]).labels[Motion::Torsion], None);
        let mut lacking = all.clone();
        lacking[2].finer = None;
        assert_eq!(certified(&lacking, [0, 2]).labels[Motion::Torsion], None);
        lacking[2] = record(2);
        lacking[0].agrees_nearby = Some(true);
        assert_eq!(certified(&lacking, [0, 2]).labels[Motion::Torsion], found);
        lacking[0].agrees_nearby = Some(false);
        assert_eq!(certified(&lacking, [0, 2]).labels[Motion::Torsion], None);
        lacking[0].agrees_nearby = None;
        lacking[2] = Record::failed(3, 2, Vec::new(), Failure::new("why"));
        assert_eq!(certified(&lacking, [0, 2]).labels[Motion::Torsion], None);
    }
}
